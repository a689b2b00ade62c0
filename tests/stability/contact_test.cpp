#include "skydrop/game/contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <optional>

#include "skydrop/core/fixed_step.h"
#include "skydrop/core/hash.h"
#include "skydrop/game/world.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "skydrop/terrain/noise_height_source.h"
#include "support/margin.h"

namespace skydrop::game {
namespace {

using terrain::HeightSource;

// A forest of steep cones, 150 m apart and up to 120 m high: peaks that a step of 6 m can jump.
class ConeLand final : public HeightSource {
 public:
  terrain::HeightSample sample(glm::dvec2 xz) const override {
    const double dx = std::remainder(xz.x, 150.0), dz = std::remainder(xz.y, 150.0);
    return {std::max(10.0, 120 - 4 * std::sqrt(dx * dx + dz * dz)), {0, 0}};
  }
  terrain::HeightBounds bounds(glm::dvec2, glm::dvec2) const override { return range(); }
  terrain::HeightBounds range() const override { return {10, 120}; }
};

// The truth: the first point of the way that is `margin` or less above the surface, marched by `grain`
// metres.
std::optional<double> marched(const HeightSource& ground, const glm::dvec3& from, const glm::dvec3& to,
                              double margin, double grain) {
  const double length = glm::length(to - from);
  const auto steps = static_cast<int>(std::ceil(length / grain));
  for (int i = 0; i <= steps; ++i) {
    const double metres = length * i / steps;
    if (clearanceAt(ground, from + (to - from) * (metres / length)) <= margin) return metres;
  }
  return {};
}

// Flies from `from` along `way` in steps of 1/120 s at `speed` and returns the metres to the first contact.
std::optional<double> flown(const HeightSource& ground, const glm::dvec3& from, const glm::dvec3& way,
                            double speed, double metres, double margin) {
  const double step = speed * core::FixedStep::kStepSeconds;
  double clearance = clearanceAt(ground, from);
  for (double at = 0; at < metres; at += step) {
    const glm::dvec3 a = from + way * at, b = from + way * std::min(at + step, metres);
    const double after = clearanceAt(ground, b);
    if (const auto hit = sweepContact(ground, a, b, margin, clearance, after)) {
      EXPECT_GE(clearanceAt(ground, hit->position), margin - 1e-9) << "below the ground";
      return at + hit->fraction * std::min(step, metres - at);
    }
    clearance = after;
  }
  return {};
}

void compareWithMarching(const HeightSource& ground, double lowest, double highest, int flights, double grain,
                         int& hits) {
  core::RandomStream random{11, 0};
  for (int i = 0; i < flights; ++i) {
    const double heading = random.nextUnit() * 6.28, dive = (random.nextUnit() - 0.7) * 0.3;
    const glm::dvec3 way(std::cos(heading) * std::cos(dive), std::sin(dive),
                         std::sin(heading) * std::cos(dive));
    const glm::dvec3 from(random.nextUnit() * 4000, lowest + (highest - lowest) * random.nextUnit(),
                          random.nextUnit() * 4000);
    if (clearanceAt(ground, from) <= 1.5) continue;
    const auto truth = marched(ground, from, from + way * 700.0, 1.5, grain);
    const auto found = flown(ground, from, way, 700, 700, 1.5);
    ASSERT_EQ(truth.has_value(), found.has_value()) << "flight " << i;
    if (!truth) continue;
    ++hits;
    ASSERT_NEAR(*found, *truth, 0.5) << "flight " << i;
  }
}

TEST(Stability, T25_firstContactAtSevenHundredMetresPerSecondIsTheRayMarchedOne) {
  // 300 flights at 700 m/s (5.8 m a step) into a forest of peaks, and 200 over real land: the same flights
  // hit, each within .5 m of a march by 1 and 5 cm, and no contact point lies below the ground.
  test::noFaults("T25", "violations");
  int hits = 0;
  compareWithMarching(ConeLand{}, 15, 140, 300, 0.01, hits);
  EXPECT_GT(hits, 100);
  hits = 0;
  compareWithMarching(*terrain::makeNoiseHeightSource({}, 1), 0, 500, 200, 0.05, hits);
  EXPECT_GT(hits, 10);
}

TEST(Stability, T25_peaksNarrowerThanAStepAreNotFlownThrough) {
  // 400 flights at 700 m/s aimed .3 to 1.5 m under a summit, which is up to 1.5 m wide there and lies
  // anywhere within a step of 5.8 m: every one is stopped, within .5 m of the truth.
  const ConeLand peaks;
  core::RandomStream random{13, 0};
  for (int i = 0; i < 400; ++i) {
    const double heading = random.nextUnit() * 6.28;
    const glm::dvec3 way(std::cos(heading), 0, std::sin(heading));
    const double under = 0.3 + 1.2 * random.nextUnit();
    const glm::dvec3 from = glm::dvec3(0, 120 - under, 0) - way * (30 + 6 * random.nextUnit());
    const auto truth = marched(peaks, from, from + way * 60.0, 0, 0.01);
    const auto found = flown(peaks, from, way, 700, 60, 0);
    ASSERT_TRUE(truth && found) << "flight " << i;
    ASSERT_TRUE(test::holds("T25", test::apart(*found, *truth), test::atMost(0.5), "m")) << "flight " << i;
  }
}

TEST(Stability, T25_anAircraftDivingIntoAPeakStopsOnItsSurface) {
  // Fired at 300 m/s from all sides at the peaks, the aircraft is never below the ground in any step, and
  // lies on the surface after the crash.
  const auto land = std::make_shared<const ConeLand>();
  WorldSetup setup;
  setup.ground = land;
  setup.hasTargets = false;
  setup.start.position = {40, 60, 30};
  setup.start.aboveGround = false;
  setup.start.speed = 300;
  int crashes = 0;
  for (int heading = 0; heading < 360; heading += 10) {
    setup.start.headingDeg = heading;
    World world(setup);
    for (int i = 0; i < 240; ++i) {
      world.step({});
      ASSERT_GE(clearanceAt(*land, world.now().aircraft.position), setup.game.contactHeight - 1e-9);
      if (!world.now().aircraft.crashed) continue;
      ++crashes;
      EXPECT_TRUE(test::holds("T25",
                              test::apart(world.now().aircraft.heightAboveGround, setup.game.contactHeight),
                              test::atMost(0.1), "m"));
      break;
    }
  }
  EXPECT_GT(crashes, 10);
}

TEST(Stability, T03_threeKilometresFromAHundredThousandKilometresOutAreThreeKilometres) {
  // Level flight that starts 1e8 m out, over land of its own: the distance travelled equals speed times time
  // within 1e-6 relative, and so does a flight with a turn in it, compared with the same at the origin.
  WorldSetup setup;
  setup.ground = terrain::makeFlatSource(20);
  setup.hasTargets = false;
  setup.start.headingDeg = 37;
  setup.start.position = {1e8, 500, -1e8};
  World world(setup);
  const glm::dvec3 from = world.now().aircraft.position;
  for (int i = 0; i < 5143; ++i) world.step({});
  EXPECT_TRUE(test::holds(
      "T03", test::apart(glm::length(world.now().aircraft.position - from) / (70 * 5143 / 120.0), 1),
      test::atMost(1e-6), "relative"));

  setup.start.position = {0, 500, 0};
  World near(setup);
  setup.start.position = {1e8, 500, -1e8};
  World far(setup);
  double way = 0;
  for (int i = 0; i < 5143; ++i) {
    const Controls controls{.thrust = 1, .pitch = i < 200 ? 0.3 : 0, .roll = i > 300 && i < 400 ? 1.0 : 0.0};
    near.step(controls);
    far.step(controls);
    way += glm::length(near.now().aircraft.position - near.before().aircraft.position);
  }
  const glm::dvec3 moved = far.now().aircraft.position - glm::dvec3(1e8, 0, -1e8);
  EXPECT_TRUE(
      test::holds("T03", glm::length(moved - near.now().aircraft.position), test::below(1e-6 * way), "m"));
}

TEST(Stability, P23_groundIsFeltAnywhereWithoutAnyChunk) {
  // No chunk exists in this process, and no cache: on real land 1e7 m out and at -3e8 m the height below is
  // that of the height function, a package lands on it, and the aircraft strikes it.
  const auto land = terrain::makeNoiseHeightSource({}, 1);
  for (const glm::dvec3& place : {glm::dvec3(1e7, 300, 1e7), glm::dvec3(-3e8, 300, 12345)}) {
    WorldSetup setup;
    setup.ground = land;
    setup.hasTargets = false;
    setup.start.position = place;
    World world(setup);
    world.step({.drop = true});
    const auto& craft = world.now().aircraft;
    EXPECT_EQ(craft.groundHeight + craft.heightAboveGround, craft.position.y);
    EXPECT_TRUE(test::holds(
        "P23",
        test::apart(craft.groundHeight, std::max(0.0, land->height({craft.position.x, craft.position.z}))),
        test::atMost(1e-6), "m"));
    bool crashed = false, landed = false;
    for (int i = 0; i < 120 * 120 && !(crashed && landed); ++i) {
      world.step({.thrust = 1, .pitch = -1});
      crashed = crashed || world.now().aircraft.crashed;
      for (const PackageSnapshot& package : world.now().packages) {
        if (!package.landed) continue;
        landed = true;
        EXPECT_TRUE(test::holds("P23", test::apart(clearanceAt(*land, package.position), 0),
                                test::atMost(0.01), "m"));
      }
    }
    EXPECT_TRUE(crashed && landed);
  }
}

}  // namespace
}  // namespace skydrop::game
