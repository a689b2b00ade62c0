// Numerically hard cases of weather, wind and turbulence.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "skydrop/core/error.h"
#include "skydrop/core/fixed_step.h"
#include "skydrop/core/guards.h"
#include "skydrop/flight/airplane.h"
#include "skydrop/game/flown_clouds.h"
#include "skydrop/game/world.h"
#include "skydrop/terrain/noise_height_source.h"
#include "skydrop/weather/dryden.h"
#include "skydrop/weather/standard_atmosphere.h"
#include "skydrop/weather/weather_settings.h"
#include "skydrop/weather/wind_profile.h"
#include "support/cloud_noise.h"
#include "support/instrumented.h"
#include "support/margin.h"
#include "support/refusal.h"

namespace skydrop {
namespace {

using weather::State;
using weather::WeatherSettings;

constexpr double kPi = std::numbers::pi;

// Windy, wet, cold and cloudy, with a second site that comes nearer.
WeatherSettings roughWeather() {
  WeatherSettings s;
  s.secondSite = true;
  s.approachSeconds = 300;
  s.variability = 1;
  s.wanderSeconds = 60;
  s.sites[0].layers[0] = {weather::Genus::cumulonimbus, 600, 9000, 0.8, 1};
  s.sites[0].rain = 10;
  s.sites[0].gust = 10;
  s.sites[0].severity = 4;
  s.sites[0].temperature = -4;
  s.sites[1] = s.sites[0];
  s.sites[1].eastM = 5000;
  s.sites[1].windDirection = 20;
  s.sites[1].windSpeed = 15;
  return s;
}

game::WorldSetup worldIn(const WeatherSettings& settings, const glm::dvec3& start) {
  static const auto land = terrain::makeNoiseHeightSource(terrain::TerrainSettings(), 1);
  game::WorldSetup setup;
  setup.ground = land;
  setup.start.position = start;
  setup.weather = {settings, core::WindSettings(), test::quickNoise()};
  return setup;
}

TEST(Stability, W01_aWindFrom350To10DegreesTurnsThroughNorth) {
  // The short way, without a jump: from 350 over 0 to 10, and halfway it blows from north with its full
  // speed.
  EXPECT_TRUE(test::holdsLive("W01"));
  for (int i = 0; i <= 1000; ++i) {
    const double at = weather::mixedDirection(350, 8, 10, 8, i / 1000.0);
    EXPECT_TRUE(at >= 350 || at <= 10) << at;
    EXPECT_GE(at, 0);
    EXPECT_LT(at, 360);
  }
  EXPECT_TRUE(test::holds("W01",
                          test::apart(std::remainder(weather::mixedDirection(350, 8, 10, 8, 0.5), 360), 0),
                          test::atMost(1e-9), "degrees"));
  EXPECT_TRUE(test::holds("W01", test::apart(weather::mixedDirection(10, 5, 350, 5, 0.25), 5),
                          test::atMost(1e-9), "degrees"));
  EXPECT_TRUE(test::holds("W01", test::apart(weather::mixedDirection(0, 5, 180, 5, 0.5), 90),
                          test::atMost(1e-9), "degrees"))
      << "as long both ways: clockwise";
  // A hair below north is north and not 360.
  EXPECT_LT(weather::mixedDirection(-1e-20, 5, -1e-20, 5, 0.5), 360);
}

TEST(Stability, W02_calmAirHasNoDirectionAndNoTurbulence) {
  // A calm takes the direction of what it turns to; no wind gives no gusts near the ground, no NaN anywhere.
  EXPECT_TRUE(test::holds("W02", test::apart(weather::mixedDirection(123, 0, 250, 9, 0.01), 250),
                          test::atMost(1e-9), "degrees"));
  EXPECT_TRUE(test::holds("W02", test::apart(weather::mixedDirection(250, 9, 123, 0, 0.99), 250),
                          test::atMost(1e-9), "degrees"));
  EXPECT_TRUE(test::holds("W02", test::apart(weather::mixedDirection(10, 0, 200, 0, 0.5), 285),
                          test::atMost(1e-9), "degrees"))
      << "two calms: halfway, the shorter way";
  weather::Wind calm;
  calm.levels = {{{1500, 0, 0}, {5500, 0, 0}, {10000, 0, 0}}};
  const weather::WindProfile profile(calm);
  for (const double height : {-100.0, 0.0, 1e-9, 10.0, 300.0, 5000.0, 1e6})
    EXPECT_EQ(profile.at(height, height), glm::dvec3(0)) << height;
  EXPECT_EQ(profile.w20Mps(), 0);
  EXPECT_EQ(weather::drydenScales(50, 0, 0).intensityMps, glm::dvec3(0));
  WeatherSettings still;
  still.variability = still.slopeWind = 0;
  for (auto& site : still.sites) {
    site.windSpeed = site.gust = site.severity = 0;
    for (auto& level : site.levels) level.speed = 0;
  }
  game::World world(worldIn(still, {0, 600, 0}));
  for (int i = 0; i < 600; ++i) world.step({});
  EXPECT_EQ(world.now().air.velocity, glm::dvec3(0));
  EXPECT_TRUE(test::holds("W02", test::apart(world.now().air.driftRad, 0), test::atMost(1e-6), "rad"));
}

TEST(Stability, W03_noCoverOnEitherSideIsNoDivision) {
  // 0/0 of cover: two layers without cover mix to one without, a layer that has cover on one side alone keeps
  // its place, and sites at one and the same place change in time alone.
  State none, some;
  none.layers[0] = {weather::Genus::stratus, 100, 200, 0, 1};
  some.layers[0] = {weather::Genus::cumulus, 1500, 3000, 0.6, 1};
  const State half = mixed(none, some, 0.5);
  EXPECT_EQ(half.layers[0].genus, weather::Genus::cumulus);
  EXPECT_EQ(half.layers[0].baseM, 1500);
  EXPECT_TRUE(test::holds("W03", test::apart(half.layers[0].cover, 0.3), test::atMost(1e-12), "of 1"));
  EXPECT_EQ(mixed(none, none, 0.3).layers[0].cover, 0);
  WeatherSettings settings = roughWeather();
  settings.sites[1].eastM = settings.sites[0].eastM;
  for (const double t : {0.0, 100.0, 1e9}) {
    const double share = weather::siteShare(settings, t, {1e9, -1e9});
    EXPECT_GE(share, 0);
    EXPECT_LE(share, 1);
  }
  settings.approachSeconds = 0;
  EXPECT_EQ(weather::siteShare(settings, 1e9, {1, 2}), 0);
  const game::FlownClouds clouds(test::quickNoise(), {});
  EXPECT_EQ(clouds.density(none, {0, 150, 0}, 0), 0);
}

TEST(Stability, W04_identicalLayersAddUpAndInvertedOnesAreRefused) {
  // Two layers at one place have the density of both, at most 1; a layer upside down, flat, of cover 1.5,
  // negative rain and a wind that is no number are refused with place and reason.
  test::noFaults("W04", "inputs accepted");
  const game::FlownClouds clouds(test::quickNoise(), {});
  State twice;
  twice.layers[0] = twice.layers[1] = {weather::Genus::stratocumulus, 1000, 3000, 0.95, 1};
  for (int i = 0; i < 500; ++i) {
    const glm::dvec3 at(i * 137.0, 1000 + i * 4, i * 71.0);
    const double one = clouds.density(twice.layers[0], at, 0);
    EXPECT_EQ(clouds.density(twice, at, 0), std::min(2 * one, 1.0));
  }
  const auto refusalOf = [](const auto& change) {
    State state = weather::stateOf({});
    change(state);
    return test::refusalOf<core::RangeError>([&] { requireUsable(state); });
  };
  EXPECT_EQ(refusalOf([](State&) {}), "");
  EXPECT_EQ(refusalOf([](State& s) { s.layers[2].topM = 100; }),
            "layers.2: the top at 100 m is not above the base at 1555 m");
  EXPECT_NE(refusalOf([](State& s) { s.layers[1].topM = s.layers[1].baseM; }), "");
  EXPECT_EQ(refusalOf([](State& s) { s.layers[0].cover = 1.5; }),
            "layers.0.cover: 1.5 is out of range 0 to 1");
  EXPECT_EQ(refusalOf([](State& s) { s.precipitation.rain = -1; }),
            "precipitation.rain: -1 is out of range 0 to 200");
  EXPECT_EQ(refusalOf([](State& s) { s.wind.speedMps = std::nan(""); }),
            "wind.speed: nan is out of range 0 to 100");
  EXPECT_NE(refusalOf([](State& s) { s.wind.levels[2].heightM = s.wind.levels[1].heightM; }), "");
  game::World world(worldIn({}, {0, 600, 0}));
  const std::uint64_t before = world.stateHash();
  WeatherSettings broken;
  broken.sites[1].layers[3].top = 0;
  EXPECT_EQ(test::refusalOf<core::RangeError>([&] {
              world.setWeather(game::WeatherSetup{broken, {}, nullptr});
            }),
            "weather.sites.1.layers.3: the top at 0 m is not above the base at 1555 m");
  EXPECT_EQ(world.stateHash(), before) << "nothing has changed";
}

// The filters' output over so many steps of a length.
std::vector<glm::dvec3> gustsOf(const weather::DrydenScales& scales, double airspeed, double dt, int steps) {
  weather::Dryden dryden(5);
  const weather::DrydenStep change(scales, airspeed, dt);
  std::vector<glm::dvec3> gusts;
  gusts.reserve(static_cast<std::size_t>(steps));
  for (int i = 0; i < steps; ++i) {
    dryden.advance(change, static_cast<std::uint64_t>(i));
    gusts.push_back(dryden.gust());
  }
  return gusts;
}

TEST(Stability, W05_gustsHaveTheirVarianceAtAnyStep) {
  // From 1/60 to 1/480 s the stationary covariance is kept to 1e-12 of itself by one step, from ways of 1e-12
  // to 1e3 scale lengths too, and 2000 scale lengths of gusts have variance 1 within 6 % (two standard
  // errors).
  EXPECT_TRUE(test::holdsLive("W05"));
  for (double a = 1e-12; a < 2e3; a *= 3) {
    const weather::DrydenStep step({glm::dvec3(1), glm::dvec3(1)}, a, 1);
    const auto& t = step.v;
    EXPECT_GE(t.noise22, 0);
    if (a < 0.01) {  // the leading terms of the covariance, which cancellation would lose
      EXPECT_TRUE(
          test::holds("W05", test::apart(t.noise11 * t.noise11 / a, 1), test::atMost(0.02), "relative"))
          << a;
      EXPECT_TRUE(test::holds("W05", test::apart(t.noise22 * t.noise22 / (a * a * a / 12), 1),
                              test::atMost(0.05), "relative"))
          << a;
    }
  }
  const weather::DrydenStep frozen({glm::dvec3(1), glm::dvec3(1)}, 0, 1.0 / 120);
  EXPECT_EQ(frozen.v.keep, 1);
  EXPECT_EQ(frozen.v.noise11, 0);
  const double length = 35, airspeed = 70;
  for (const double rate : {60.0, 120.0, 240.0, 480.0}) {
    const int steps = static_cast<int>((test::kInstrumented ? 300 : 2000) * length / airspeed * rate);
    glm::dvec3 square(0);
    for (const glm::dvec3& g : gustsOf({glm::dvec3(1), glm::dvec3(length)}, airspeed, 1 / rate, steps))
      square += g * g / static_cast<double>(steps);
    for (int i = 0; i < 3; ++i)
      EXPECT_TRUE(test::holds("W05", test::apart(square[i], 1),
                              test::atMost(test::kInstrumented ? 0.2 : 0.06), "of the variance"))
          << rate;
  }
}

void transform(std::vector<std::complex<double>>& x) {  // radix 2, in place
  const std::size_t n = x.size();
  for (std::size_t i = 1, j = 0; i < n; ++i) {
    std::size_t bit = n >> 1;
    for (; j & bit; bit >>= 1) j ^= bit;
    j ^= bit;
    if (i < j) std::swap(x[i], x[j]);
  }
  for (std::size_t length = 2; length <= n; length <<= 1) {
    const std::complex<double> turn = std::polar(1.0, -2 * kPi / static_cast<double>(length));
    for (std::size_t i = 0; i < n; i += length) {
      std::complex<double> w = 1;
      for (std::size_t k = 0; k < length / 2; ++k, w *= turn) {
        const auto u = x[i + k], v = x[i + k + length / 2] * w;
        x[i + k] = u + v, x[i + k + length / 2] = u - v;
      }
    }
  }
}

TEST(Stability, W06_theSpectrumOfAMillionStepsOfGustsIsDrydens) {
  // Power in octaves of frequency, from half a cycle to 250 cycles a scale length, within 10 % of the
  // formulae; by Welch's method (1967) with Hann windows that overlap by half.
  constexpr int kSteps = 1000000;
  constexpr std::size_t kSegment = 8192;
  constexpr double kRate = 120, kAirspeed = 70, kLength = 150, kTime = kLength / kAirspeed;
  const auto gusts = gustsOf({glm::dvec3(1), glm::dvec3(kLength)}, kAirspeed, 1 / kRate, kSteps);
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> power(kSegment / 2);
    int segments = 0;
    for (std::size_t from = 0; from + kSegment <= gusts.size(); from += kSegment / 2, ++segments) {
      std::vector<std::complex<double>> x(kSegment);
      for (std::size_t i = 0; i < kSegment; ++i)
        x[i] = gusts[from + i][axis] * (0.5 - 0.5 * std::cos(2 * kPi * static_cast<double>(i) / kSegment));
      transform(x);
      for (std::size_t k = 0; k < power.size(); ++k) power[k] += std::norm(x[k]);
    }
    // To power a radian a second: the window's mean square is 3/8.
    const double scale = 2 / (kRate * kSegment * 0.375 * segments) / (2 * kPi);
    for (std::size_t first = 4; 2 * first <= kSegment / 10; first *= 2) {
      double measured = 0, wanted = 0;
      for (std::size_t k = first; k < 2 * first; ++k) {
        const double w = 2 * kPi * kRate * static_cast<double>(k) / kSegment * kTime, w2 = w * w;
        measured += power[k] * scale;
        wanted += axis == 0 ? 2 * kTime / kPi / (1 + w2) : kTime / kPi * (1 + 3 * w2) / ((1 + w2) * (1 + w2));
      }
      EXPECT_TRUE(test::holds("W06", test::apart(measured / wanted, 1), test::atMost(0.1), "relative"))
          << "axis " << axis << ", from bin " << first;
    }
  }
}

TEST(Stability, W07_theStandardAtmosphereHoldsAtItsBreakpointsBelowTheSeaAndAboveItsTop) {
  // Table 4 of the standard at the borders of its layers, continuous through each; -430 m and -5 km; above
  // the top finite and falling.
  EXPECT_TRUE(test::holdsLive("W07"));
  for (const double h : {0.0, 11000.0, 20000.0, 32000.0, 47000.0, 51000.0, 71000.0, 84852.0}) {
    const double height = 6356766 * h / (6356766 - h);
    EXPECT_TRUE(
        test::holds("W07", test::apart(weather::geopotentialHeight(height), h), test::atMost(1e-6), "m"));
    const weather::Air below = weather::standardAir(height - 1e-3),
                       above = weather::standardAir(height + 1e-3);
    EXPECT_TRUE(test::holds("W07", test::apart(below.densityKgM3 / above.densityKgM3, 1), test::atMost(1e-6),
                            "relative"))
        << h;
    EXPECT_LT(above.densityKgM3, below.densityKgM3) << h;
  }
  EXPECT_TRUE(test::holds("W07", test::apart(weather::standardAir(-430).temperatureK, 290.945),
                          test::atMost(1e-3), "K"));
  EXPECT_TRUE(test::holds(
      "W07",
      test::apart(weather::standardAir(-430).pressurePa, 101325 * std::pow(290.9452 / 288.15, 5.255876)),
      test::atMost(2), "Pa"))
      << "the Dead Sea";
  EXPECT_TRUE(test::holds("W07", test::apart(weather::standardAir(-5000).densityKgM3, 1.9311),
                          test::atMost(1e-4), "kg/m3"));
  EXPECT_EQ(weather::standardAir(-1e9).densityKgM3, weather::standardAir(-5000).densityKgM3);
  double before = weather::standardAir(86000).densityKgM3;
  for (double height = 86001; height < 1e6; height *= 1.01) {
    const double density = weather::standardAir(height).densityKgM3;
    EXPECT_LE(density, before) << height;
    EXPECT_GE(density, 0) << height;
    before = density;
  }
  for (const double odd : {1e300, std::numeric_limits<double>::infinity(), std::nan("")})
    EXPECT_TRUE(std::isfinite(weather::standardAir(odd).densityKgM3)) << odd;
}

TEST(Stability, W08_thirtyDaysOfWeatherStayUsableAndSmooth) {
  // At six moments of every fourth minute for 30 days, on both sides of where the wander has its knots too,
  // the state is usable, and in a step of the simulation nothing jumps: directions by less than .03 degrees,
  // speeds by .01 m/s, covers by .0002, which the steepest wander just stays below.
  const WeatherSettings settings = roughWeather();
  constexpr double kStep = 1.0 / 120;
  double least = 1e9, most = 0;
  for (int minute = 0; minute < 30 * 1440; minute += 4) {
    for (const double second : {-0.03, -0.004, 0.0, 13.7, 30.0, 59.98}) {
      const double t = std::max(minute * 60 + second, 0.0);
      const State now = weather::stateAt(settings, 9, t, {1000, 2000});
      const State next = weather::stateAt(settings, 9, t + kStep, {1000, 2000});
      ASSERT_NO_THROW(requireUsable(now)) << t;
      EXPECT_TRUE(test::holds("W08",
                              std::abs(std::remainder(next.wind.directionDeg - now.wind.directionDeg, 360)),
                              test::below(0.03), "degrees"))
          << t;
      EXPECT_TRUE(
          test::holds("W08", std::abs(next.wind.speedMps - now.wind.speedMps), test::below(0.01), "m/s"))
          << t;
      EXPECT_TRUE(test::holds("W08", std::abs(next.layers[0].cover - now.layers[0].cover), test::below(2e-4),
                              "cover"))
          << t;
      least = std::min(least, now.wind.speedMps), most = std::max(most, now.wind.speedMps);
    }
  }
  EXPECT_GT(most - least, 5) << "and it does change";
  EXPECT_EQ(weather::stateAt(settings, 9, 2e6, {1, 2}), weather::stateAt(settings, 9, 2e6, {1, 2}));
  EXPECT_NE(weather::stateAt(settings, 9, 2e6, {1, 2}), weather::stateAt(settings, 10, 2e6, {1, 2}));
}

TEST(Stability, W09_weatherHoldsABillionMetresOut) {
  // One site's weather is the same there to the bit, the clouds answer, and an aircraft flies 20 s without a
  // NaN.
  test::noFaults("W09", "violations");
  WeatherSettings settings = roughWeather();
  settings.secondSite = false;
  EXPECT_EQ(weather::stateAt(settings, 3, 77, {0, 0}), weather::stateAt(settings, 3, 77, {1e9, -1e9}));
  settings.secondSite = true;
  ASSERT_NO_THROW(requireUsable(weather::stateAt(settings, 3, 77, {1e9, -1e9})));
  const game::FlownClouds clouds(test::quickNoise(), {});
  const double density = clouds.density(weather::stateAt(settings, 3, 0, {1e9, 0}), {1e9, 3000, 1e9}, 1e7);
  EXPECT_GE(density, 0);
  EXPECT_LE(density, 1);
  game::World world(worldIn(settings, {1e9, 800, -1e9}));
  for (int i = 0; i < 2400; ++i) world.step({});
  const game::Snapshot& now = world.now();
  EXPECT_TRUE(core::isFinite(now.aircraft.position));
  EXPECT_TRUE(core::isFinite(now.air.velocity));
  EXPECT_GT(glm::length(now.aircraft.position - glm::dvec3(1e9, now.aircraft.position.y, -1e9)), 500);
}

TEST(Stability, W10_aGustDoesNotKickTheAircraft) {
  // When the air's velocity jumps by 15 m/s the aircraft's stays: it changes by what the forces do in a step,
  // under .3 m/s, and the airspeed takes the jump.
  flight::BodyState start;
  start.velocity = {0, 0, -70};
  flight::Airplane airplane({}, start);
  for (int i = 0; i < 240; ++i) airplane.step({}, flight::AirMass(), 1.0 / 120);
  const glm::dvec3 before = airplane.body().velocity();
  const glm::dvec3 from = airplane.body().position();
  airplane.step({}, glm::dvec3(0, 0, 15), 1.0 / 120);
  EXPECT_TRUE(test::holds("W10", glm::length(airplane.body().velocity() - before), test::below(0.3), "m/s"));
  EXPECT_TRUE(test::holds("W10", test::apart(glm::length(airplane.body().position() - from), 70.0 / 120),
                          test::atMost(0.01), "m"));
  const flight::Airflow flow = airflowOf({}, 0, glm::dvec3(0, 0, 15), airplane.body().state());
  EXPECT_TRUE(
      test::holds("W10", test::apart(flow.airspeed, glm::length(before) + 15), test::atMost(0.5), "m/s"));
}

TEST(Stability, W11_weatherRepeatsEveryBitAtAnyFrameRate) {
  // A minute in rough weather, drawn at 30, 60, 144 and 2311 frames a second, ends in one and the same state;
  // another seed in another.
  test::noFaults("W11", "differences");
  const auto fly = [](double framesPerSecond, std::uint64_t seed) {
    game::WorldSetup setup = worldIn(roughWeather(), {0, 700, 0});
    setup.seed = seed;
    game::World world(setup);
    core::FixedStep clock;
    while (world.stepCount() < 7200) {
      for (int due = clock.advance(1 / framesPerSecond); due > 0 && world.stepCount() < 7200; --due) {
        const std::uint64_t step = world.stepCount();
        world.step({.pitch = step % 400 < 60 ? 0.3 : 0.0,
                    .roll = step % 900 < 200 ? 0.4 : 0.0,
                    .drop = step % 1000 == 500});
        static_cast<void>(world.interpolated(0.3));
      }
    }
    return world.stateHash();
  };
  const std::uint64_t once = fly(60, 1);
  for (const double rate : {30.0, 144.0, 2311.0}) EXPECT_EQ(fly(rate, 1), once) << rate;
  EXPECT_NE(fly(60, 2), once);
}

}  // namespace
}  // namespace skydrop
