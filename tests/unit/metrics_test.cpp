#include "skydrop/accuracy/metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "skydrop/core/error.h"

namespace skydrop::accuracy {
namespace {

double measured(const char* name, const Observation& a, const Observation& r) {
  const Metric* metric = findMetric(name);
  EXPECT_NE(metric, nullptr) << name;
  requireMeasurable(*metric, a, r);
  return metric->measure(a, r);
}

Observation valuesOf(std::vector<double> values) {
  Observation o;
  o.values = std::move(values);
  return o;
}

TEST(Metrics, ofValuesFollowTheirDefinitions) {
  // Differences 1, 0, 0, -3 against a mean magnitude of 2.
  const Observation r = valuesOf({1, 2, -2, 3}), a = valuesOf({2, 2, -2, 0});
  EXPECT_DOUBLE_EQ(measured("bias", a, r), -2.0 / 4 / 2);
  EXPECT_DOUBLE_EQ(measured("relativeRmse", a, r), std::sqrt(10.0 / 4) / 2);
  EXPECT_DOUBLE_EQ(measured("rmse", a, r), std::sqrt(10.0 / 4));
  EXPECT_DOUBLE_EQ(measured("largest", a, r), 1.5);
  EXPECT_DOUBLE_EQ(measured("worst", a, r), 3);
  EXPECT_DOUBLE_EQ(measured("p99", a, r), 1.5);
  EXPECT_EQ(measured("worst", r, r), 0);
}

TEST(Metrics, the99thPercentileLeavesOutOneInAHundred) {
  std::vector<double> ones(200, 1), off = ones;
  off[7] = 100;
  off[8] = 50;
  off[9] = 1.5;
  EXPECT_DOUBLE_EQ(measured("p99", valuesOf(off), valuesOf(ones)), 0.5);
  EXPECT_DOUBLE_EQ(measured("largest", valuesOf(off), valuesOf(ones)), 99);
}

TEST(Metrics, ofMotionAreMetresDegreesAndShares) {
  Observation r, a;
  r.positions = {{0, 0, 0}, {1, 0, 0}};
  a.positions = {{0, 3, 4}, {1, 0, 1}};
  EXPECT_DOUBLE_EQ(measured("metres", a, r), 5);
  r.attitudes = {{1, 0, 0, 0}};
  const double half = glm::radians(1e-6) / 2;
  a.attitudes = {{-std::cos(half), 0, -std::sin(half), 0}};  // the other sign is the same attitude
  EXPECT_NEAR(measured("degrees", a, r), 1e-6, 1e-15);
  r.energies = {4, 0};
  a.energies = {5, 0.1};
  EXPECT_DOUBLE_EQ(measured("relativeEnergy", a, r), 0.25);
  r.directions = {{0, 1, 0}, {0, 1, 0}};
  a.directions = {{0, 1, 0}, {1, 0, 0}};
  EXPECT_NEAR(measured("directionDegrees", a, r), 90 / std::sqrt(2.0), 1e-12);
}

TEST(Metrics, whatAnObservationDoesNotHoldIsRefusedByName) {
  const Observation values = valuesOf({1, 2});
  const auto refusal = [&](const char* name, const Observation& a, const Observation& r) -> std::string {
    try {
      requireMeasurable(*findMetric(name), a, r);
      return "";
    } catch (const core::RangeError& error) {
      return error.what();
    }
  };
  EXPECT_EQ(refusal("metres", values, values),
            "the metric metres needs positions, which this subject does not give");
  EXPECT_EQ(refusal("rmse", values, valuesOf({1})),
            "the metric rmse compares what has not the reference's shape");
  EXPECT_EQ(findMetric("rmsee"), nullptr);
}

TEST(Observation, whatIsNotFiniteIsNamed) {
  Observation o = valuesOf({0, 0, 0, 0, std::numeric_limits<double>::quiet_NaN(), 0});
  EXPECT_EQ(notFiniteAt(o), "value 4 is not finite");
  o.width = 2, o.height = 1;
  EXPECT_EQ(notFiniteAt(o), "the value of pixel (1, 0) is not finite");
  o.values[4] = 1;
  EXPECT_EQ(notFiniteAt(o), "");
  o.positions = {{0, std::numeric_limits<double>::infinity(), 0}};
  EXPECT_EQ(notFiniteAt(o), "a position is not finite");
}

}  // namespace
}  // namespace skydrop::accuracy
