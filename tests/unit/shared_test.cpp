// The shared shader functions in C++: float against double, and against what they must be.
#include "skydrop/core/shared.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <set>

#include "skydrop/core/hash.h"

namespace skydrop::core::shared {
namespace {

template <class Atmosphere>
Atmosphere clearAir() {
  using Real = decltype(Atmosphere::haze);
  Atmosphere air{};
  air.rayleigh = {Real(5.802e-6), Real(13.558e-6), Real(33.1e-6)};
  air.rayleighHeight = Real(8000);
  air.haze = Real(5e-5);
  air.hazeHeight = Real(1200);
  air.hazeAlbedo = Real(0.94);
  air.hazeAnisotropy = Real(0.76);
  return air;
}

TEST(Shared, remapWithEqualBoundsIsAStep) {
  // Between bounds linear, outside clamped, equal bounds a step; never 0/0.
  EXPECT_EQ(f64::remapClamped(0.5, 0, 1, 10, 20), 15);
  EXPECT_EQ(f64::remapClamped(-3, 0, 1, 10, 20), 10);
  EXPECT_EQ(f64::remapClamped(9, 0, 1, 10, 20), 20);
  EXPECT_EQ(f64::remapClamped(0.4, 0.5, 0.5, 10, 20), 10);
  EXPECT_EQ(f64::remapClamped(0.5, 0.5, 0.5, 10, 20), 20);
  EXPECT_EQ(f64::remapClamped(0.25, 1, 0, 0, 1), 0.75);
}

TEST(Shared, directionOfNothingIsTheFallback) {
  // A vector too short to have a direction gives the one that was asked for.
  EXPECT_EQ(f32::directionOf({0, 0, 0}, {0, 1, 0}), glm::vec3(0, 1, 0));
  EXPECT_EQ(f32::directionOf({0, 0, -4}, {0, 1, 0}), glm::vec3(0, 0, -1));
}

TEST(Shared, oneMinusExpOverXDoesNotCancel) {
  // Against expm1 from 1e-9 to 1e4: relative error under 1e-6 in float (2e-7 by the series, the rest
  // rounding).
  for (double x = 1e-9; x < 1e4; x *= 1.1) {
    const double exact = -std::expm1(-x) / x;
    EXPECT_NEAR(f64::oneMinusExpOverX(x) / exact, 1, 3e-7) << x;
    EXPECT_NEAR(static_cast<double>(f32::oneMinusExpOverX(static_cast<float>(x))) / exact, 1, 1e-6) << x;
  }
  EXPECT_EQ(f32::oneMinusExpOverX(0.0f), 1.0f);
}

TEST(Shared, hashesScatterNeighbours) {
  // 32^3 neighbouring lattice points have 32768 different hashes, uniform within 2 % of 1/2.
  std::set<std::uint64_t> seen;
  double sum = 0;
  for (std::uint32_t x = 0; x < 32; ++x) {
    for (std::uint32_t y = 0; y < 32; ++y) {
      for (std::uint32_t z = 0; z < 32; ++z) {
        const glm::u32vec3 h = f32::hash3({x, y, z});
        seen.insert(static_cast<std::uint64_t>(h.x) << 32 | h.y);
        const float unit = f32::unitOf(h.z);
        ASSERT_GE(unit, 0.0f);
        ASSERT_LT(unit, 1.0f);
        sum += static_cast<double>(unit);
      }
    }
  }
  EXPECT_EQ(seen.size(), 32768u);
  EXPECT_NEAR(sum / 32768, 0.5, 0.01);  // standard error .0016
  EXPECT_LT(f32::unitOf(0xffffffffu), 1.0f);
  EXPECT_NE(f32::hash2({1, 2}), f32::hash2({2, 1}));
  // Pictures depend on these bits.
  EXPECT_EQ(f32::hash2({1, 2}), glm::u32vec2(45825804u, 214070181u));
  EXPECT_EQ(f32::hash3({1, 2, 3}), glm::u32vec3(4204755366u, 1223881804u, 1500469937u));
}

TEST(Shared, floatSkyEqualsDoubleSky) {
  // Every direction, sun and height: float is within 3e-5 of the brightest part of the same sky (the earth's
  // shadow makes exponents of up to 100, which multiply rounding by as much), and of 1e-8 of noon's in deep
  // twilight.
  core::RandomStream random{3, 0};
  for (int i = 0; i < 20000; ++i) {
    const double height = random.nextUnit() * 8000, view = random.nextUnit(),
                 sun = random.nextUnit() * 1.4 - 0.4;
    const auto air = clearAir<f64::Atmosphere>();
    const auto airF = clearAir<f32::Atmosphere>();
    const auto exact = f64::skySource(f64::make_skyColumn(air, height, sun), air, view);
    const auto rounded =
        f32::skySource(f32::make_skyColumn(airF, static_cast<float>(height), static_cast<float>(sun)), airF,
                       static_cast<float>(view));
    const double scale = std::max(
        {exact.rayleigh.x, exact.rayleigh.y, exact.rayleigh.z, exact.haze.x, exact.haze.y, exact.haze.z});
    for (int c = 0; c < 3; ++c) {
      ASSERT_NEAR(static_cast<double>(rounded.rayleigh[c]), exact.rayleigh[c], 3e-5 * scale + 1e-10);
      ASSERT_NEAR(static_cast<double>(rounded.haze[c]), exact.haze[c], 3e-5 * scale + 1e-10);
      ASSERT_GE(rounded.rayleigh[c], 0.0f);
      ASSERT_GE(rounded.haze[c], 0.0f);
    }
  }
}

TEST(Shared, skyWithEqualAirMassesIsTheLimit) {
  // Where view and sun stand equally high the closed form is 0/0; the function passes through smoothly.
  const auto air = clearAir<f64::Atmosphere>();
  const auto at = f64::skySource(f64::make_skyColumn(air, 0, 0.3), air, 0.3);
  const auto beside = f64::skySource(f64::make_skyColumn(air, 0, 0.3 + 1e-9), air, 0.3);
  EXPECT_NEAR(at.rayleigh.y / beside.rayleigh.y, 1, 1e-7);
  EXPECT_TRUE(std::isfinite(at.rayleigh.x));
}

TEST(Shared, opticalDepthIsExactForExponentialAir) {
  // A slanted path against a sum of a million midpoints (error 1e-9), a horizontal one against its closed
  // form, both ways alike, and below the sea as at the sea.
  const auto air = clearAir<f64::Atmosphere>();
  const double a = 200, b = 3500, length = 12000;
  double sum = 0;
  constexpr int kSteps = 1000000;
  for (int i = 0; i < kSteps; ++i) {
    const double h = a + (b - a) * (i + 0.5) / kSteps;
    sum += (air.rayleigh.y * std::exp(-h / 8000) + air.haze * std::exp(-h / 1200)) * length / kSteps;
  }
  EXPECT_NEAR(f64::opticalDepthBetween(air, a, b, length).y / sum, 1, 1e-6);
  EXPECT_EQ(f64::opticalDepthBetween(air, b, a, length), f64::opticalDepthBetween(air, a, b, length));
  const double level =
      (air.rayleigh.y * std::exp(-500.0 / 8000) + air.haze * std::exp(-500.0 / 1200)) * length;
  EXPECT_NEAR(f64::opticalDepthBetween(air, 500, 500, length).y / level, 1, 1e-12);
  EXPECT_NEAR(f64::opticalDepthBetween(air, 500, 500 + 1e-6, length).y / level, 1, 1e-9);
  EXPECT_EQ(f64::opticalDepthBetween(air, -50, -50, length), f64::opticalDepthBetween(air, 0, 0, length));
  EXPECT_GT(f32::opticalDepthBetween(clearAir<f32::Atmosphere>(), 0, 0, 1e30f).x, 1e20f);
}

TEST(Shared, toneMapKeepsOrderAndEnds) {
  // Black stays black, the brightest half float is white, more light is never darker.
  EXPECT_EQ(f32::toneMap({0, 0, 0}), glm::vec3(0));
  EXPECT_EQ(f32::toneMap({65504, 65504, 65504}), glm::vec3(1));
  float before = 0;
  for (float light = 1e-4f; light < 100; light *= 1.05f) {
    const float grey = f32::toneMap({light, light, light}).y;
    EXPECT_GE(grey, before);
    before = grey;
  }
}

TEST(Shared, srgbEncodingIsTheStandards) {
  // IEC 61966-2-1 at its joint, in the middle and back again.
  EXPECT_NEAR(f64::srgbEncode1(0.0031308), 0.04045, 1e-5);
  EXPECT_NEAR(f64::srgbEncode1(0.5), 0.735356, 1e-6);
  EXPECT_NEAR(f64::srgbEncode1(1), 1, 1e-12);
  for (double x = 0; x <= 1; x += 1.0 / 64) EXPECT_NEAR(f64::srgbDecode1(f64::srgbEncode1(x)), x, 1e-7);
}

}  // namespace
}  // namespace skydrop::core::shared
