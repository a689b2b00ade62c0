// Marks over places of the world, and the arrow to a target out of view.
#include "skydrop/ui/hud_marks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/margin.h"

namespace skydrop::ui {
namespace {

// Looks north (-z) from 300 m.
Eye eyeNorth() {
  Eye eye;
  eye.position = {0, 300, 0};
  eye.width = 640, eye.height = 360;
  return eye;
}

game::Snapshot withTarget(const glm::dvec3& place) {
  game::Snapshot snapshot;
  snapshot.aircraft.present = true;
  snapshot.target.present = true;
  snapshot.target.position = place;
  snapshot.target.distance = 5000;
  return snapshot;
}

TEST(HudMarks, aTargetInViewHasNoArrow) {
  EXPECT_TRUE(hudMarks(withTarget({0, 200, -3000}), eyeNorth()).empty());
  EXPECT_TRUE(hudMarks(withTarget({0, -9000, -3000}), eyeNorth()).empty()) << "below the picture, but ahead";
}

TEST(HudMarks, G08_theArrowPointsToTheSideOfTheTargetAlsoBehind) {
  // Left, right, behind on either side, straight behind, straight below: one arrow or none, at an edge.
  test::noFaults("G08", "arrows to the wrong side");
  struct Case {
    glm::dvec3 place;
    double x;
  };
  for (const Case& c : {Case{{3000, 0, -100}, 640}, Case{{-3000, 0, -100}, 0}, Case{{500, 0, 3000}, 640},
                        Case{{-500, 0, 3000}, 0}, Case{{0, 0, 3000}, 640}}) {
    const std::vector<HudMark> marks = hudMarks(withTarget(c.place), eyeNorth());
    ASSERT_EQ(marks.size(), 1u);
    EXPECT_EQ(marks[0].kind, HudMark::Kind::toTarget);
    EXPECT_EQ(marks[0].place.x, c.x);
  }
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    EXPECT_TRUE(hudMarks(withTarget({bad, 0, 0}), eyeNorth()).empty());
  game::Snapshot crashed = withTarget({3000, 0, 0});
  crashed.aircraft.crashed = true;
  EXPECT_TRUE(hudMarks(crashed, eyeNorth()).empty());
}

TEST(HudMarks, inABankTheArrowPointsAlongTheMap) {
  // Banked by 60 degrees to the left the land on the left lies below the picture: still left.
  Eye eye = eyeNorth();
  const double c = 0.5, s = std::sqrt(0.75);
  // Rows right, up, back of a view rolled left: right points up.
  eye.worldToView =
      glm::transpose(glm::dmat3(glm::dvec3(c, s, 0), glm::dvec3(-s, c, 0), glm::dvec3(0, 0, 1)));
  const std::vector<HudMark> marks = hudMarks(withTarget({-900, 0, -700}), eye);
  ASSERT_EQ(marks.size(), 1u);
  EXPECT_EQ(marks[0].place.x, 0);
}

TEST(HudMarks, theNewestPackageHasItsLandingMarked) {
  // A place 300 m below and 300 m ahead is seen 45 degrees down: outside 60 degrees of view; one 1200 m ahead
  // lies at 180 + 180 tan(14 degrees) / tan(30).
  game::Snapshot snapshot;
  game::PackageSnapshot old, young;
  old.landed = true;
  young.landing = game::PackageLanding{{0, 0, -1200}, 12.3, 20.0, true};
  snapshot.packages = {young, old};
  Eye eye = eyeNorth();
  eye.fovYRad = 1.0471975512;
  const std::vector<HudMark> marks = hudMarks(snapshot, eye);
  ASSERT_EQ(marks.size(), 1u);
  EXPECT_TRUE(marks[0].isInTarget);
  EXPECT_EQ(marks[0].text, "12 s");
  EXPECT_NEAR(marks[0].place.x, 320, 1e-9);
  EXPECT_NEAR(marks[0].place.y, 180 + 180 * 0.25 / std::tan(1.0471975512 / 2), 1e-6);
  snapshot.packages[0].landing->position.z = -300;
  EXPECT_TRUE(hudMarks(snapshot, eye).empty());
  snapshot.packages[0].landing->position.z = 300;
  EXPECT_TRUE(hudMarks(snapshot, eye).empty()) << "behind the eye";
}

}  // namespace
}  // namespace skydrop::ui
