// The waves of the sea near the eye: what they leave to statistics, where they are far out and late, how they
// break, and what is seen through them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "render/water/wave_set.h"
#include "skydrop/core/hash.h"
#include "skydrop/core/shared_sea.h"
#include "support/margin.h"

namespace skydrop::render {
namespace {

namespace f32 = core::shared::f32;
namespace f64 = core::shared::f64;

constexpr double kYear = 365.25 * 86400;

double turnsApart(double a, double b) { return std::abs(a - b - std::round(a - b)); }

double varianceOf(const SeaWaves& sea) {
  double sum = 0;
  for (std::size_t i = 0; i < sea.count; ++i) {
    const double slope = static_cast<double>(sea.ways[i].w);
    sum += f64::kProfileVariance * slope * slope;
  }
  return sum;
}

// The sum at a place relative to the eye, all waves shown.
f64::SeaWaveSum sumAt(const SeaWaves& sea, const glm::dvec2& relative, double footprintM, double depthM) {
  f64::SeaFootprint at;
  at.along = {1, 0};
  at.across2 = footprintM * footprintM;
  at.more2 = 0;
  f64::SeaWaveSum sum = f64::noSeaWaves();
  for (std::size_t i = 0; i < sea.count; ++i)
    sum = f64::withWave(sum, glm::dvec4(sea.ways[i]), glm::dvec4(sea.shapes[i]), relative, at, depthM);
  return sum;
}

TEST(SeaWaves, O01_wavesHaveLessSlopeThanTheSeaAtEveryWind) {
  // Waves that are drawn are part of Cox and Munk's slope, in calm and storm, at every setting: never more
  // than the share that their octaves have, and never more waves than there is room for.
  for (const std::int64_t perOctave : {2, 4, 8}) {
    for (const double shortest : {0.04, 0.16, 0.6, 8.0}) {
      WaterDetailSettings settings;
      settings.wavesPerOctave = perOctave;
      settings.shortestM = shortest;
      for (const double speed : {0.0, 1e-9, 0.4, 3.0, 8.0, 14.0, 25.0, 60.0, 1e6}) {
        const SeaWaves sea = seaWaves(settings, {100, -300}, 12, {speed * 0.6, speed * 0.8});
        const double all = 2 * sea.slope * sea.slope;
        EXPECT_TRUE(test::holds("O01", varianceOf(sea) / all, test::below(0.9), "of the slope's variance"))
            << speed << " m/s, " << shortest << " m";
        EXPECT_LT(sea.count, SeaWaves::kMost);
        for (std::size_t i = 0; i < sea.count; ++i) {
          for (int c = 0; c < 4; ++c) EXPECT_LT(std::abs(sea.ways[i][c]), 1e3f);
          EXPECT_TRUE(i == 0 || sea.shapes[i].x <= sea.shapes[i - 1].x);
        }
      }
    }
  }
  const SeaWaves breeze = seaWaves({}, {0, 0}, 0, {8, 0});
  EXPECT_NEAR(2 * breeze.slope * breeze.slope, 0.003 + 0.00512 * 8, 1e-12);
  EXPECT_GT(varianceOf(breeze) / (2 * breeze.slope * breeze.slope), 0.3) << "most is left to statistics";
  EXPECT_EQ(seaWaves({}, {0, 0}, 0, {0, 0}).count, 0u) << "a calm sea has waves";
}

TEST(SeaWaves, O02_phasesAreExactFarOutAndLate) {
  // 1e9 m out and a simulated year late a step of 0.7 m moves each phase as it does at the origin, and 1/120
  // s as it does at the start: within 1e-5 turns. (The bits of a double there are 1e-7 m and 4e-9 s.)
  double worst = 0;
  for (const glm::dvec2& far : {glm::dvec2(1e9, -1e9), glm::dvec2(-7.3e8, 2.2e8)}) {
    const SeaWaves here = seaWaves({}, {0, 0}, 0, {8, 3}),
                   there = seaWaves({}, {0.5, -0.5}, 0.0078125, {8, 3});
    const SeaWaves farHere = seaWaves({}, far, kYear, {8, 3});
    const SeaWaves farThere = seaWaves({}, far + glm::dvec2(0.5, -0.5), kYear + 0.0078125, {8, 3});
    ASSERT_GT(here.count, 20u);
    for (std::size_t i = 0; i < here.count; ++i) {
      worst = std::max(
          worst,
          turnsApart(static_cast<double>(there.ways[i].z) - static_cast<double>(here.ways[i].z),
                     static_cast<double>(farThere.ways[i].z) - static_cast<double>(farHere.ways[i].z)));
    }
  }
  EXPECT_TRUE(test::holds("O02", worst, test::below(1e-5), "turns"));
}

TEST(SeaWaves, wavesFollowTheWindAndTurnWithItWithoutJumps) {
  // They run with the wind, the longer the faster; a wind that turns by a degree changes no slope by more
  // than a tenth of the steepest wave's, and none comes at once.
  const auto at = [](double degrees) {
    const double angle = degrees / 57.29577951308232;
    return seaWaves({}, {0, 0}, 0, {9 * std::cos(angle), 9 * std::sin(angle)});
  };
  const SeaWaves sea = at(0);
  float steepest = 0;
  for (std::size_t i = 0; i < sea.count; ++i) {
    EXPECT_GT(sea.ways[i].x, 0) << "a wave runs against the wind";
    steepest = std::max(steepest, sea.ways[i].w);
  }
  for (int degrees = 0; degrees < 360; degrees += 15) {
    const SeaWaves a = at(degrees), b = at(degrees + 0.1);
    const auto slopeOf = [](const SeaWaves& s, float length) {
      for (std::size_t i = 0; i < s.count; ++i)
        if (s.shapes[i].x == length) return s.ways[i].w;
      return 0.0f;
    };
    for (std::size_t i = 0; i < b.count; ++i)
      EXPECT_NEAR(slopeOf(a, b.shapes[i].x), b.ways[i].w, 0.1f * steepest) << degrees;
  }
}

TEST(SeaWaves, O03_whitecapsCoverTheirShareHoweverFarTheyAre) {
  // Mean of the foam over many places: Monahan's share, whatever part of the waves pixels show (within 25 %:
  // a few waves have no tails of a normal distribution).
  for (const double speed : {8.0, 12.0, 18.0}) {
    const SeaWaves sea = seaWaves({}, {0, 0}, 0, {speed, 0});
    for (const double footprint : {0.01, 0.6, 2.0, 50.0}) {
      core::RandomStream random{7, 0};
      double sum = 0;
      constexpr int kPlaces = 20'000;
      for (int i = 0; i < kPlaces; ++i) {
        const glm::dvec2 place(random.nextUnit() * 5000, random.nextUnit() * 5000);
        const f64::SeaWaveSum waves = sumAt(sea, place, footprint, 1e3);
        // A normal number of twelve.
        double grain = -6;
        for (int k = 0; k < 12; ++k) grain += random.nextUnit();
        sum += f64::whitecaps(waves.breaking, waves.unbroken, grain * f64::kFoamGrain, 1, sea.threshold);
      }
      const double share = f64::whitecapShare(speed);
      std::printf("[ foam ] %.0f m/s, %.2f m: %.5f of %.5f\n", speed, footprint, sum / kPlaces, share);
      EXPECT_TRUE(test::holds("O03", std::abs(sum / kPlaces / share - 1), test::below(0.16), "of the share"));
    }
  }
}

TEST(SeaWaves, whatIsShownAndWhatIsNotAreTheWholeSlope) {
  // The variance that the sum tells is that of its slopes over many places, within 4 %; nothing is shown
  // where pixels are wide.
  const SeaWaves sea = seaWaves({}, {0, 0}, 3, {8, 0});
  core::RandomStream random{3, 0};
  double sum = 0, told = 0;
  constexpr int kPlaces = 40'000;
  for (int i = 0; i < kPlaces; ++i) {
    const f64::SeaWaveSum waves = sumAt(sea, {random.nextUnit() * 3000, random.nextUnit() * 3000}, 0.1, 1e6);
    sum += glm::dot(waves.slope, waves.slope);
    told = waves.variance;
  }
  EXPECT_NEAR(sum / kPlaces / told, 1, 0.04);
  EXPECT_EQ(sumAt(sea, {1, 2}, 100, 1e3).variance, 0);
  EXPECT_EQ(sumAt(sea, {1, 2}, 100, 1e3).unbroken, 1);
  EXPECT_LT(sumAt(sea, {1, 2}, 0.01, 0.02).left, 0.45 * told) << "waves do not die out in shallow water";
}

TEST(SeaWaves, profilesAreSinesOfParabolas) {
  double mean = 0, square = 0, worst = 0;
  constexpr int kSteps = 10'000;
  for (int i = 0; i < kSteps; ++i) {
    const double t = (i + 0.5) / kSteps * 7 - 3;
    const glm::dvec2 p = f64::waveProfile(t);
    mean += p.x / kSteps;
    square += p.x * p.x / kSteps;
    worst = std::max({worst, std::abs(p.x - std::sin(6.283185307179586 * t)),
                      std::abs(p.y - std::cos(6.283185307179586 * t))});
  }
  EXPECT_NEAR(mean, 0, 1e-4);
  EXPECT_NEAR(square, f64::kProfileVariance, 1e-4);
  EXPECT_LT(worst, 0.057);
}

TEST(SeaWaves, normalDistributionAndItsQuantileAreInverse) {
  for (double x = -5; x <= 0; x += 0.125) {
    EXPECT_NEAR(f64::normalShare(x), 0.5 * std::erfc(-x / 1.4142135623730951), 1.5e-4);
    EXPECT_NEAR(f64::normalQuantile(f64::normalShare(x)), x, 1e-6);
    EXPECT_NEAR(f32::normalQuantile(f32::normalShare(static_cast<float>(x))), static_cast<float>(x), 2e-3f);
  }
}

TEST(SeaWaves, O04_lightBendsAsSnellSays) {
  // The sine in water is that in air over the index, for tilted surfaces and level rays; unit vectors.
  core::RandomStream random{11, 0};
  double worst = 0;
  for (int i = 0; i < 20'000; ++i) {
    const glm::dvec3 ray = glm::normalize(glm::dvec3(
        random.nextUnit() - 0.5, i % 7 == 0 ? -1e-9 : -random.nextUnit(), random.nextUnit() - 0.5));
    const glm::dvec3 normal =
        glm::normalize(glm::dvec3(0.4 * (random.nextUnit() - 0.5), 1, 0.4 * (random.nextUnit() - 0.5)));
    if (glm::dot(ray, normal) >= 0) continue;
    const glm::dvec3 bent = f64::intoWater(ray, normal);
    worst = std::max(worst, std::abs(glm::length(glm::cross(bent, normal)) * f64::kIndexOfWater -
                                     glm::length(glm::cross(ray, normal))));
    EXPECT_NEAR(glm::length(bent), 1, 1e-12);
    EXPECT_LT(glm::dot(bent, normal), -0.6);
  }
  EXPECT_TRUE(test::holds("O04", worst, test::below(1e-12), "of the sine"));
  EXPECT_NEAR(f64::waterSlant(1), 1, 1e-12);
  EXPECT_NEAR(f64::waterSlant(0), 1 / std::sqrt(1 - 1 / (1.34 * 1.34)), 1e-12);
}

TEST(SeaWaves, waterAbsorbsRedFirstAndTurbidityOneIsTheOldSea) {
  // 1 is the extinction of shaders/shared/water.glsl, 0 pure water.
  const glm::dvec3 coast = f64::waterExtinction(1), pure = f64::waterExtinction(0);
  EXPECT_LT(glm::length(coast - f64::seaExtinction()), 1e-9);
  EXPECT_TRUE(pure.x > pure.y && pure.y > pure.z);
  EXPECT_NEAR(pure.x, 0.2755, 1e-12);  // at 620 nm (Pope and Fry 1997, table 3)
}

TEST(SeaWaves, causticsGatherWhatTheyTake) {
  // Of a Gaussian curvature the mean is 1 within 4 %, at each depth.
  for (const double depth : {0.0, 0.3, 1.0, 3.0, 40.0}) {
    core::RandomStream random{5, 0};
    double sum = 0;
    constexpr int kCount = 100'000;
    for (int i = 0; i < kCount; ++i) {
      double normal = -6;
      for (int k = 0; k < 12; ++k) normal += random.nextUnit();
      sum += f64::caustic(0.5 * normal, 0.25, depth, 0.7);
    }
    EXPECT_NEAR(sum / kCount, 1, 0.04) << depth;
  }
}

TEST(SeaWaves, boresRunUpTheBeach) {
  // A crest is where the phase is whole: later it is shallower. Its mean is kept where pixels do not show it.
  const auto depthOfCrest = [](double clock) {
    double best = 0, least = 1;
    for (double depth = 0.05; depth < 0.6; depth += 0.001) {
      const double phase = f64::surfPhase(depth, clock);
      const double away = turnsApart(phase, 1);
      if (away < least && std::abs(phase - 1) < 0.5) least = away, best = depth;
    }
    return best;
  };
  EXPECT_GT(depthOfCrest(0.2), depthOfCrest(0.3));
  EXPECT_GT(depthOfCrest(0.3), depthOfCrest(0.4));
  double mean = 0;
  for (int i = 0; i < 1000; ++i) mean += f64::surfFoam(0.001 * (i + 0.5), 0, 1) / 1000;
  EXPECT_NEAR(mean / f64::surfFoam(0.3, 0, 0), 1, 0.01);
  EXPECT_EQ(f64::surfFoam(0.0, f64::kSurfDepthM + 1, 1), 0);
}

}  // namespace
}  // namespace skydrop::render
