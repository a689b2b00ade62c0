#include "skydrop/render/frame/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <numbers>
#include <vector>

#include "skydrop/core/error.h"
#include "skydrop/core/hash.h"
#include "skydrop/game/world.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "support/margin.h"

namespace skydrop::render {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The largest deviation of R R^T from the identity, and of the determinant from 1.
double rotationError(const glm::dmat3& m) {
  const glm::dmat3 product = m * glm::transpose(m);
  double worst = std::abs(glm::determinant(m) - 1);
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      worst = std::max(worst, std::abs(product[column][row] - (column == row ? 1.0 : 0.0)));
    }
  }
  return worst;
}

game::Snapshot withAircraft(const glm::dvec3& position, const glm::dquat& orientation) {
  game::Snapshot snapshot;
  snapshot.aircraft.present = true;
  snapshot.aircraft.position = position;
  snapshot.aircraft.orientation = snapshot.aircraft.trailingOrientation = orientation;
  return snapshot;
}

TEST(Stability, P11_posesOfEveryAttitudeAreRotations) {
  // Straight up and down, upside down, and a thousand random attitudes: orthonormal within 1e-6,
  // determinant 1.
  Camera camera;
  camera.setMode(CameraMode::free);
  core::RandomStream random{11, 0};
  for (int i = 0; i < 1000; ++i) {
    const double pitch = i < 100 ? (i % 2 ? kPi / 2 : -kPi / 2) : (random.nextUnit() - 0.5) * 4 * kPi;
    camera.setPose({0, 0, 0}, random.nextUnit() * 20 - 10, pitch, i % 3 ? random.nextUnit() * 7 : kPi);
    const View view = camera.view({}, {}, 320, 180);
    ASSERT_TRUE(test::holds("P11", rotationError(view.worldToView), test::below(1e-6), "of a unit matrix"));
    // The camera looks where the formula of the free camera says.
    ASSERT_TRUE(test::holds("P11", glm::distance(view.forward(), camera.direction()), test::below(1e-12),
                            "of length 1"));
  }
}

TEST(Stability, P11_camerasOnTheAircraftHaveNoSingularAttitude) {
  // Nose straight up and down, inverted, knife edge, random: both riding cameras roll along and stay
  // rotations.
  core::RandomStream random{12, 0};
  for (int i = 0; i < 1000; ++i) {
    glm::dquat q(random.nextUnit() - 0.5, random.nextUnit() - 0.5, random.nextUnit() - 0.5,
                 random.nextUnit() - 0.5);
    if (i == 0) q = glm::angleAxis(kPi / 2, glm::dvec3(1, 0, 0));
    if (i == 1) q = glm::angleAxis(-kPi / 2, glm::dvec3(1, 0, 0));
    if (i == 2) q = glm::angleAxis(kPi, glm::dvec3(0, 0, 1));
    if (i == 3) q = glm::angleAxis(kPi / 2, glm::dvec3(0, 0, 1));
    q = glm::normalize(q);
    game::Snapshot snapshot = withAircraft({1e6, 500, -2e6}, q);
    for (const CameraMode mode : {CameraMode::cockpit, CameraMode::chase}) {
      Camera camera;
      camera.setMode(mode);
      const View view = camera.view(snapshot, {}, 320, 180);
      ASSERT_TRUE(test::holds("P11", rotationError(view.worldToView), test::below(1e-6), "of a unit matrix"));
      ASSERT_TRUE(test::holds("P11", glm::distance(view.forward(), q * glm::dvec3(0, 0, -1)),
                              test::below(1e-9), "of length 1"));
      ASSERT_TRUE(test::holds("P11", glm::distance(view.up(), q * glm::dvec3(0, 1, 0)), test::below(1e-9),
                              "of length 1"));
    }
    // Turning fast, the chase camera hangs back by any angle and stays a rotation.
    snapshot.aircraft.trailingOrientation =
        glm::normalize(q * glm::angleAxis(random.nextUnit() * kPi, glm::normalize(glm::dvec3(2, -3, 5))));
    ASSERT_TRUE(test::holds("P11", rotationError(Camera().view(snapshot, {}, 320, 180).worldToView),
                            test::below(1e-6), "of a unit matrix"));
  }
}

TEST(Stability, P11_freeCameraKeepsItsPitchWithinFortyFiveDegrees) {
  // However hard the mouse pulls, and whatever pose came before.
  test::noFaults("P11", "violations");
  Camera camera;
  camera.setPose({0, 0, 0}, 0, kPi / 2, 1);
  camera.turn(0, 10);
  EXPECT_DOUBLE_EQ(camera.pitchRad(), kPi / 4);
  EXPECT_EQ(camera.rollRad(), 0);
  camera.turn(100, -20);
  EXPECT_DOUBLE_EQ(camera.pitchRad(), -kPi / 4);
  EXPECT_LE(std::abs(camera.yawRad()), kPi);
}

