// What the tests of the hard cases (tests/stability/cases.json) measure, beside the limit that they hold it
// to.
//
//   EXPECT_TRUE(test::holds("T01", test::apart(height, truth), test::atMost(0.01), "m")) << distance;
//   test::noFaults("D13", "differences");   // in a test of yes and no
//
// Either asserts and notes: of all calls from one line the one with the least margin is kept. When the test
// ends its figures are written to build/<preset>/tests/margins (or $SKYDROP_TEST_MARGINS), a file a test,
// from which tests/margins makes docs/hard-cases.md. A test that was skipped leaves no figures. Any thread.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <source_location>
#include <string>

#include "skydrop/stability/limit.h"
#include "skydrop/stability/live_check.h"

namespace skydrop::test {

using stability::above, stability::atLeast, stability::atMost, stability::below, stability::Limit;

// |a - b|, for a limit in place of EXPECT_NEAR.
double apart(auto a, auto b) { return std::abs(static_cast<double>(a) - static_cast<double>(b)); }

// Whether `figure`, in `unit`, keeps to `limit`; NaN never does. `ids`: the rows that it stands for, as in
// the test's name, with spaces between ("C12 C16"). By how much it may grow is its margin: limit / figure
// where it may be no larger, figure / limit where it may be no smaller.
testing::AssertionResult holds(const char* ids, double figure, const Limit& limit, const char* unit,
                               const std::source_location& place = std::source_location::current());

testing::AssertionResult holds(const char* ids, auto figure, const Limit& limit, const char* unit,
                               const std::source_location& place = std::source_location::current()) {
  return holds(ids, static_cast<double>(figure), limit, unit, place);
}

// Every live check of a row, which the program makes too (skydrop accuracy stability).
testing::AssertionResult holdsLive(const char* id);

// Of rows that hold exactly or not at all: the figure is how many assertions of the running test fail, and
// none may. `what`: what a failure would be, in the plural ("differences").
void noFaults(const char* ids, const char* what);

// Where the figures of a run lie.
std::filesystem::path marginFolder();

}  // namespace skydrop::test
