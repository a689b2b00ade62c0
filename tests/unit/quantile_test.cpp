#include "skydrop/core/quantile.h"

#include <gtest/gtest.h>

#include <array>

namespace skydrop::core {
namespace {

TEST(Quantile, isTheNearestRankOfUnsortedValues) {
  // The smallest value that at least the share does not exceed; the ends are the least and the largest value.
  const std::array<double, 5> five = {3, 1, 5, 2, 4};
  EXPECT_EQ(quantileOf(five, 0), 1);
  EXPECT_EQ(quantileOf(five, 0.2), 1);
  EXPECT_EQ(quantileOf(five, 0.21), 2);
  EXPECT_EQ(quantileOf(five, 0.5), 3);
  EXPECT_EQ(quantileOf(five, 1), 5);
  const std::array<double, 4> four = {40, 10, 30, 20};
  EXPECT_EQ(quantileOf(four, 0.5), 20) << "the lower middle of an even number";
}

TEST(Quantile, ofNothingIsZeroAndOfOneValueIsThatValue) {
  EXPECT_EQ(quantileOf({}, 0.5), 0);
  const std::array<double, 1> one = {7};
  for (const double quantile : {0.0, 0.5, 1.0}) EXPECT_EQ(quantileOf(one, quantile), 7);
}

TEST(Quantile, rankStaysInsideTheValues) {
  for (std::size_t count = 1; count < 2000; ++count) {
    ASSERT_EQ(quantileRank(count, 0), 0u);
    ASSERT_EQ(quantileRank(count, 1), count - 1);
    ASSERT_LT(quantileRank(count, 0.99), count);
  }
}

}  // namespace
}  // namespace skydrop::core
