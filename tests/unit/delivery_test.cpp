// Deliveries: what a package earns, why one misses, where one comes down, and how a flight begins again.
#include "skydrop/game/delivery.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>

#include "skydrop/core/error.h"
#include "skydrop/flight/package.h"
#include "skydrop/game/contact.h"
#include "skydrop/game/world.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "skydrop/terrain/noise_height_source.h"
#include "support/margin.h"

namespace skydrop::game {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(),
                 kInfinity = std::numeric_limits<double>::infinity();

std::shared_ptr<const terrain::HeightSource> land() {
  static const auto source = terrain::makeNoiseHeightSource(terrain::TerrainSettings(), 1);
  return source;
}

double apartLevel(const glm::dvec3& a, const glm::dvec3& b) { return std::hypot(a.x - b.x, a.z - b.z); }

TEST(DeliveryPoints, growWithPrecisionAndShrinkWithTime) {
  // For every pair of distances and of times in a grid: nearer never earns less, sooner never less, and over
  // 10 m or 5 s strictly more.
  const DeliverySettings s;
  const auto at = [&](double d, double t) { return pointsOf(s, d, 100, t, 60); };
  for (int d = 0; d <= 100; d += 10) {
    for (int t = 0; t <= 600; t += 5) {
      if (d < 100) {
        EXPECT_GT(at(d, t), at(d + 10, t)) << d << " m, " << t << " s";
      }
      if (t < 600 && t < 300) {
        EXPECT_GT(at(d, t), at(d, t + 5)) << d << " m, " << t << " s";
      }
      if (t < 600) {
        EXPECT_GE(at(d, t), at(d, t + 5)) << d << " m, " << t << " s";
      }
    }
  }
  EXPECT_EQ(at(0, 0), 1000);
  EXPECT_EQ(at(100, 0), 250);
  EXPECT_EQ(at(0, 120), 500);  // T = 60 + 60
  EXPECT_EQ(at(100.001, 0), 0);
  EXPECT_GT(pointsOf(s, 10, 100, 60, 90), pointsOf(s, 10, 100, 60, 30)) << "a longer way may take longer";
}

TEST(DeliveryPoints, G05_nothingIsEarnedByWhatIsNoNumber) {
  test::noFaults("G05", "points");
  const DeliverySettings s;
  for (const double bad : {kNaN, kInfinity, -kInfinity, -1.0}) {
    EXPECT_EQ(pointsOf(s, bad, 100, 10, 10), 0);
    EXPECT_EQ(pointsOf(s, 10, bad, 10, 10), 0);
    EXPECT_EQ(pointsOf(s, 10, 100, bad, 10), 0);
    EXPECT_GE(pointsOf(s, 10, 100, 10, bad), 0);
  }
  EXPECT_EQ(pointsOf({.fadeSeconds = 0}, 10, 100, 0, 0), 0);
  EXPECT_EQ(pointsOf({.mostPoints = kNaN}, 10, 100, 0, 0), 0);
  WorldSetup setup;
  setup.ground = terrain::makeFlatSource(10);
  setup.delivery.mostPoints = kNaN;
  EXPECT_THROW(World{setup}, core::RangeError);
}

TEST(DeliveryReason, tellsEarlyLateLeftRightAndWind) {
  // Flying east (x) or north (-z) at 70 m/s over a target of 100 m.
  const glm::dvec2 east(70, 0), north(0, -70);
  const auto reason = [](const glm::dvec2& path, const glm::dvec2& miss) {
    return missReason(path, miss, miss, 100);
  };
  EXPECT_EQ(reason(east, {-300, 20}), MissReason::tooEarly);
  EXPECT_EQ(reason(east, {300, 20}), MissReason::tooLate);
  EXPECT_EQ(reason(east, {20, 300}), MissReason::right);  // south is right of east
  EXPECT_EQ(reason(east, {20, -300}), MissReason::left);
  EXPECT_EQ(reason(north, {300, 0}), MissReason::right);
  EXPECT_EQ(reason(north, {0, 300}), MissReason::tooEarly);
  EXPECT_EQ(reason(east, {50, 50}), MissReason::none);
  EXPECT_EQ(missReason(east, {150, 0}, {40, 0}, 100), MissReason::wind);
  EXPECT_EQ(reason({0, 0}, {300, 0}), MissReason::away);
  EXPECT_EQ(reason({kNaN, 0}, {300, 0}), MissReason::away);
  EXPECT_EQ(reason(east, {kNaN, 0}), MissReason::none);
}

// Flies level at 70 m/s and drops at once; the world after `seconds`.
World dropped(const WorldSetup& setup) {
  World world(setup);
  world.step({.drop = true});
  return world;
}

TEST(PackageLanding, G01_isPredictedFromAnyMomentOfTheFall) {
  // Every half second of a fall over hills, in wind, before, while and after the canopy opens: where and when
  // it comes down is where and when it does.
  int asked = 0;
  for (const glm::dvec3& wind : {glm::dvec3(0), glm::dvec3(9, 0, -4)}) {
    for (const double x : {0.0, 7000.0, -31000.0}) {
      WorldSetup setup;
      setup.ground = land();
      setup.wind = wind;
      setup.start.position = {x, 350, 900};
      World world = dropped(setup);
      struct Predicted {
        PackageLanding landing;
        std::uint64_t step;
      };
      std::vector<Predicted> predictions;
      while (!world.now().packages.empty() && !world.now().packages[0].landed) {
        ASSERT_TRUE(world.now().packages[0].landing) << "no prediction";
        predictions.push_back({*world.now().packages[0].landing, world.stepCount()});
        for (int i = 0; i < 60 && !world.now().packages[0].landed; ++i) world.step({});
      }
      ASSERT_FALSE(world.now().packages.empty());
      EXPECT_FALSE(world.now().packages[0].landing) << "it has landed";
      std::uint64_t landed = 0;
      for (const GameEvent& event : world.takeEvents())
        if (event.kind == GameEventKind::packageLanded) landed = event.step;
      for (const Predicted& p : predictions) {
        ++asked;
        const double off = apartLevel(p.landing.position, world.now().packages[0].position);
        EXPECT_TRUE(test::holds("G01", off, test::atMost(0.01), "m")) << x << ", step " << p.step;
        const double late = std::abs(p.landing.seconds - static_cast<double>(landed - p.step) / 120.0);
        EXPECT_LE(late, 0.05) << "seconds, at step " << p.step;
      }
    }
  }
  EXPECT_GT(asked, 200);
}

TEST(PackageLanding, G02_aDropAtNoHeightLandsAtOnce) {
  // The bay hangs below the surface: the package lies where it left, the prediction is 0 s, nothing is lost.
  WorldSetup setup;
  setup.ground = terrain::makeFlatSource(10);
  setup.game.contactHeight = 0;
  setup.start.position = {0, 0.5, 0};
  World world(setup);
  world.placeAircraft({.position = {0, 0.4, 0}});
  world.step({.drop = true});
  ASSERT_EQ(world.now().packages.size(), 1u);
  const PackageSnapshot& package = world.now().packages[0];
  EXPECT_TRUE(package.landed);
  EXPECT_TRUE(test::holds("G02", std::abs(package.position.y - 10), test::atMost(0.01), "m"));
  EXPECT_FALSE(world.now().messages.empty());
}

TEST(PackageLanding, G03_aPackageFallsIntoTheSea) {
  // Over the sea it lands on the water, and the record says so.
  WorldSetup setup;
  setup.ground = terrain::makeFlatSource(-30);
  setup.hasTargets = false;
  World world = dropped(setup);
  while (!world.now().packages[0].landed) world.step({});
  EXPECT_TRUE(world.now().packages[0].onWater);
  EXPECT_TRUE(test::holds("G03", std::abs(world.now().packages[0].position.y), test::atMost(0.01), "m"));
  EXPECT_TRUE(world.deliveries().empty()) << "no target, no record";
  Delivery wet;
  wet.distanceM = 130, wet.radiusM = 100, wet.onWater = true, wet.reason = MissReason::tooEarly;
  EXPECT_EQ(sentenceOf(wet), "Missed by 30 m: dropped too early, into the water");
}

TEST(PackageLanding, statesThatAreNoNumbersHaveNone) {
  const auto flat = [](const glm::dvec2&) { return 0.0; };
  const flight::PointState good{{0, 300, 0}, {70, 0, 0}};
  flight::PointState bad = good;
  bad.position.y = kNaN;
  EXPECT_FALSE(flight::predictLanding({}, bad, glm::dvec3(0), flat, 2));
  EXPECT_FALSE(flight::predictLanding({}, good, glm::dvec3(kNaN), flat, 2));
  EXPECT_FALSE(flight::predictLanding({}, good, glm::dvec3(0), flat, kNaN));
  EXPECT_FALSE(flight::predictLanding({}, good, glm::dvec3(0), flat, -1));
  EXPECT_FALSE(flight::predictLanding({}, good, glm::dvec3(0), [](const glm::dvec2&) { return kNaN; }));
  EXPECT_TRUE(flight::predictLanding({}, good, glm::dvec3(0), flat, 2));
}

TEST(Deliveries, areListedWithPointsAndReason) {
  // One dropped far off and, over the next target, one inside: two records, points of the hit alone.
  WorldSetup setup;
  setup.ground = terrain::makeFlatSource(10);
  World world(setup);
  world.step({.drop = true});
  EXPECT_EQ(world.now().messages.back().text.rfind("Package away: ", 0), 0u)
      << world.now().messages.back().text;
  for (int i = 0; i < 120 * 90 && world.deliveries().empty(); ++i) world.step({});
  ASSERT_EQ(world.deliveries().size(), 1u);
  EXPECT_FALSE(world.deliveries()[0].hit);
  EXPECT_NE(world.deliveries()[0].reason, MissReason::none);
  EXPECT_EQ(world.now().points, 0);
  StartPose pose;
  pose.position = world.now().target.position;
  pose.position.y = 310;
  pose.aboveGround = false;
  world.placeAircraft(pose);
  pose.position += world.now().target.position - *world.now().predictedLanding;
  pose.position.y = 310;
  world.placeAircraft(pose);
  ASSERT_TRUE(world.now().dropZone);
  world.step({.drop = true});
  EXPECT_TRUE(world.now().packages.back().landing->hits);
  for (int i = 0; i < 120 * 90 && world.deliveries().size() < 2; ++i) world.step({});
  ASSERT_EQ(world.deliveries().size(), 2u);
  const Delivery& hit = world.deliveries()[1];
  EXPECT_TRUE(hit.hit);
  EXPECT_EQ(hit.reason, MissReason::none);
  EXPECT_GT(hit.points, 0);
  EXPECT_EQ(world.now().points, hit.points);
  EXPECT_NEAR(hit.fallSeconds, 38, 12);
}

TEST(Deliveries, theWindIsNamedWhereStillAirHadHit) {
  WorldSetup setup;
  setup.ground = terrain::makeFlatSource(10);
  setup.wind = {0, 0, -14};
  World world(setup);
  StartPose pose;
  pose.position = world.now().target.position;
  pose.position.y = 410;
  pose.aboveGround = false;
  // Aimed as if there were no wind.
  world.setWind(glm::dvec3(0));
  world.placeAircraft(pose);
  pose.position += world.now().target.position - *world.now().predictedLanding;
  pose.position.y = 410;
  world.placeAircraft(pose);
  world.setWind({0, 0, -14});
  world.step({.drop = true});
  for (int i = 0; i < 120 * 120 && world.deliveries().empty(); ++i) world.step({});
  ASSERT_FALSE(world.deliveries().empty());
  EXPECT_EQ(world.deliveries()[0].reason, MissReason::wind);
  EXPECT_GT(world.deliveries()[0].windM, 200);
}

TEST(Start, facesTheTargetWhereThatIsAsked) {
  // At the beginning, and after R however far the flight has gone; not without being asked, and a flight
  // that is not has the states that it had.
  WorldSetup setup;
  setup.ground = land();
  setup.start.position = {0, 400, 0};
  setup.start.headingDeg = 90;
  World plain(setup);
  EXPECT_NEAR(plain.now().aircraft.headingRad, std::acos(0.0), 1e-9);
  const std::uint64_t before = plain.stateHash();
  setup.delivery.startFacesTarget = true;
  World world(setup);
  const auto off = [&] {
    return std::abs(
        std::remainder(world.now().aircraft.headingRad - world.now().target.bearingRad, 6.283185307179586));
  };
  EXPECT_LT(off(), 0.01);
  for (int i = 0; i < 120 * 240; ++i) world.step({.roll = i % 2400 < 60 ? 0.4 : 0});
  world.step({.reset = true});
  EXPECT_LT(off(), 0.05);
  EXPECT_LE(world.now().target.distance, setup.game.targetFarthest);
  setup.delivery.startFacesTarget = false;
  EXPECT_EQ(World(setup).stateHash(), before);
}

}  // namespace
}  // namespace skydrop::game