TEST(Stability, C27_cameraThatIsNotFiniteIsRejected) {
  // A NaN camera can draw a plausible picture; it is refused before anything is drawn, in one line.
  test::noFaults("C27", "values that are not finite");
  Camera camera;
  for (const double bad : {kNaN, kInfinity, -kInfinity}) {
    EXPECT_THROW(camera.setPose({bad, 0, 0}, 0, 0, 0), core::RangeError);
    EXPECT_THROW(camera.setPose({0, 0, 0}, bad, 0, 0), core::RangeError);
    EXPECT_THROW(camera.setPose({0, 0, 0}, 0, bad, 0), core::RangeError);
    EXPECT_THROW(camera.setPose({0, 0, 0}, 0, 0, bad), core::RangeError);
    EXPECT_THROW(camera.view(withAircraft({0, bad, 0}, {1, 0, 0, 0}), {}, 320, 180), core::RangeError);
    EXPECT_THROW(camera.view(withAircraft({0, 0, 0}, {bad, 0, 0, 0}), {}, 320, 180), core::RangeError);
    camera.turn(bad, bad);
    camera.move({bad, 0, 0});
    EXPECT_EQ(camera.position(), glm::dvec3(0));
    EXPECT_EQ(camera.yawRad(), 0);
  }
  EXPECT_THROW(camera.view(withAircraft({0, 0, 0}, {0, 0, 0, 0}), {}, 320, 180), core::RangeError);
}

TEST(Stability, C27_viewsThatCannotBeDrawnAreRejected) {
  // Every field at its edge: scaled, mirrored or NaN rotations, no field of view, no pixels, no near plane.
  test::noFaults("C27", "inputs accepted");
  const auto refuses = [](auto change) {
    View view;
    change(view);
    EXPECT_THROW(requireValid(view), core::RangeError);
  };
  requireValid(View{});
  refuses([](View& v) { v.worldToView *= 1.001; });
  refuses([](View& v) { v.worldToView[0] = -v.worldToView[0]; });
  refuses([](View& v) { v.worldToView[1][1] = kNaN; });
  refuses([](View& v) { v.position.z = kInfinity; });
  refuses([](View& v) { v.fovYRad = 0; });
  refuses([](View& v) { v.fovYRad = kNaN; });
  refuses([](View& v) { v.nearM = 0; });
  refuses([](View& v) { v.nearM = kNaN; });
  refuses([](View& v) { v.width = 0; });
  refuses([](View& v) { v.height = 16385; });
}

// A roll to the right and a pull, then hands off: what a player does in the first seconds.
game::Controls inputAt(double seconds) {
  const double hold = std::clamp(seconds / 0.3, 0.0, 1.0), back = std::clamp((seconds - 1.5) / 0.2, 0.0, 1.0);
  const double stick = hold * hold * (3 - 2 * hold) - back * back * (3 - 2 * back);
  return {.pitch = 0.5 * stick, .roll = stick};
}

struct Drawn {
  View view;
  game::Snapshot snapshot;
};

// What a window with this many frames a second draws in three seconds of it, through the real world's steps.
std::vector<Drawn> flown(double framesPerSecond) {
  game::WorldSetup setup;
  setup.ground = terrain::makeFlatSource(0);
  setup.hasTargets = false;
  game::World world(setup);
  std::vector<Drawn> frames;
  for (int frame = 0; frame <= static_cast<int>(3 * framesPerSecond); ++frame) {
    const double steps = frame / framesPerSecond * 120;
    while (static_cast<double>(world.stepCount()) < steps)
      world.step(inputAt(static_cast<double>(world.stepCount()) / 120));
    const game::Snapshot snapshot = world.interpolated(1 - (static_cast<double>(world.stepCount()) - steps));
    frames.push_back({Camera().view(snapshot, {}, 640, 360, setup.ground.get()), snapshot});
  }
  return frames;
}

TEST(Camera, theChaseCameraTurnsWithoutJerksAcrossTheSimulationsSteps) {
  // Drawn at 1200 frames a second, ten to a step, the view's turning rate changes from frame to frame by less
  // than .02 rad/s in a roll of .8 rad/s: no step of the simulation is seen.
  const std::vector<Drawn> frames = flown(1200);
  glm::dvec3 last(0);
  double fastest = 0, worst = 0;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const glm::dquat a = glm::quat_cast(frames[i - 1].view.worldToView),
                     b = glm::quat_cast(frames[i].view.worldToView);
    glm::dquat turn = glm::conjugate(a) * b;
    if (turn.w < 0) turn = -turn;
    const glm::dvec3 rate = 2.0 * 1200 * glm::dvec3(turn.x, turn.y, turn.z);
    fastest = std::max(fastest, glm::length(rate));
    if (i > 1) worst = std::max(worst, glm::length(rate - last));
    last = rate;
  }
  EXPECT_GT(fastest, 0.5);
  EXPECT_LT(worst, 0.02);
}

