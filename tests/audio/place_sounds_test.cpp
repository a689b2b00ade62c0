// What is heard of a place, and how sounds reach who is not aboard.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "skydrop/audio/listener.h"
#include "skydrop/audio/surroundings.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "skydrop/terrain/noise_height_source.h"
#include "skydrop/terrain/woods.h"
#include "support/margin.h"

namespace skydrop::audio {
namespace {

using test::apart, test::atMost, test::holds;

constexpr Listener kStanding{.aboard = false, .position = {0, 100, 0}};

TEST(Arrival, aFlyByFallsInPitchByDopplersFormula) {
  // Along x at 100 m/s, 30 m beside one who stands: far before and behind it the textbook's factors, and the
  // pitch of the engine itself from where the sound leaves at right angles.
  const auto at = [](double x) { return arrivalFrom({x, 100, 30}, {100, 0, 0}, kStanding); };
  EXPECT_NEAR(at(-3000).pitch, kSoundMps / (kSoundMps - 100), 1e-3);
  EXPECT_NEAR(at(+3000).pitch, kSoundMps / (kSoundMps + 100), 1e-3);
  // Straight abeam when the sound left: 30 m take .088 s, in which it flies 8.8 m on.
  EXPECT_NEAR(at(100 * 30 / kSoundMps).pitch, 1, 1e-9);
  double last = 2;
  for (double x = -2000; x <= 2000; x += 10) {
    EXPECT_LT(at(x).pitch, last) << "it only falls";
    last = at(x).pitch;
  }
  Listener moving = kStanding;
  moving.velocity = {100, 0, 0};
  EXPECT_NEAR(arrivalFrom({-500, 100, 30}, {100, 0, 0}, moving).pitch, 1, 1e-12)
      << "nothing between like speeds";
}

TEST(Arrival, aSoundIsAsOldAsItsWayIsLong) {
  for (const glm::dvec3 velocity : {glm::dvec3(0), glm::dvec3(60, 0, 0), glm::dvec3(-200, 30, 90)}) {
    const glm::dvec3 source{-900, 400, 350};
    const Arrival arrival = arrivalFrom(source, velocity, kStanding);
    const glm::dvec3 left = source - velocity * arrival.seconds;
    EXPECT_NEAR(glm::length(kStanding.position - left) / kSoundMps, arrival.seconds, 1e-9);
  }
}

TEST(Arrival, fartherIsQuieterAndASideIsASide) {
  const auto gain = [](double distance) {
    return arrivalFrom({distance, 100, 0}, {0, 0, 0}, kStanding).gain;
  };
  EXPECT_EQ(gain(5), 1);
  EXPECT_NEAR(gain(120), 0.1, 0.006);
  EXPECT_GT(gain(1000), gain(2000));
  EXPECT_GT(arrivalFrom({50, 100, 0}, {0, 0, 0}, kStanding).pan, 0.99);
  EXPECT_LT(arrivalFrom({-50, 100, 0}, {0, 0, 0}, kStanding).pan, -0.99);
  EXPECT_NEAR(arrivalFrom({0, 100, -50}, {0, 0, 0}, kStanding).pan, 0, 1e-12);
}

TEST(Arrival, A01_soundIsFiniteFromAnySourceAtAnySpeed) {
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  double highest = 0, lowest = 2, loudest = 0;
  for (const double speed : {0.0, 1e-300, 340.3, 340.29999, 1000.0, 1e30}) {
    for (const glm::dvec3 way : {glm::dvec3(1, 0, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0, 0.6, 0.8)}) {
      for (const glm::dvec3 place :
           {glm::dvec3(0, 100, 0), glm::dvec3(1e-300, 100, 0), glm::dvec3(0, 100, 1e9),
            glm::dvec3(-700, 100, 2), glm::dvec3(1e200, 0, 0)}) {
        const Arrival arrival = arrivalFrom(place, way * speed, kStanding);
        ASSERT_TRUE(std::isfinite(arrival.gain) && std::isfinite(arrival.pitch) &&
                    std::isfinite(arrival.pan) && std::isfinite(arrival.seconds));
        highest = std::max(highest, arrival.pitch);
        lowest = std::min(lowest, arrival.pitch);
        loudest = std::max(loudest, arrival.gain);
      }
    }
  }
  EXPECT_LE(highest, 2);
  EXPECT_GE(lowest, 0.5);
  EXPECT_LE(loudest, 1);
  EXPECT_EQ(arrivalFrom({kEndless, 0, 0}, {0, 0, 0}, kStanding).gain, 0);
  EXPECT_EQ(arrivalFrom({0, 0, 0}, {std::nan(""), 0, 0}, kStanding).gain, 0);
  // A billion metres out the fly-by is that of the origin.
  Listener far = kStanding;
  far.position += glm::dvec3(1e9, 0, -1e9);
  const Arrival there = arrivalFrom(far.position + glm::dvec3(-400, 20, 30), {80, 0, 0}, far);
  const Arrival here = arrivalFrom(kStanding.position + glm::dvec3(-400, 20, 30), {80, 0, 0}, kStanding);
  EXPECT_TRUE(holds("A01", apart(there.pitch, here.pitch), atMost(1e-6), "times the pitch, 1e9 m away"));
}

TEST(Surroundings, birdsSingByDayNearWoodsAlone) {
  const auto land = terrain::makeNoiseHeightSource({}, 1);
  // The most and the least wooded of many places on dry land.
  glm::dvec2 wood{0}, bare{0};
  double most = -1, least = 2;
  for (int z = -40; z < 40; ++z) {
    for (int x = -40; x < 40; ++x) {
      const glm::dvec2 at(x * 977.0, z * 1013.0);
      const terrain::HeightSample there = land->sample(at);
      if (there.height < 30) continue;
      const double share = terrain::forestShare(there, at, false);
      if (share > most) most = share, wood = at;
      if (share < least) least = share, bare = at;
    }
  }
  ASSERT_GT(most, 0.8);
  const auto above = [&](const glm::dvec2& at, double height) {
    return glm::dvec3(at.x, land->height(at) + height, at.y);
  };
  const double near = surroundingsAt(*land, false, above(wood, 2), 30, 3).birds;
  EXPECT_GT(near, 0.3);
  EXPECT_LT(surroundingsAt(*land, false, above(wood, 150), 30, 3).birds, 0.1 * near);
  EXPECT_EQ(surroundingsAt(*land, false, above(wood, 2), -5, 3).birds, 0) << "at night";
  EXPECT_EQ(surroundingsAt(*land, false, above(wood, 2), 30, 20).birds, 0) << "in a gale";
  EXPECT_LT(surroundingsAt(*land, false, above(bare, 2), 30, 3).birds, near);
  EXPECT_EQ(surroundingsAt(*land, false, glm::dvec3(std::nan("")), 30, 3).birds, 0);
}

TEST(Surroundings, waterIsHeardAtShoresAndInWindOnTheSea) {
  const auto coast = terrain::makeStepSource(0, -20, 5);
  const auto heard = [&](double x, double height, double wind) {
    return surroundingsAt(*coast, false, {x, height, 0}, 30, wind).water;
  };
  EXPECT_GT(heard(0, 2, 3), 0.5) << "the surf";
  EXPECT_EQ(heard(1000, 7, 3), 0) << "inland";
  EXPECT_GT(heard(-1000, 2, 12), 2 * heard(-1000, 2, 1)) << "waves of the wind";
  EXPECT_GT(heard(0, 2, 3), 2 * heard(-1000, 2, 3));
  EXPECT_LT(heard(0, 300, 3), 0.02);
  EXPECT_EQ(surroundingsAt(*terrain::makeFlatSource(100), false, {0, 101, 0}, 30, 3).water, 0);
}

TEST(Surroundings, areAskedForFourTimesASecond) {
  const auto coast = terrain::makeStepSource(0, -20, 5);
  SurroundingsEar ear;
  const double first = ear.at(*coast, false, {0, 2, 0}, 30, 3, 10.0).water;
  EXPECT_EQ(ear.at(*coast, false, {5000, 7, 0}, 30, 3, 10.1).water, first);
  EXPECT_EQ(ear.at(*coast, false, {5000, 7, 0}, 30, 3, 10.3).water, 0);
  EXPECT_EQ(ear.at(*coast, false, {0, 2, 0}, 30, 3, -4.0).water, first) << "time may run backwards";
}

}  // namespace
}  // namespace skydrop::audio
