// Cases that the hunt found in shaders/shared (docs/hunt.md): the input as it was found, what the former or
// the obvious code makes of it, and what must hold. X34 on were right already; they are inputs at which the
// obvious code is not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "skydrop/core/shared.h"
#include "skydrop/core/shared_flash.h"
#include "skydrop/core/shared_glitter.h"
#include "skydrop/core/shared_lamps.h"
#include "skydrop/core/shared_optics.h"
#include "skydrop/lab/shared.h"
#include "support/margin.h"

namespace skydrop {
namespace {

namespace f32 = core::shared::f32;
namespace f64 = core::shared::f64;
using test::apart, test::atMost, test::holds;

constexpr float kLeast = std::numeric_limits<float>::denorm_min();
constexpr float kEarth = 6.371e6f;

double offBy(double actual, double expected) { return std::abs(actual / expected - 1); }

TEST(Stability, X01_anEndOfARemapIsThatEnd) {
  const float naive = 4e16f + (1e4f - 4e16f) * 1.0f;
  EXPECT_GT(offBy(naive, 1e4), 0.9) << naive;
  EXPECT_TRUE(holds("X01", offBy(f32::remapClamped(0, 0, 0, 4e16f, 1e4f), 1e4), atMost(1e-7), "relative"));
}

TEST(Stability, X02_aVectorOf1e30HasADirection) {
  const f32::Vec3 v(0, 0, -1e30f);
  EXPECT_EQ(glm::length(v / std::sqrt(glm::dot(v, v))), 0) << "the square is infinite";
  EXPECT_TRUE(holds("X02", apart(f32::directionOf(v, {0, 1, 0}).z, -1), atMost(1e-6), ""));
}

TEST(Stability, X03_aVectorOf1e25thHasADirection) {
  const f32::Vec3 v(3e-25f, 0, 4e-25f);
  EXPECT_EQ(glm::dot(v, v), 0) << "the square is none";
  EXPECT_TRUE(holds("X03", apart(f32::directionOf(v, {0, 1, 0}).x, 0.6), atMost(1e-6), ""));
}

TEST(Stability, X04_X05_theLeastDepthIsNoInfiniteDistance) {
  EXPECT_TRUE(std::isinf(1 / kLeast));
  EXPECT_TRUE(holds("X04", f32::viewZOfDepth(kLeast, 1), atMost(f32::kFarMarker), "m"));
  EXPECT_TRUE(holds("X05", f32::distanceOfDepth(3 * kLeast, 1, 10), atMost(f32::kFarMarker), "m"));
}

TEST(Stability, X06_X07_aRayOf1e30MetresEndsSomewhere) {
  const float naive = 1e30f * 1e30f / (kEarth + std::sqrt(kEarth * kEarth + 1e30f * 1e30f));
  EXPECT_TRUE(std::isnan(naive));
  EXPECT_TRUE(holds("X06", offBy(f32::shellHeightAlong(0, 0, 1e30f), f64::shellHeightAlong(0, 0, 1e30)),
                    atMost(1e-5), "relative"));
  EXPECT_TRUE(holds("X07", apart(f32::shellCosineAlong(0, 0, 1e30f), 1), atMost(1e-5), ""));
}

TEST(Stability, X09_X10_theHorizonFrom1e30MetresIsBelow) {
  const float h = 1e30f;
  EXPECT_TRUE(std::isinf(-std::sqrt(h * (2 * kEarth + h)) / (kEarth + h)));
  EXPECT_TRUE(holds("X09", apart(f32::horizonSine(h), -1), atMost(1e-6), ""));
  EXPECT_TRUE(holds("X10", apart(f32::airEndsSine(h), -1), atMost(1e-6), ""));
}

TEST(Stability, X11_theSunIsSeenFromAnyHeight) {
  // 1 - dip^2 is nothing from 1e11 m on.
  const float dip = -1, cosine = -1;
  EXPECT_TRUE(std::isnan((cosine - dip) / std::sqrt(1 - dip * dip)));
  for (const float height : {1e11f, 1e20f, 1e30f})
    EXPECT_TRUE(holds("X11", apart(f32::sunVisibleShareAt(height, 0), 1), atMost(1e-6), ""));
}

TEST(Stability, X12_theSkysTableHasARowFromAnyHeight) {
  const float horizon = f32::horizonSine(1e30f), airEnds = f32::airEndsSine(1e30f);
  EXPECT_TRUE(std::isnan((horizon - horizon) / (airEnds - horizon))) << "the horizon itself";
  for (const float sine : {-1.0f, 0.0f, 1.0f}) {
    const float row = f32::skyTableRow(sine, horizon, airEnds);
    EXPECT_TRUE(holds("X12", std::max(row - (f32::kSkyRows - 1), -row), atMost(0), "rows beyond the table"));
  }
}

TEST(Stability, X13_theTopOfTheTableOfTransmittanceIsLevel) {
  // (x, y) = (3e-7, 1): the way straight up was a difference of 100 km and 100 km.
  const double most = std::sqrt(1e5 * (2 * 6.371e6 + 1e5));
  const auto mostF = static_cast<float>(most);
  const float h = mostF * mostF / (kEarth + std::sqrt(kEarth * kEarth + mostF * mostF));
  const float shortest = 1e5f - h, length = shortest + 3e-7f * (2 * mostF - shortest);
  const float naive = ((1e5f - h) * (2 * kEarth + 1e5f + h) - length * length) / (2 * (kEarth + h) * length);
  const double exact = f64::transmittanceTablePlace({3e-7, 1}).y;
  EXPECT_GT(apart(naive, exact), 0.005) << naive;
  EXPECT_TRUE(holds("X13", apart(f32::transmittanceTablePlace({3e-7f, 1}).y, exact), atMost(1e-6), ""));
}

TEST(Stability, X14_wavesHideNoLessThanNothing) {
  const float s = 0.89f, level = std::sqrt(1 - s * s) * 0.89f * 1.41421356f;
  const float naive = (level * level - s * (1.259f * level - 0.396f * s)) / (3.535f * level + 2.181f * s);
  EXPECT_LT(naive, -1e-6f);
  EXPECT_TRUE(holds("X14", -f32::hiddenByWaves(s, s), atMost(0), "below 0"));
}

TEST(Stability, X15_aPixelWithinTheRingIsCovered) {
  // The least footprint, a millimetre, at 22 m and at 9 km, where it is one float.
  const float naive = (std::min(22 + 0.0005f, 24.0f) - std::max(22 - 0.0005f, 20.0f)) / 0.001f;
  EXPECT_GT(apart(naive, 1), 3e-4) << naive;
  for (const float distance : {22.0f, 9000.0f})
    EXPECT_TRUE(holds("X15", apart(f32::ringCoverage(distance, distance, 0), 1), atMost(1e-6), ""));
}

TEST(Stability, X16_aRayThatRisesDoesNotStayUnderALevel) {
  // It starts 4e-45 m below: 4 bend above is 0, and it was taken for a ray that never leaves.
  const float bend = f32::rayBend({0.796f, 0, -0.605f}), above = -3 * kLeast;
  EXPECT_EQ(-4 * bend * above, 0);
  const f32::RaySpan span = f32::bentRayUnder(above, 0, bend);
  EXPECT_TRUE(holds("X16", span.end - span.begin, atMost(0.001), "m"));
}

TEST(Stability, X17_X18_airBehindALightOrFarBeforeItIsHardlyLit) {
  // Two angles of opposite signs cancelled: 4 km behind the eye, and 100 km beyond the end of the ray.
  const auto naive = [](float along, float length) { return std::atan(length - along) + std::atan(along); };
  EXPECT_GT(offBy(naive(-4000, 1), std::atan(1.0 / (1 + 4001.0 * 4000))), 0.5);
  EXPECT_GT(offBy(naive(1e5f, 10), std::atan(10 / (1 + 1e5 * (1e5 - 10)))), 0.5);
  const auto glow = [](auto along, auto length) {
    using Real = decltype(length);
    if constexpr (std::is_same_v<Real, float>) {
      return f32::flashAirlight({0, 0, along}, {0, 0, 1}, length, 1);
    } else {
      return f64::flashAirlight({0, 0, along}, {0, 0, 1}, length, 1);
    }
  };
  EXPECT_TRUE(holds("X17", offBy(glow(-4000.0f, 1.0f), std::atan(1.0 / (1 + 4001.0 * 4000))), atMost(1e-5),
                    "relative"));
  EXPECT_TRUE(holds("X18", offBy(glow(1e5f, 10.0f), glow(1e5, 10.0)), atMost(1e-5), "relative"));
}

TEST(Stability, X19_theEdgeOfANarrowBeamIsNotRounded) {
  // 0.5 m aside of a beam of half a degree, 800 m away: 1 - cosine is three units of a float.
  const f64::Vec3 toLamp(0, 800, 0.5), down(0, -1, 0), up(0, 1, 0);
  const double exact = f64::spotIlluminance(toLamp, up, down, 0.01);
  const auto cosine = static_cast<float>(800 / std::sqrt(800.0 * 800 + 0.25));
  const float naive =
      f32::lampIlluminance({0, 800, 0.5f}, {0, 1, 0}) * std::exp(-0.693147f * 2 * (1 - cosine) / 1e-4f);
  EXPECT_GT(offBy(naive, exact), 1e-4) << naive;
  const float beam = f32::spotIlluminance({0, 800, 0.5f}, {0, 1, 0}, {0, -1, 0}, 0.01f);
  EXPECT_TRUE(holds("X19", offBy(beam, exact), atMost(2e-6), "relative"));
}

TEST(Stability, X20_aLevelRayThroughAThinShellIsAsLongAsItIs) {
  const float radius = kEarth / (kEarth + 1);
  EXPECT_GT(offBy(1 / std::sqrt(1 - radius * radius), 1784.8), 0.05);
  EXPECT_TRUE(holds("X20", offBy(f32::iceSlant(0, 0), f64::iceSlant(0, 0)), atMost(1e-6), "relative"));
}

TEST(Stability, X21_anAzimuthBehindIsNotTurnedByTheSignOfZero) {
  // Opposite to the light the cross product was -0, and its angle -pi: 200 degrees from the least deviation.
  EXPECT_LT(std::atan2(-0.0f, -0.99f), 0);
  const f32::Vec3 dog = f32::sunDogDegrees({-1, 1.24454551e-16f, 0}, {0.991841376f, -0.127478123f, 0});
  EXPECT_TRUE(holds("X21", std::abs(dog.x), atMost(180), "degrees"));
}

TEST(Stability, X22_aPlaceJustBelowAPeriodIsWithinIt) {
  // -2e-15 - floor(-2e-15) is 1, a cell that there is not: the noise jumped by 0.17.
  EXPECT_EQ(-2e-15f - std::floor(-2e-15f), 1);
  EXPECT_EQ(f32::fractionOf(-2e-15f), 0);
  f32::CubeCloud cloud{1, 16777216, 0.5f, 2, 0.5f, 2};
  const float below = f32::cubeNoises(cloud, {0.3f, -2e-15f, 0}).x,
              at = f32::cubeNoises(cloud, {0.3f, 0, 0}).x;
  EXPECT_TRUE(holds("X22", apart(below, at), atMost(1e-6), ""));
}

TEST(Stability, X23_glossIsNoMoreThanTheLight) {
  // A product of unit vectors that is 1 + 2e-16, to the power of 1e30.
  EXPECT_TRUE(std::isinf(std::pow(1 + 2.3e-16, 1e30)));
  const f64::Vec3 n(0, 1 + 2.3e-16, 0);
  EXPECT_TRUE(holds("X23", f64::phongLight({0, 0, 1, 1e30}, n, n, n).y, atMost(1), ""));
}

TEST(Stability, X24_aShadowRayMayBeginAtMinusZero) {
  EXPECT_LT(1 * 9.0f / -0.0f, -1e30f);
  const float light =
      f32::shadeAlong(f32::kBallScene, 0, {0, 10, 0}, {0.6f, 0.8f, 0}, -0.0f, 20, 1, 64).light;
  EXPECT_TRUE(holds("X24", std::max(-light, light - 1), atMost(0), "beyond [0, 1]"));
}

TEST(Stability, X25_theGradientAHairFromAnEdgeIsDiagonal) {
  // 1e-23 outside both faces of an edge: the square of the way is 0, and it was taken for inside.
  const f32::Vec3 outside(1e-23f, 1e-23f, 0);
  EXPECT_EQ(glm::dot(outside, outside), 0);
  EXPECT_TRUE(holds("X25", apart(f32::boxGradient(outside, {0, 0, 0}).y, std::sqrt(0.5)), atMost(1e-6), ""));
}

TEST(Stability, X26_X27_theGradientOfARingIsRightOnItAndOnItsAxis) {
  const f64::Vec3 exact = f64::torusGradient({-0.0750000030, 0, 0.00200000009}, 0.0750000030);
  const f32::Vec3 p(-0.0750000030f, 0, 0.00200000009f);
  const f32::Vec3 naive = glm::normalize(p - p * (0.0750000030f / glm::length(p)));
  EXPECT_GT(apart(naive.z, exact.z), 2e-6);
  // What is left is that of |p| itself: one rounding in 2.7e-5 m.
  EXPECT_TRUE(holds("X26", apart(glm::length(f32::torusGradient(p, 0.0750000030f)), 1), atMost(1e-6), ""));
  EXPECT_EQ(glm::length(f32::Vec3(1e-29f, 0, 0) * (0.6f / 1e-12f)) < 1e-15f, true)
      << "former code: no direction";
  EXPECT_TRUE(holds("X27", apart(f32::torusGradient({1e-29f, 0, 0}, 0.6f).x, -1), atMost(1e-6), ""));
}

TEST(Stability, X34_X35_thinAirTakesSomeOfTheLight) {
  const float x = 1e-8f;
  EXPECT_EQ((1 - std::exp(-x)) / x, 0);
  EXPECT_TRUE(holds("X34", apart(f32::oneMinusExpOverX(x), 1), atMost(1e-6), ""));
  EXPECT_TRUE(holds("X35", offBy(f32::stepOpacity(x), 1e-8), atMost(1e-6), "relative"));
}

TEST(Stability, X36_theEarthsShadowBeginsAtTheHorizon) {
  // The sun 0.06 degrees down: 1 / cos - 1 is 4 units of a float.
  const double c = -1e-3, shadow = 6.371e6 * (1 / std::sqrt(1 - c * c) - 1);
  EXPECT_GT(offBy(kEarth * (1 / std::sqrt(1 - 1e-3f * 1e-3f) - 1), shadow), 0.03);
  EXPECT_TRUE(
      holds("X36", offBy(f32::twilight(-1e-3f, 50), std::exp(-shadow / 50)), atMost(2e-6), "relative"));
}

TEST(Stability, X37_theForwardPeakIsNotRounded) {
  const float g = 0.95f, mu = 0.9999999f, base = 1 + g * g - 2 * g * mu;
  const double exact = f64::henyeyGreenstein(static_cast<double>(mu), static_cast<double>(g));
  EXPECT_GT(offBy((1 - g * g) / (12.566371f * base * std::sqrt(base)), exact), 1e-5);
  EXPECT_TRUE(holds("X37", offBy(f32::henyeyGreenstein(mu, g), exact), atMost(2e-6), "relative"));
}

TEST(Stability, X38_smallAnglesAreNotZero) {
  const f32::Vec3 a(0, 1, 0), b(1e-4f, 1, 0);
  EXPECT_EQ(std::acos(std::min(glm::dot(a, b), 1.0f)), 0);
  EXPECT_TRUE(holds("X38", offBy(f32::angleBetween(a, b), 1e-4), atMost(1e-6), "relative"));
}

TEST(Stability, X39_aLevelPathHasAnOpticalDepth) {
  const float rise = 0, scale = 1200;
  EXPECT_TRUE(std::isnan(scale * (1 - std::exp(-rise / scale)) / rise));
  const f32::Atmosphere air = f32::make_atmosphere(30000, 1200, 0.7f);
  const f64::Atmosphere exact = f64::make_atmosphere(30000, 1200, 0.7);
  EXPECT_TRUE(holds("X39",
                    offBy(f32::opticalDepthBetween(air, 500, 500, 1e4f).y,
                          f64::opticalDepthBetween(exact, 500, 500, 1e4).y),
                    atMost(2e-6), "relative"));
}

TEST(Stability, X40_aKilometreOverTheSeaIsMeasuredInCentimetres) {
  const double exact = f64::shellHeightAlong(2, 0.001, 1000);
  const float r = kEarth + 2;
  EXPECT_GT(apart(std::sqrt(r * r + 1000 * (1000 + 2 * r * 0.001f)) - kEarth, exact), 0.05);
  EXPECT_TRUE(holds("X40", apart(f32::shellHeightAlong(2, 0.001f, 1000), exact), atMost(0.001), "m"));
}

TEST(Stability, X41_theNearRootOfABentRayDoesNotCancel) {
  const double bend = f64::rayBend({0.8, 0.6, 0});
  const double exact = f64::bentRayUnder(-1, 0.6, bend).end;
  const auto b = static_cast<float>(bend);
  EXPECT_GT(offBy((-0.6f + std::sqrt(0.36f + 4 * b)) / (2 * b), exact), 0.05);
  EXPECT_TRUE(holds("X41", offBy(f32::bentRayUnder(-1, 0.6f, b).end, exact), atMost(1e-6), "relative"));
}

TEST(Stability, X42_farBelowTheCutoffASheetKeepsItsDepth) {
  // Noise 30 scales below the cutoff: log(1 + e) over a share of e, both 0 in a float's sum.
  const float e = std::exp(-30.0f);
  EXPECT_EQ(std::log(1 + e) / (e / (1 + e)), 0);
  const f32::SheetCover cover = f32::sheetCover(0, 0.0544f, 0.9f, 100);
  EXPECT_TRUE(
      holds("X42", offBy(cover.depth, f64::sheetCover(0, 0.0544, 0.9, 100).depth), atMost(1e-5), "relative"));
}

TEST(Stability, X57_fogOnALevelPathIsFogOnALevelPath) {
  const float rise = kLeast, scale = 50;
  EXPECT_TRUE(std::isnan((1 - std::exp(-rise / scale)) / (rise / scale)));
  EXPECT_TRUE(holds("X57", offBy(f32::groundFogPath(10, rise, 1000, scale), 1000 * std::exp(-0.2)),
                    atMost(2e-6), "relative"));
}

TEST(Stability, X58_aRayAlongAFaceIsWithinTheBox) {
  EXPECT_TRUE(std::isnan((1.0f - 1.0f) / 0.0f));
  const f32::RaySpan span = f32::raySpanBetween(1, 0, -1, 1);
  EXPECT_TRUE(holds("X58", apart(span.end - span.begin, 1e30f), atMost(0), "m"));
}

TEST(Stability, X59_theLevelOfDetailEndsBelowTheLast) {
  float morph[f32::kTopPatchLevel + 1];
  for (int level = 0; level <= f32::kTopPatchLevel; ++level)
    morph[level] = 200.0f * static_cast<float>(1 << level);
  EXPECT_TRUE(holds("X59", f32::lodLambda(1e30f, morph), test::below(10), "levels"));
}

}  // namespace
}  // namespace skydrop