TEST(Camera, theSameMomentLooksTheSameAtThirtySixtyAndOneHundredAndFortyFourFrames) {
  // After each whole second the eye is in the same place within 1e-9 m, whatever was drawn between.
  const std::vector<Drawn> reference = flown(30);
  for (const int rate : {60, 144}) {
    const std::vector<Drawn> frames = flown(rate);
    for (int second = 0; second <= 3; ++second) {
      const View &a = reference[static_cast<std::size_t>(30 * second)].view,
                 &b = frames[static_cast<std::size_t>(rate * second)].view;
      EXPECT_LT(glm::distance(a.position, b.position), 1e-9) << rate;
      EXPECT_LT(glm::distance(a.forward(), b.forward()), 1e-12) << rate;
    }
  }
}

TEST(Camera, theAircraftStaysInItsPlaceOfThePictureHoweverItTurns) {
  // Seen from the chase camera the aircraft's middle is where it is in level flight, within 1e-9 rad, in
  // every frame of a roll with a pull; and the camera never starts against the roll.
  for (const Drawn& frame : flown(144)) {
    const glm::dvec3 seen = glm::dmat3(frame.view.worldToView) *
                            glm::normalize(frame.snapshot.aircraft.position - frame.view.position);
    const CameraSettings settings;
    const glm::dvec3 level = glm::normalize(glm::dvec3(0, -settings.chaseHeight, -settings.chaseDistance));
    ASSERT_LT(glm::distance(seen, level), 1e-9);
    // Right side down: the world's up leans to the left of the picture, or not yet.
    ASSERT_LT((glm::dmat3(frame.view.worldToView) * glm::dvec3(0, 1, 0)).x, 1e-9);
  }
}

TEST(Camera, theChaseCameraKeepsAboveTheGroundAndTheAircraftInView) {
  // 2 m above the ground with the nose up the eye would be 5 m under it: it stays 2 m above, and the aircraft
  // where it was in the picture. Coming up through the rounded corner it never jumps: at most 1.2 times what
  // the aircraft moved.
  const auto ground = terrain::makeFlatSource(100);
  const glm::dquat noseUp = glm::angleAxis(0.5, glm::dvec3(1, 0, 0));
  Camera camera;
  double lastY = 0;
  for (int i = 0; i <= 2000; ++i) {
    const game::Snapshot snapshot = withAircraft({0, 102 + 0.01 * i, 0}, noseUp);
    const View view = camera.view(snapshot, {}, 640, 360, ground.get());
    ASSERT_GE(view.position.y, 102 - 1e-9);
    ASSERT_TRUE(i == 0 || std::abs(view.position.y - lastY) < 0.012) << i;
    lastY = view.position.y;
    const glm::dvec3 seen =
        glm::dmat3(view.worldToView) * glm::normalize(snapshot.aircraft.position - view.position);
    ASSERT_LT(glm::distance(seen, glm::normalize(glm::dvec3(0, -2.8, -15))), 1e-9);
    ASSERT_LT(rotationError(view.worldToView), 1e-6);
  }
  EXPECT_NEAR(lastY, 122 + 2.8 * std::cos(0.5) - 15 * std::sin(0.5), 1e-9) << "far above it is left alone";
}

TEST(Camera, aStallShakesThePictureAndNothingElseDoes) {
  // Full buffet: the view swings by no more than the setting about each axis, and is another a moment later;
  // without buffet the same moments look the same.
  Camera camera;
  camera.setMode(CameraMode::cockpit);
  game::Snapshot still = withAircraft({0, 500, 0}, {1, 0, 0, 0}), shaken = still;
  shaken.aircraft.buffet = 1;
  double most = 0;
  for (int i = 0; i < 100; ++i) {
    still.simulatedSeconds = shaken.simulatedSeconds = 1000 + i / 60.0;
    EXPECT_LT(glm::distance(camera.view(still, {}, 640, 360).forward(), glm::dvec3(0, 0, -1)), 1e-12);
    most = std::max(most, glm::distance(camera.view(shaken, {}, 640, 360).forward(), glm::dvec3(0, 0, -1)));
  }
  EXPECT_GT(most, 0.8 * 0.35 * kPi / 180);
  EXPECT_LE(most, 0.35 * kPi / 180 * (1 + 1e-9));
}

