#include "skydrop/game/lesson.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "skydrop/game/autopilot.h"
#include "skydrop/game/world.h"
#include "skydrop/terrain/analytic_height_sources.h"

namespace skydrop::game {
namespace {

Snapshot flying(double headingRad) {
  Snapshot now;
  now.aircraft.present = now.target.present = true;
  now.aircraft.position.y = 400;
  now.aircraft.headingRad = headingRad;
  now.target.bearingRad = 6.2;
  return now;
}

TEST(Lesson, goesOnByWhatIsDoneAndByNothingElse) {
  Lesson lesson;
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(lesson.update(flying(2)), Lesson::Step::turn);
  Snapshot banked = flying(6.2);
  banked.aircraft.bankRad = 0.6;
  EXPECT_EQ(lesson.update(banked), Lesson::Step::turn) << "still in the turn";
  EXPECT_EQ(lesson.update(flying(0.02)), Lesson::Step::height) << "ahead, across north";
  Snapshot higher = flying(0);
  higher.aircraft.position.y = 440;
  EXPECT_EQ(lesson.update(higher), Lesson::Step::height);
  higher.aircraft.position.y = 349;
  EXPECT_EQ(lesson.update(higher), Lesson::Step::drop) << "down counts as well";
  higher.misses = 3;
  EXPECT_EQ(lesson.update(higher), Lesson::Step::drop);
  higher.score = 1;
  EXPECT_EQ(lesson.update(higher), Lesson::Step::done);
  EXPECT_EQ(lesson.update(flying(2)), Lesson::Step::done);
}

TEST(Lesson, waitsWithoutAircraftTargetOrNumbers) {
  Lesson lesson;
  Snapshot now = flying(6.2);
  now.aircraft.crashed = true;
  EXPECT_EQ(lesson.update(now), Lesson::Step::turn);
  now = flying(6.2);
  now.target.present = false;
  EXPECT_EQ(lesson.update(now), Lesson::Step::turn);
  now = flying(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(lesson.update(now), Lesson::Step::turn);
  EXPECT_EQ(lesson.update({}), Lesson::Step::turn);
}

TEST(Lesson, canBeFlownToItsEnd) {
  // The autopilot does all three, with a climb when that is asked.
  WorldSetup setup;
  setup.ground = terrain::makeFlatSource(20);
  setup.start.headingDeg = 200;
  World world(setup);
  Autopilot pilot(setup.ground);
  Lesson lesson;
  for (int i = 0; i < 120 * 400 && lesson.step() != Lesson::Step::done; ++i) {
    Controls controls = pilot.decide(world.now());
    if (lesson.step() == Lesson::Step::height) controls = {.thrust = 1, .pitch = 0.5};
    world.step(controls);
    lesson.update(world.now());
  }
  EXPECT_EQ(lesson.step(), Lesson::Step::done);
}

}  // namespace
}  // namespace skydrop::game
