// Numerically hard cases of clouds of ice (W30 to W37).
#include "skydrop/clouds/ice_clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "skydrop/core/error.h"
#include "skydrop/core/settings_table.h"
#include "skydrop/core/shared_ice.h"
#include "skydrop/core/wind.h"
#include "skydrop/game/flown_clouds.h"
#include "skydrop/game/ice_layers.h"
#include "skydrop/weather/weather_settings.h"
#include "support/margin.h"
#include "support/refusal.h"

namespace skydrop::clouds {
namespace {

namespace f32 = core::shared::f32;
namespace f64 = core::shared::f64;

constexpr IceGenus kGenera[] = {IceGenus::cirrus, IceGenus::cirrostratus, IceGenus::cirrocumulus};

IceLayer layerOf(IceGenus genus, double cover = 0.5) {
  IceCloudSettings settings;
  settings.genus = genus;
  settings.cover = cover;
  return iceLayerOf(settings);
}

// Of 400 places over 200 km.
template <class Ask>
double meanOver(const Ask& ask) {
  double sum = 0;
  for (int i = 0; i < 400; ++i) sum += ask(glm::dvec2(i % 20 * 10037.0, i / 20 * 9973.0));
  return sum / 400;
}

TEST(Stability, W30_coverFromNothingToAllGrowsWithoutGapsAndIsItsShareOfTheSky) {
  // Cover 0 has no ice anywhere; the share of the sky with an upright depth above a tenth of the mean grows
  // with cover, and at cover 1 is most of it (cirrus and cirrocumulus keep gaps between strands and grains).
  for (const IceGenus genus : kGenera) {
    double before = -1;
    for (const double cover : {0.0, 0.1, 0.25, 0.5, 0.75, 0.9, 1.0}) {
      const IceField field(layerOf(genus, cover), {0, 0});
      const IceLayer& layer = field.layer();
      double cloudy = 0;
      const double share = meanOver([&](const glm::dvec2& xz) {
        const double depth = field.depthAbove({xz.x, 0, xz.y}, 16);
        EXPECT_TRUE(std::isfinite(depth) && depth >= 0 && depth < 12 * layer.opticalDepth) << depth;
        if (depth <= 0.1 * layer.opticalDepth) return 0.0;
        cloudy += depth / layer.opticalDepth / 400;
        return 1.0;
      });
      EXPECT_GE(share, before) << kIceGenusNames[static_cast<std::size_t>(genus)] << ' ' << cover;
      if (cover == 0) {
        EXPECT_EQ(share, 0);
      }
      if (cover == 1) {
        EXPECT_GT(share, genus == IceGenus::cirrostratus ? 0.98 : 0.5);
        EXPECT_TRUE(test::holds("W30", test::apart(cloudy / share, 1), test::atMost(0.2), "relative"))
            << "the mean optical depth of what is cloud";
      }
      before = share;
    }
  }
}

TEST(Stability, W31_anEyeOnTheLevelsSeesAStretchThatDoesNotJump) {
  // A millimetre above and below base and top, rays from straight down to straight up but those within .05
  // degrees of level: the stretch in the layer changes by less than a metre and a thousandth, and floats give
  // that of doubles as well. (Of two stretches of a ray that dips below the base the farther one was lost.)
  const IceLayer layer = layerOf(IceGenus::cirrus);
  for (const double level : {layer.baseM, layer.topM}) {
    for (int i = -900; i <= 900; ++i) {
      if (i == 0) continue;
      const double e = i * 0.1 * std::numbers::pi / 180;
      const glm::dvec3 ray(std::cos(e), std::sin(e), 0);
      double lengths[2] = {};
      for (const int side : {0, 1}) {
        const double eye = level + (side ? 1e-3 : -1e-3);
        const f64::IceStretch span = f64::iceStretch(eye - layer.baseM, eye - layer.topM, eye, ray);
        ASSERT_TRUE(std::isfinite(span.begin) && std::isfinite(span.end));
        lengths[side] = std::max(span.end - span.begin, 0.0);
        const f32::IceStretch inFloat =
            f32::iceStretch(static_cast<float>(eye - layer.baseM), static_cast<float>(eye - layer.topM),
                            static_cast<float>(eye), glm::vec3(ray));
        EXPECT_TRUE(test::holds("W31", test::apart(std::max(inFloat.end - inFloat.begin, 0.f), lengths[side]),
                                test::atMost(1 + 1e-3 * lengths[side]), "m"))
            << i << ' ' << level;
      }
      EXPECT_TRUE(
          test::holds("W31", test::apart(lengths[0], lengths[1]), test::atMost(1 + 1e-3 * lengths[0]), "m"))
          << i << ' ' << level;
    }
  }
}

TEST(Stability, W32_zenithAndHorizonMeetTheShellWhereTheSphereDoes) {
  // Straight up the stretch is the thickness; a level ray from the sea meets the shell within .3 % of where
  // it meets the sphere, and from above the layer a ray over its horizon meets nothing.
  const IceLayer layer = layerOf(IceGenus::cirrus);
  const f64::IceStretch up = f64::iceStretch(-layer.baseM, -layer.topM, 0.0, {0, 1, 0});
  EXPECT_TRUE(test::holds("W32", test::apart(up.begin, layer.baseM), test::atMost(1e-3), "m"));
  EXPECT_TRUE(test::holds("W32", test::apart(up.end, layer.topM), test::atMost(1e-3), "m"));
  const f64::IceStretch level = f64::iceStretch(-layer.baseM, -layer.topM, 0.0, {1, 0, 0});
  const double r = f64::kEarthRadius;
  EXPECT_TRUE(test::holds("W32",
                          test::apart(level.begin, std::sqrt((r + layer.baseM) * (r + layer.baseM) - r * r)),
                          test::atMost(0.003 * level.begin), "m"));
  EXPECT_TRUE(test::holds("W32",
                          test::apart(level.end, std::sqrt((r + layer.topM) * (r + layer.topM) - r * r)),
                          test::atMost(0.003 * level.end), "m"));
  const double above = 2000, dip = std::sqrt(2 * above / r);
  for (const double tilt : {-0.002, 0.002}) {
    const double e = tilt - dip;
    const f64::IceStretch span = f64::iceStretch(layer.topM + above - layer.baseM, above, layer.topM + above,
                                                 {std::cos(e), std::sin(e), 0});
    EXPECT_EQ(span.end > span.begin, tilt < 0) << tilt;
  }
  const f64::IceStretch down =
      f64::iceStretch(-layer.baseM, -layer.topM, 2.0, {0.99, -std::sqrt(1 - 0.9801), 0});
  EXPECT_LE(down.end, down.begin) << "ice behind the earth";
}

TEST(Stability, W33_aBillionMetresOutTheIceIsThatOfTheOriginShifted) {
  // A layer carried there has the bits of the one that stayed; and there a metre still makes a difference as
  // it does here: 1 m steps change the density, by less than .06.
  for (const IceGenus genus : kGenera) {
    const IceLayer layer = layerOf(genus, 1);
    const IceField here(layer, {0, 0}), there(layer, {1e9, -1e9});
    int differ = 0, cloudy = 0;
    for (int i = 0; i < 600; ++i) {
      const glm::dvec3 at(4000.0 + 137 * i, layer.topM - 40, 250 + 211 * i), far(1e9, 0, 0);
      EXPECT_TRUE(test::holds("W33",
                              test::apart(there.density(at + glm::dvec3(1e9, 0, -1e9)), here.density(at)),
                              test::atMost(1e-6), "density"));
      const double one = here.density(at + far), next = here.density(at + far + glm::dvec3(1, 0, 0));
      EXPECT_TRUE(test::holds("W33", test::apart(one, next), test::atMost(0.06), "density"));
      if (one > 0) ++cloudy;
      if (one != next) ++differ;
    }
    EXPECT_GT(cloudy, 100);
    EXPECT_GE(differ, cloudy * 3 / 4) << "terraces";  // grains are even inside
  }
}

TEST(Stability, W34_aMonthOfDriftLeavesFloatsWhatDoublesHave) {
  // After 30 days of wind: the density in floats, from the anchor that shaders are handed, is that in doubles
  // within 2e-3, out to 300 km from the eye where it counts (within 20 km for the finest grains).
  const core::WindSettings wind{.speed = 31, .direction = 77};
  for (const IceGenus genus : kGenera) {
    const IceLayer layer = layerOf(genus, 0.9);
    const IceField field(layer, core::windDrift(wind, 30 * 86400.0));
    const IceAnchor eye = field.anchor({123.4, -567.8});
    const f32::IcePlace anchor = f32::make_icePlace(eye.cell, glm::vec2(eye.inside));
    const f32::IceForm form{static_cast<float>(layer.trailM), static_cast<float>(layer.hookM),
                            static_cast<float>(field.threshold())};
    const double reach = genus == IceGenus::cirrocumulus ? 20'000 : 300'000;
    double worst = 0;
    for (int i = 0; i < 400; ++i) {
      const double turn = i * 0.37, far = reach * i / 400;
      const glm::dvec2 by(far * std::cos(turn), far * std::sin(turn));
      const glm::dvec2 inAxes(layer.along.x * by.x + layer.along.y * by.y,
                              layer.along.x * by.y - layer.along.y * by.x);
      const double y = layer.baseM + (i % 10 + 0.5) / 10 * (layer.topM - layer.baseM);
      const auto depth = static_cast<float>((layer.topM - y) / (layer.topM - layer.baseM));
      const f32::IcePlace place = f32::iceMoved(anchor, glm::vec2(inAxes));
      const glm::vec2 none(0);
      const float density = genus == IceGenus::cirrus ? f32::cirrusDensity(place, form, depth, none)
                            : genus == IceGenus::cirrostratus
                                ? f32::cirrostratusDensity(place, form, depth, none)
                                : f32::cirrocumulusDensity(place, form, depth, none);
      worst = std::max(worst, std::abs(double{density} - field.density({123.4 + by.x, y, -567.8 + by.y})));
    }
    EXPECT_TRUE(test::holds("W34", worst, test::below(6e-3), "of 1"))
        << kIceGenusNames[static_cast<std::size_t>(genus)];
  }
}

TEST(Stability, W35_thePhaseFunctionIsFiniteAtTheSunAndScattersAllLight) {
  // Its integral over the sphere is 1 within 1e-4, its mean cosine .65 within .01; straight ahead and back it
  // is finite in floats, and small enough for a half float times a sun of 4000.
  double forward = 0;
  constexpr int kParts = 200'000;
  for (int i = 0; i < kParts; ++i) {
    const double cosine = 1 - 2 * (i + 0.5) / kParts;
    const double part = f64::icePhase(cosine) * 4 * std::numbers::pi / kParts;
    forward += part * cosine;
  }
  EXPECT_TRUE(test::holdsLive("W35"));
  EXPECT_TRUE(test::holds("W35", test::apart(forward, 0.65), test::atMost(0.01), "of 1"));
  for (const float cosine : {-1.f, 0.f, 1.f, 1.0000001f, -1.0000001f}) {
    EXPECT_TRUE(std::isfinite(f32::icePhase(cosine)) && f32::icePhase(cosine) > 0) << cosine;
    EXPECT_LT(f32::icePhase(cosine), 16.4f);
  }
  for (const double depth : {0.0, 1e-9, 1.0, 1e9})
    EXPECT_LE(f64::iceSunLeft(depth) + f64::iceSpread(depth), 1) << depth;
}

TEST(Stability, W36_aCalmHasStraightStreaksAndAnyWindFiniteOnes) {
  // No shear, hardly any, and a hurricane's: unit axis, streaks within their bounds; the weather's layers
  // too, with all winds at 0.
  IceLayer layer = layerOf(IceGenus::cirrus);
  for (const double speed : {0.0, 1e-30, 1e-3, 5.0, 1e3}) {
    for (const glm::dvec2& other : {glm::dvec2(0), glm::dvec2(3, 4)}) {
      setStreaks(layer, {speed, -speed}, speed, other);
      EXPECT_TRUE(test::holds("W36",
                              test::apart(layer.along.x * layer.along.x + layer.along.y * layer.along.y, 1),
                              test::atMost(1e-12), "of length 1"));
      EXPECT_GT(layer.trailM, 0);
      EXPECT_LE(layer.trailM, 20'000);
      EXPECT_LE(std::abs(layer.hookM), layer.trailM);
    }
  }
  weather::Wind calm;
  for (int i = 0; i < 3; ++i) calm.levels[static_cast<std::size_t>(i)] = {1500.0 + 4000 * i, 0, 0};
  const auto ice = game::iceLayerOf({weather::Genus::cirrus, 8000, 9500, 0.6, 1}, calm);
  ASSERT_TRUE(ice);
  EXPECT_EQ(ice->along, glm::dvec2(1, 0));
  EXPECT_FALSE(game::iceLayerOf({weather::Genus::cumulus, 1000, 2000, 0.6, 1}, calm));
}

TEST(Stability, W37_badInputIsRefusedAndWhatFliesMeetsTheIceThatIsDrawn) {
  // Rows out of range and not numbers are refused by name; and the density that flight asks is that of the
  // picture's medium, the same with noise and without.
  test::noFaults("W37", "inputs accepted");
  IceCloudSettings settings;
  const core::SettingsTable table(settings);
  for (const char* bad :
       {"cover=1.5", "cover=nan", "opticalDepth=-1", "thickness=0", "samples=0", "genus=cumulus"}) {
    const std::string why = test::refusalOf<core::RangeError>([&] { core::setField(table, bad); });
    EXPECT_EQ(why.substr(0, why.find(':')), std::string(bad).substr(0, std::string(bad).find('='))) << why;
  }
  EXPECT_EQ(settings, IceCloudSettings());
  const weather::WeatherSettings weather;
  const weather::Wind wind = game::iceWindOf(weather);
  const core::WindSettings drift{.speed = 9, .direction = 20};
  const weather::Layer layer{weather::Genus::cirrus, 8000, 9500, 0.9, 1.2};
  const IceField drawn(*game::iceLayerOf(layer, wind), core::windDrift(drift, 77));
  const game::FlownClouds flown(nullptr, drift, wind);
  double most = 0;
  for (int i = 0; i < 500; ++i) {
    const glm::dvec3 at(i * 211.0, 8000 + i * 3, i * 97.0);
    const double density = flown.density(layer, at, 77);
    EXPECT_EQ(density, std::min(drawn.density(at), 1.0));
    most = std::max(most, density);
  }
  EXPECT_GT(most, 0.1);
}

}  // namespace
}  // namespace skydrop::clouds