TEST(Camera, freeViewIsTheTransposedRotationAfterTheTranslation) {
  // N4: getView() = R^T T(-p). Yaw 0 looks along +x; what lies ahead is at -z of the view, what lies right at
  // +x.
  Camera camera;
  camera.setPose({10, 20, 30}, 0, 0, 0);
  EXPECT_LT(glm::distance(camera.getView() * glm::dvec4(15, 20, 30, 1), glm::dvec4(0, 0, -5, 1)), 1e-12);
  EXPECT_LT(glm::distance(camera.getView() * glm::dvec4(10, 20, 33, 1), glm::dvec4(3, 0, 0, 1)), 1e-12);
  camera.setPose({0, 0, 0}, kPi / 2, kPi / 6, 0);
  EXPECT_LT(glm::distance(camera.direction(), glm::dvec3(0, 0.5, std::sqrt(0.75))), 1e-12);
  // Right side down: the world's up leans to the left of the picture.
  camera.setPose({0, 0, 0}, 0, 0, 0.1);
  EXPECT_LT((camera.getView() * glm::dvec4(0, 1, 0, 0)).x, -0.09);
}

TEST(Camera, theFreeCameraTakesOverAViewOfAnyAttitude) {
  // Standing where a ride of any attitude was, straight up and down included, it sees the same.
  for (double pitch = -90; pitch <= 90; pitch += 30) {
    for (double yaw = -180; yaw <= 150; yaw += 30) {
      for (double roll = -180; roll <= 150; roll += 30) {
        Camera ride;
        ride.setMode(CameraMode::free);
        ride.setPose({1e6, 20, -3e6}, glm::radians(yaw), glm::radians(pitch), glm::radians(roll));
        const View seen = ride.view({}, {}, 64, 36);
        Camera camera;
        camera.setMode(CameraMode::free);
        camera.standAt(seen);
        const View again = camera.view({}, {}, 64, 36);
        EXPECT_EQ(again.position, seen.position);
        for (int column = 0; column < 3; ++column) {
          // asin near 1 keeps half of a double's digits.
          EXPECT_LT(glm::length(again.worldToView[column] - seen.worldToView[column]), 1e-7)
              << yaw << " " << pitch << " " << roll;
        }
      }
    }
  }
}

TEST(Camera, withoutAnAircraftEveryModeIsFree) {
  // A scene without an aircraft is seen from the pose, and the order of the modes is chase, cockpit, free.
  Camera camera;
  camera.setPose({1, 2, 3}, 0, 0, 0);
  EXPECT_EQ(camera.view({}, {}, 320, 180).position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(camera.mode(), CameraMode::chase);
  camera.nextMode();
  EXPECT_EQ(camera.mode(), CameraMode::cockpit);
  camera.nextMode();
  EXPECT_EQ(camera.mode(), CameraMode::free);
  camera.nextMode();
  EXPECT_EQ(camera.mode(), CameraMode::chase);
}

TEST(View, raysGoThroughThePixelsTheyAreNamedAfter) {
  // A point along the ray of a pixel projects to that pixel, at odd sizes too, near and far. Limit: float
  // matrices, 1e-3 pixels.
  for (const auto& [width, height] : {std::pair{1, 1}, {7, 5}, {801, 601}, {1920, 1080}}) {
    Camera camera;
    camera.setMode(CameraMode::free);
    camera.setPose({1e7, 100, -1e7}, 0.7, -0.4, 0.3);
    const View view = camera.view({}, {}, width, height);
    for (const glm::dvec2 pixel :
         {glm::dvec2(0.5, 0.5), glm::dvec2(width - 0.5, 0.5), glm::dvec2(width, height) * 0.5}) {
      for (const double distance : {1.0, 1e5}) {
        const glm::dvec3 world = view.position + rayDirection(view, pixel) * distance;
        const glm::vec4 clip = viewProjection(view) * glm::vec4(relativeToEye(view, world), 1);
        const glm::dvec2 hit =
            (glm::dvec2(clip) / static_cast<double>(clip.w) * 0.5 + 0.5) * glm::dvec2(width, height);
        EXPECT_LT(glm::distance(hit, pixel), 1e-3);
        // Reversed depth: the near plane over the distance along the view axis.
        const double viewZ = glm::dot(world - view.position, view.forward());
        EXPECT_NEAR(static_cast<double>(clip.z / clip.w) * viewZ / view.nearM, 1, 1e-5);
      }
    }
  }
}

}  // namespace
}  // namespace skydrop::render
