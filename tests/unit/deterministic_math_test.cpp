#include "skydrop/core/deterministic_math.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "skydrop/core/hash.h"

namespace skydrop::core {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

// Distance in units of the last place of the true value (of the smallest normal number below it).
double ulpsOff(double value, long double truth) {
  const double rounded = static_cast<double>(truth);
  int exponent = 0;
  std::frexp(rounded, &exponent);
  const long double ulp = std::ldexp(1.0L, std::max(exponent - 53, -1074));
  return static_cast<double>(std::fabs(static_cast<long double>(value) - truth) / ulp);
}

// The worst error over 200 000 arguments that `draw` makes from uniform numbers. The reference is long double
// libm (64-bit mantissa: its own error is below 0.001 ulp of a double).
double worst(const std::function<double(double)>& f, const std::function<long double(long double)>& truth,
             const std::function<double(RandomStream&)>& draw) {
  RandomStream stream{42, 0};
  double most = 0;
  for (int i = 0; i < 200000; ++i) {
    const double x = draw(stream);
    most = std::max(most, ulpsOff(f(x), truth(x)));
  }
  return most;
}

auto uniform(double low, double high) {
  return [=](RandomStream& s) { return low + (high - low) * s.nextUnit(); };
}
auto anyMagnitude(double lowExponent, double highExponent, bool bothSigns) {
  return [=](RandomStream& s) {
    const double e = lowExponent + (highExponent - lowExponent) * s.nextUnit();
    const double m = std::ldexp(1 + s.nextUnit(), static_cast<int>(std::floor(e)));
    return bothSigns && (s.next() & 1) ? -m : m;
  };
}

TEST(DeterministicMath, sineAndCosineAreWithinOneUlpForAnyFiniteAngle) {
  // The reduction of the argument keeps full precision for small, medium and astronomically large angles.
  const auto sinL = [](long double x) { return sinl(x); };
  const auto cosL = [](long double x) { return cosl(x); };
  for (const auto& draw : {std::function<double(RandomStream&)>(uniform(-7, 7)),
                           std::function<double(RandomStream&)>(uniform(-1e6, 1e6)),
                           std::function<double(RandomStream&)>(anyMagnitude(-40, 62, true))}) {
    EXPECT_LT(worst(dmath::sin, sinL, draw), 1);
    EXPECT_LT(worst(dmath::cos, cosL, draw), 1);
  }
}

TEST(DeterministicMath, tangentIsWithinTwoAndAHalfUlp) {
  EXPECT_LT(worst(
                dmath::tan, [](long double x) { return tanl(x); }, uniform(-7, 7)),
            2.5);
  EXPECT_LT(worst(
                dmath::tan, [](long double x) { return tanl(x); }, anyMagnitude(-40, 62, true)),
            2.5);
}

TEST(DeterministicMath, hugeAnglesAgreeWithValuesOfArbitraryPrecision) {
  // Where x87 references end (2^63): values by mpmath with 1200 bits.
  EXPECT_EQ(dmath::sin(1e22), -0.8522008497671888);
  EXPECT_EQ(dmath::cos(1e22), 0.523214785395139);
  EXPECT_EQ(dmath::sin(1.7976931348623157e308), 0.004961954789184062);
  EXPECT_EQ(dmath::cos(1.7976931348623157e308), -0.9999876894265599);
  // The double nearest to a multiple of pi/2 relative to its size (Muller 2006): the hardest reduction.
  EXPECT_EQ(dmath::cos(6381956970095103.0 * 0x1p797), -4.68716592425462761112e-19);
}

TEST(DeterministicMath, exponentialIsWithinOneUlpOverItsRange) {
  EXPECT_LT(worst(
                dmath::exp, [](long double x) { return expl(x); }, uniform(-708, 709.7)),
            1);
  EXPECT_LT(worst(
                dmath::exp, [](long double x) { return expl(x); }, anyMagnitude(-60, 1, true)),
            1);
  EXPECT_EQ(dmath::exp(0), 1);
  EXPECT_EQ(dmath::exp(710), kInf);
  EXPECT_EQ(dmath::exp(kInf), kInf);
  EXPECT_EQ(dmath::exp(-750), 0);
  EXPECT_EQ(dmath::exp(-kInf), 0);
  EXPECT_NEAR(dmath::exp(-740) / 0x1p-1074, static_cast<double>(expl(-740.0L) / 0x1p-1074L),
              1);  // denormal steps
}

TEST(DeterministicMath, logarithmIsWithinOneUlpFromDenormalsToTheLargest) {
  const auto logL = [](long double x) { return logl(x); };
  EXPECT_LT(worst(dmath::log, logL, anyMagnitude(-1074, 1023, false)), 1);
  EXPECT_LT(worst(dmath::log, logL, uniform(0.5, 2)), 1);
  EXPECT_EQ(dmath::log(1), 0);
  EXPECT_EQ(dmath::log(0), -kInf);
  EXPECT_TRUE(std::isnan(dmath::log(-1)));
}

TEST(DeterministicMath, arcTangentIsWithinTwoUlpInAllQuadrants) {
  RandomStream s{7, 0};
  double most = 0;
  const auto coordinate = anyMagnitude(-20, 20, true), any = anyMagnitude(-1020, 1020, true);
  for (int i = 0; i < 400000; ++i) {
    const auto& draw = i % 2 ? coordinate : any;
    const double y = draw(s), x = draw(s);
    most = std::max(most, ulpsOff(dmath::atan2(y, x), atan2l(y, x)));
  }
  EXPECT_LT(most, 2);
}

TEST(DeterministicMath, arcTangentFollowsTheStandardAtZerosAndInfinities) {
  for (const double y : {0.0, -0.0, 1.0, -1.0, kInf, -kInf}) {
    for (const double x : {0.0, -0.0, 1.0, -1.0, kInf, -kInf}) {
      EXPECT_EQ(dmath::atan2(y, x), std::atan2(y, x)) << y << " " << x;
      EXPECT_EQ(std::signbit(dmath::atan2(y, x)), std::signbit(std::atan2(y, x))) << y << " " << x;
    }
  }
  EXPECT_TRUE(std::isnan(dmath::atan2(std::nan(""), 1)));
}

TEST(DeterministicMath, arcSineAndArcCosineAreWithinTwoAndAHalfUlp) {
  EXPECT_LT(worst(
                dmath::asin, [](long double x) { return asinl(x); }, uniform(-1, 1)),
            2.5);
  EXPECT_LT(worst(
                dmath::acos, [](long double x) { return acosl(x); }, uniform(-1, 1)),
            2.5);
  EXPECT_EQ(dmath::asin(1), dmath::kHalfPi);
  EXPECT_EQ(dmath::acos(-1), dmath::kPi);
  EXPECT_EQ(dmath::acos(1), 0);
  EXPECT_TRUE(std::isnan(dmath::asin(1.0000001)));
}

TEST(DeterministicMath, powerKeepsItsStatedErrorAndTheStandardsSpecialCases) {
  RandomStream s{9, 0};
  double moderate = 0, extreme = 0;
  for (int i = 0; i < 200000; ++i) {
    const double x = 10 * s.nextUnit() + 1e-3, y = 8 * s.nextUnit() - 4;
    moderate = std::max(moderate, ulpsOff(dmath::pow(x, y), powl(x, y)));
    const double big = std::ldexp(1 + s.nextUnit(), 100), e = 10.1 * s.nextUnit() - 5;
    extreme = std::max(extreme, ulpsOff(dmath::pow(big, e), powl(big, e)));
  }
  EXPECT_LT(moderate, 2);
  EXPECT_LT(extreme, 16);
  for (const double x : {0.0, -0.0, 1.0, -1.0, 2.0, -2.0, 0.5, kInf, -kInf}) {
    for (const double y : {0.0, 1.0, -1.0, 2.0, 3.0, -3.0, 0.5, kInf, -kInf}) {
      const double expected = std::pow(x, y), got = dmath::pow(x, y);
      EXPECT_TRUE(got == expected || (std::isnan(got) && std::isnan(expected)))
          << x << "^" << y << " = " << got;
    }
  }
}

TEST(DeterministicMath, everyBitIsPinned) {
  // A digest of 100 000 results per function: it changes only when the functions themselves do, on no
  // machine.
  RandomStream s{1, 0};
  StateHasher hash;
  for (int i = 0; i < 100000; ++i) {
    const double a = 2000 * s.nextUnit() - 1000, b = s.nextUnit(), c = 20 * s.nextUnit() - 10;
    hash.add(dmath::sin(a)), hash.add(dmath::cos(a)), hash.add(dmath::tan(b)), hash.add(dmath::exp(c));
    hash.add(dmath::log(b + 1e-9)), hash.add(dmath::atan2(a, c)), hash.add(dmath::asin(b)),
        hash.add(dmath::acos(b));
    hash.add(dmath::pow(b + 0.5, c));
  }
  EXPECT_EQ(hash.value(), 3549323437507319756ull);
}

}  // namespace
}  // namespace skydrop::core
