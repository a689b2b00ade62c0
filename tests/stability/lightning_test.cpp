// Flashes, channels and thunder where they are numerically hard.
#include "skydrop/weather/lightning.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "skydrop/audio/thunder_schedule.h"
#include "skydrop/weather/thunder.h"
#include "support/margin.h"

namespace skydrop::weather {
namespace {

Moment storm(double perMinute, double seconds = 0) {
  auto settings = std::make_shared<WeatherSettings>();
  settings->variability = 0;
  settings->sites[0].lightning = perMinute;
  settings->sites[0].layers[0] = {
      .genus = Genus::cumulonimbus, .base = 1000, .top = 11000, .cover = 1, .density = 1};
  return {settings, 3, seconds};
}

bool isFinite(const glm::dvec3& v) { return std::isfinite(v.x + v.y + v.z); }

TEST(LightningStability, W51_ratesOfNoneAndOfMoreThanThereAreSlotsKeepToOneASlot) {
  test::noFaults("W51", "violations");
  EXPECT_TRUE(flashesBetween(storm(0), {}, 0, 86400, {}).empty());
  for (const double rate : {30.0, 60.0, 1e9}) {
    std::map<double, int> ofSlot;
    for (const Flash& flash : flashesBetween(storm(rate), {}, 0, 86400, {}))
      ++ofSlot[std::floor(flash.seconds / kFlashSlotS)];
    EXPECT_GT(ofSlot.size(), 0.6 * 86400 / kFlashSlotS) << rate;
    for (const auto& [slot, count] : ofSlot) ASSERT_EQ(count, 1) << rate << ' ' << slot;
  }
}

TEST(LightningStability, W52_channelsHoldTogether1e9MetresOut) {
  test::noFaults("W52", "violations");
  const std::vector<Flash> all = flashesBetween(storm(20), {}, 0, 600, {1e9, -1e9});
  ASSERT_GT(all.size(), 100u);
  for (const Flash& flash : all) {
    const Channel channel = channelOf(flash, 0);
    for (std::size_t i = 1; i < channel.mainPieces; ++i)
      ASSERT_EQ(channel.pieces[i].from, channel.pieces[i - 1].to);
    for (const ChannelPiece& piece : channel.pieces) {
      ASSERT_TRUE(isFinite(piece.from) && isFinite(piece.to));
      ASSERT_LT(glm::length(piece.to - piece.from), 1500);
    }
  }
}

TEST(LightningStability, W56_flashesWithoutLengthAndWithoutRoomAreFinite) {
  test::noFaults("W56", "values that are not finite");
  Flash flash{.seed = 5, .toGround = false, .from = {0, 3000, 0}, .to = {0, 3000, 0}, .cloudBaseM = 1000};
  for (const double groundM : {-1e9, 0.0, 3000.0, 9000.0}) {
    for (const bool toGround : {false, true}) {
      flash.toGround = toGround;
      const Channel channel = channelOf(flash, groundM);
      EXPECT_LE(channel.pieces.size(), kMostPieces);
      for (const ChannelPiece& piece : channel.pieces) {
        ASSERT_TRUE(isFinite(piece.from) && isFinite(piece.to) && std::isfinite(piece.share));
      }
      for (std::size_t i = channel.mainPieces; i < channel.pieces.size(); ++i)
        EXPECT_GE(channel.pieces[i].to.y, groundM);
      for (const glm::dvec3& light : channel.lights) EXPECT_TRUE(isFinite(light));
      EXPECT_TRUE(std::isfinite(channel.mainLengthM));
    }
  }
}

TEST(LightningStability, W57_eachClapIsHeardOnceHoweverTheListenerMoves) {
  // Towards and away from the storm at 70 m/s, in frames of 1/60 and 1/7 s: as many claps of a flash as the
  // channel has parts, but for those that were under way at the beginning and the end.
  for (const double frame : {1.0 / 60, 1.0 / 7}) {
    for (const double speed : {70.0, -70.0}) {
      audio::ThunderSchedule schedule{{}};
      std::size_t claps = 0;
      double last = -1;
      for (double t = 0; t < 400; t += frame) {
        game::Snapshot now;
        now.weather = storm(6, t);
        now.aircraft.present = true;
        now.aircraft.position = {speed * t, 500, 0};
        for (const Clap& clap : schedule.due(now)) {
          ++claps;
          EXPECT_GT(clap.gain, 0);
          EXPECT_TRUE(std::isfinite(clap.delayS));
          last = t;
        }
      }
      EXPECT_TRUE(test::holds("W57", test::apart(static_cast<double>(claps), 40 * Channel::kLights),
                              test::atMost(12 * Channel::kLights), "claps"))
          << frame;
      EXPECT_GT(last, 300);
    }
  }
}

TEST(LightningStability, W57_nothingIsHeardAfterAJumpOrInHeldTime) {
  test::noFaults("W57", "violations");
  game::Snapshot now;
  now.aircraft.present = true;
  audio::ThunderSchedule schedule{{}};
  const auto at = [&](double seconds, const glm::dvec3& place) {
    now.weather = storm(30, seconds);
    now.aircraft.position = place;
    return schedule.due(now).size();
  };
  EXPECT_EQ(at(1000, {}), 0u);             // the first call
  EXPECT_EQ(at(1000, {}), 0u);             // held
  EXPECT_EQ(at(86400, {}), 0u);            // a day later
  EXPECT_EQ(at(1000, {}), 0u);             // back
  EXPECT_EQ(at(1000.5, {1e6, 0, 0}), 0u);  // elsewhere
  EXPECT_EQ(at(1001, {1e9, 0, 0}), 0u);
  std::size_t heard = 0;
  for (int i = 1; i < 240; ++i) heard += at(1001 + i / 4.0, {1e9, 0, 0});
  EXPECT_GT(heard, 50u);
  now.weather = {};
  EXPECT_TRUE(schedule.due(now).empty());
}

TEST(LightningStability, W57_clapsAreFiniteWhereverTheListenerIs) {
  test::noFaults("W57", "values that are not finite");
  const Flash flash = flashesBetween(storm(30), {}, 0, 60, {}).front();
  const Channel channel = channelOf(flash, 0);
  for (const glm::dvec3& listener : {channel.lights[0], glm::dvec3(1e9), glm::dvec3(0, -1e9, 0)}) {
    for (const double temperature : {-1e9, -273.15, 15.0, 1e4}) {
      for (const Clap& clap : clapsOf(flash, channel, listener, temperature)) {
        EXPECT_TRUE(std::isfinite(clap.delayS) && clap.delayS >= 0);
        EXPECT_TRUE(clap.gain >= 0 && clap.gain <= 1);
        EXPECT_TRUE(clap.dullness >= 0 && clap.dullness <= 1);
      }
    }
  }
}

}  // namespace
}  // namespace skydrop::weather
