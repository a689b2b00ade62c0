#include "app/flight_trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace skydrop::app {
namespace {

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> out;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) out.push_back(cell);
  return out;
}

TEST(FlightTrace, namesItsColumnsAndWritesOneFullRowAStep) {
  // The first line names every column once; each row has as many numbers, and they read back as they were.
  FlightTrace trace;
  game::Snapshot snapshot;
  snapshot.simulatedSeconds = 1.0 / 120;
  snapshot.aircraft.airspeedMps = 0.1 + 0.2;
  snapshot.aircraft.bankRad = -1;
  trace.append(snapshot);
  trace.append(snapshot);
  std::istringstream text(trace.text());
  std::string head, row, more, end;
  std::getline(text, head), std::getline(text, row), std::getline(text, more);
  EXPECT_FALSE(std::getline(text, end));
  const std::vector<std::string> names = cells(head), numbers = cells(row);
  ASSERT_EQ(names.size(), numbers.size());
  for (const std::string& name : names) EXPECT_EQ(std::ranges::count(names, name), 1) << name;
  const auto value = [&](const std::string& name) {
    return std::stod(numbers.at(static_cast<std::size_t>(std::ranges::find(names, name) - names.begin())));
  };
  EXPECT_EQ(value("time_s"), 1.0 / 120);
  EXPECT_EQ(value("airspeed_mps"), 0.1 + 0.2);
  EXPECT_NEAR(value("bank_deg"), -57.29577951308232, 1e-12);
  EXPECT_EQ(row, more);
}

}  // namespace
}  // namespace skydrop::app
