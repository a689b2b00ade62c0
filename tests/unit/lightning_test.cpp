#include "skydrop/weather/lightning.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <deque>
#include <glm/geometric.hpp>
#include <map>

#include "skydrop/core/hash.h"
#include "skydrop/core/shared_flash.h"
#include "skydrop/weather/thunder.h"
#include "support/margin.h"

namespace skydrop::weather {
namespace {

Moment storm(double perMinute, std::uint64_t seed = 7) {
  auto settings = std::make_shared<WeatherSettings>();
  settings->variability = 0;
  settings->sites[0].lightning = perMinute;
  settings->sites[0].layers[0] = {
      .genus = Genus::cumulonimbus, .base = 1000, .top = 11000, .cover = 0.6, .density = 1};
  return {settings, seed, 0};
}

constexpr double kDayS = 86400;

TEST(Lightning, W52_comesAsOftenAsTheWeatherSaysWithinSight) {
  // The mean of a day is that of the state within four standard deviations, at any place.
  for (const double rate : {0.5, 6.0, 30.0}) {
    for (const glm::dvec2 place : {glm::dvec2(0), glm::dvec2(123456, -7e5), glm::dvec2(-1e9, 1e9)}) {
      const auto count = static_cast<double>(flashesBetween(storm(rate), {}, 0, kDayS, place).size());
      const double expected = rate * kDayS / 60;
      EXPECT_TRUE(
          test::holds("W52", test::apart(count, expected), test::atMost(4 * std::sqrt(expected)), "flashes"))
          << rate << " a minute at " << place.x;
    }
  }
}

TEST(Lightning, W55_noSecondOfThirtyDaysHasMoreThanThreeBrightMoments) {
  // At the highest rate, at a place that is flown away from: of strokes in any second, and between the last
  // of one flash and the first of the next.
  test::noFaults("W55", "violations");
  std::deque<double> strokes;
  std::size_t most = 0, flashes = 0;
  double lastStroke = -1e9, shortestPause = 1e9;
  for (int hour = 0; hour < 30 * 24; ++hour) {
    const double from = 3600.0 * hour;
    for (const Flash& flash :
         flashesBetween(storm(30), {.groundShare = 1}, from, from + 3600, {70 * from, 0})) {
      ++flashes;
      shortestPause = std::min(shortestPause, flash.seconds - lastStroke);
      for (std::size_t i = 0; i < flash.strokeCount; ++i) {
        const double at = flash.seconds + flash.strokes[i].afterS;
        ASSERT_GT(at, lastStroke);
        lastStroke = at;
        strokes.push_back(at);
        while (strokes.front() <= at - 1) strokes.pop_front();
        most = std::max(most, strokes.size());
      }
    }
  }
  EXPECT_GT(flashes, 30u * 24 * 60 * 25);
  EXPECT_EQ(most, kMostStrokes);
  EXPECT_GE(shortestPause, 1);
}

TEST(Lightning, isAFunctionOfTimeHoweverItIsAskedFor) {
  // Asked for in one piece, in steps of a frame, backwards, and across the beginning of time: the same
  // flashes.
  const Moment moment = storm(20);
  const glm::dvec2 place(5000, -3000);
  const std::vector<Flash> whole = flashesBetween(moment, {}, -120, 120, place);
  ASSERT_GT(whole.size(), 50u);
  std::vector<double> stepped;
  for (int i = 240 * 60 - 1; i >= 0; --i) {
    const double from = -120 + i / 60.0, to = -120 + (i + 1) / 60.0;
    for (const Flash& flash : flashesBetween(moment, {}, from, to, place)) stepped.push_back(flash.seconds);
  }
  std::ranges::reverse(stepped);
  ASSERT_EQ(stepped.size(), whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i) EXPECT_EQ(stepped[i], whole[i].seconds);
  for (const Flash& flash : whole) {
    const std::vector<Flash> shining = flashesShining(moment, {}, flash.seconds + 0.01, place);
    ASSERT_EQ(shining.size(), 1u);
    EXPECT_EQ(shining[0].seed, flash.seed);
  }
}

TEST(Lightning, thereIsNoneWithoutWeatherRateOrCloud) {
  EXPECT_TRUE(flashesBetween({}, {}, 0, kDayS, {}).empty());
  EXPECT_TRUE(flashesBetween(storm(0), {}, 0, kDayS, {}).empty());
  auto clear = std::make_shared<WeatherSettings>();
  clear->sites[0].lightning = 30;
  EXPECT_TRUE(flashesBetween({clear, 1, 0}, {}, 0, kDayS, {}).empty());
}

TEST(Lightning, beginsInItsCloudAndStrikesTheGroundAsOftenAsAsked) {
  for (const double share : {0.0, 0.25, 1.0}) {
    const std::vector<Flash> all = flashesBetween(storm(30), {.groundShare = share}, 0, kDayS, {});
    const auto count = static_cast<double>(all.size());
    const auto struck = static_cast<double>(std::ranges::count_if(all, &Flash::toGround));
    EXPECT_NEAR(struck / count, share, 4 * std::sqrt(share * (1 - share) / count) + 1e-12);
    for (const Flash& flash : all) {
      EXPECT_GT(flash.from.y, 1000);
      EXPECT_LT(flash.from.y, 11000);
      if (!flash.toGround) {
        EXPECT_GT(flash.to.y, 1000);
        EXPECT_LT(flash.to.y, 11000);
      }
    }
  }
}

TEST(Lightning, shinesFromItsBeginningToItsEndAndIsSoftenedToAQuarter) {
  const Flash flash{.seconds = 5, .strokes = {{{0, 1}, {0.1, 0.6}}}, .strokeCount = 2};
  const auto peakOf = [&](double softness) {
    double peak = 0, steepest = 0, last = 0;
    int rises = 0;
    bool rising = false;
    for (int i = 0; i <= 4000; ++i) {
      const double now = brightnessAt(flash, {.softness = softness}, 4.9 + i * 5e-4);
      EXPECT_GE(now, 0);
      if (now > last && !rising) ++rises;
      rising = now > last;
      steepest = std::max(steepest, (now - last) / 5e-4);
      peak = std::max(peak, now);
      last = now;
    }
    EXPECT_EQ(last, 0);
    EXPECT_EQ(rises, softness < 1 ? 2 : 1) << softness;
    return std::pair(peak, steepest);
  };
  const auto [hard, hardRise] = peakOf(0);
  const auto [soft, softRise] = peakOf(1);
  EXPECT_NEAR(hard, 0.8, 0.2);
  EXPECT_LT(soft, 0.25);
  EXPECT_GT(soft, 0.05);
  EXPECT_LT(softRise, hardRise / 30);
  EXPECT_EQ(brightnessAt(flash, {}, 5), 0);
  EXPECT_EQ(brightnessAt(flash, {}, 5 + kFlashStrokesS + kLongestFadeS), 0);
}

TEST(LightningChannel, leadsFromTheCloudToTheGroundInSmallTurns) {
  // Every channel of a day: connected, bounded, turning by 16 degrees a piece in the mean (Reed and Wyvill).
  const std::vector<Flash> all = flashesBetween(storm(6), {.groundShare = 0.5}, 0, kDayS / 4, {});
  double turned = 0, turns = 0;
  for (const Flash& flash : all) {
    const Channel channel = channelOf(flash, 350);
    ASSERT_LE(channel.pieces.size(), kMostPieces);
    ASSERT_GT(channel.pieces.size(), channel.mainPieces);
    EXPECT_EQ(channel.pieces.front().from, flash.from);
    const glm::dvec3 end = channel.pieces[channel.mainPieces - 1].to;
    EXPECT_EQ(end, flash.toGround ? glm::dvec3(flash.to.x, 350, flash.to.z) : flash.to);
    for (std::size_t i = 0; i < channel.pieces.size(); ++i) {
      const ChannelPiece& piece = channel.pieces[i];
      EXPECT_GT(piece.share, 0);
      EXPECT_LE(piece.share, 1);
      EXPECT_GE(piece.to.y, 350);
      if (i == 0 || i >= channel.mainPieces) continue;
      EXPECT_EQ(piece.from, channel.pieces[i - 1].to);
      const glm::dvec3 before = channel.pieces[i - 1].to - channel.pieces[i - 1].from;
      const glm::dvec3 now = piece.to - piece.from;
      turned +=
          std::acos(std::clamp(glm::dot(before, now) / (glm::length(before) * glm::length(now)), -1.0, 1.0));
      ++turns;
    }
    const double straight = glm::length(end - flash.from);
    EXPECT_GT(channel.mainLengthM, straight);
    EXPECT_LT(channel.mainLengthM, 2 * straight);
  }
  ASSERT_GT(turns, 1000);
  EXPECT_NEAR(turned / turns * 180 / 3.14159, 16, 2);
}

// Photons of a light within a slab of cloud that scatters evenly with a mean free path (that of drops, over 1
// less their anisotropy) and absorbs nothing: how many leave downwards, and at which distance from below it.
struct Escaped {
  std::vector<double> aside;
  double down = 0;  // share of all
};
Escaped followPhotons(double depthM, double heightM, double freePathM, int photons) {
  core::RandomStream random{42};
  Escaped escaped;
  for (int i = 0; i < photons; ++i) {
    glm::dvec3 at(0, heightM, 0);
    for (;;) {
      const double up = 2 * random.nextUnit() - 1, angle = 2 * 3.14159265358979 * random.nextUnit();
      const double lengthM = -freePathM * std::log(1 - random.nextUnit()), level = std::sqrt(1 - up * up);
      const glm::dvec3 to = at + lengthM * glm::dvec3(level * std::cos(angle), up, level * std::sin(angle));
      if (to.y < 0) {
        const glm::dvec3 left = at + (to - at) * (at.y / (at.y - to.y));
        escaped.aside.push_back(std::hypot(left.x, left.z));
      }
      if (to.y < 0 || to.y > depthM) break;
      at = to;
    }
  }
  escaped.down = static_cast<double>(escaped.aside.size()) / photons;
  return escaped;
}

TEST(FlashLight, glowOfCloudsIsThatOfPhotonsFollowedWithin40Percent) {
  // Of the base of slabs of cloud, from below the light to three times its height aside; and what following
  // photons costs and errs, from ten times fewer of them.
  constexpr int kPhotons = 30000;
  using Clock = std::chrono::steady_clock;
  const auto msSince = [](Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
  };
  double worst = 0, photonsMs = 0, fewerMs = 0, fewerWorst = 0;
  for (const auto& [depthM, heightM] : {std::pair(6000.0, 2100.0), {6000.0, 1000.0}, {10000.0, 3000.0}}) {
    auto begin = Clock::now();
    const Escaped escaped = followPhotons(depthM, heightM, 133, kPhotons);
    photonsMs += msSince(begin);
    begin = Clock::now();
    const Escaped fewer = followPhotons(depthM, heightM, 133, kPhotons / 10);
    fewerMs += msSince(begin);
    EXPECT_NEAR(escaped.down, 0.7, 0.15);
    for (double from = 0; from < 3; from += 0.5) {
      const double inner = from * heightM, outer = (from + 0.5) * heightM;
      const auto countOf = [&](const Escaped& of) {
        return static_cast<double>(
            std::ranges::count_if(of.aside, [&](double r) { return r >= inner && r < outer; }));
      };
      const double count = countOf(escaped);
      fewerWorst = std::max(fewerWorst, std::abs(10 * countOf(fewer) / count - 1));
      // Of a light of intensity 1, which sends out 4 pi: exitance over pi.
      const double radiance = count / kPhotons * 4 / (3.14159265 * (outer * outer - inner * inner));
      const double middle = 0.5 * (inner + outer);
      const double formula =
          core::shared::f64::flashCloudGlow(middle * middle + heightM * heightM, 1, heightM);
      worst = std::max(worst, std::abs(formula / radiance - 1));
    }
  }
  constexpr int kCalls = 100000;
  double sum = 0;
  const auto begin = Clock::now();
  for (int i = 0; i < kCalls; ++i) sum += core::shared::f64::flashCloudGlow(4e6 + i, 1, 2000);
  const double formulaNs = 1e6 * msSince(begin) / kCalls;
  EXPECT_GT(sum, 0);
  std::printf(
      "glow by the formula: %.2f at worst, %.0f ns; by %d photons: %.2f at worst, %.0f ms a slab; by %d: "
      "%.0f ms\n",
      worst, formulaNs, kPhotons / 10, fewerWorst, fewerMs / 3, kPhotons, photonsMs / 3);
  EXPECT_LT(worst, 0.4);
  EXPECT_GT(worst, 0.1);  // and no better than it says
}

TEST(FlashLight, airlightIsTheIntegralAlongTheRay) {
  // Against the midpoint rule of 200000 steps; from within the light's core, away from it, past it.
  namespace shared = core::shared::f64;
  for (const glm::dvec3& light : {glm::dvec3(3000, 400, 0), {-3000, 10, 5}, {1e-3, 0, 0}, {20000, 0, 0}}) {
    for (const double lengthM : {1.0, 2500.0, 40000.0}) {
      double sum = 0;
      constexpr int kSteps = 200000;
      for (int i = 0; i < kSteps; ++i) {
        const glm::dvec3 way = light - glm::dvec3((i + 0.5) / kSteps * lengthM, 0, 0);
        sum += lengthM / kSteps / (glm::dot(way, way) + 200.0 * 200);
      }
      EXPECT_NEAR(shared::flashAirlight(light, {1, 0, 0}, lengthM, 200.0 * 200) / sum, 1, 1e-6);
    }
  }
}

TEST(Thunder, isLateByDistanceOverTheSpeedOfSound) {
  // 343.2 m/s at 20 degrees (ICAO standard atmosphere's formula); a stroke 3.4 km away is heard 10 s later.
  EXPECT_NEAR(speedOfSound(20), 343.2, 0.1);
  EXPECT_NEAR(speedOfSound(15), 340.3, 0.1);
  EXPECT_GT(speedOfSound(-1000), 0);
  Channel channel;
  channel.lights.fill({3403, 0, 0});
  const Claps claps = clapsOf({}, channel, {0, 0, 0}, 15);
  for (const Clap& clap : claps) EXPECT_NEAR(clap.delayS, 10, 0.01);
}

TEST(Thunder, rumblesLongerQuieterAndDullerTheFarther) {
  const Flash flash{.seed = 3, .toGround = true, .from = {0, 4000, 0}, .to = {0, 0, 0}};
  const Channel channel = channelOf(flash, 0);
  Clap last{.gain = 2, .dullness = -1};
  for (const double away : {200.0, 1000.0, 5000.0, 15000.0, 30000.0}) {
    const Claps claps = clapsOf(flash, channel, {away, 100, 0}, 15);
    const auto [first, end] = std::ranges::minmax_element(claps, {}, &Clap::delayS);
    EXPECT_GT(end->delayS, first->delayS);
    EXPECT_LT(first->gain, last.gain);
    EXPECT_GT(first->dullness, last.dullness);
    last = *first;
  }
  EXPECT_EQ(last.gain, 0);  // 30 km
  const Claps above = clapsOf(flash, channel, channel.lights[3], 15);
  EXPECT_EQ(above[3].delayS, 0);
  EXPECT_EQ(above[3].gain, 1);
}

}  // namespace
}  // namespace skydrop::weather
