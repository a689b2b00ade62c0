#include "app/session/pose_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <random>

#include "app/cli/command_line_parser.h"
#include "skydrop/render/frame/camera.h"

namespace skydrop::app {
namespace {

// The view that `skydrop render` makes of the words.
render::View viewOf(const std::string& words, int width, int height) {
  const char* const argv[] = {"skydrop", "render", words.c_str()};
  const Pose pose = parseCommandLine(3, argv).commandLine.pose.value();
  render::Camera camera;
  camera.setMode(render::CameraMode::free);
  camera.setPose(pose.position, glm::radians(pose.yawDegrees), glm::radians(pose.pitchDegrees),
                 glm::radians(pose.rollDegrees));
  return camera.view({}, {}, width, height);
}

render::View viewWith(const glm::dmat3& viewToWorld, const glm::dvec3& position) {
  render::View view = render::Camera().view({}, {}, 3840, 2160);
  view.position = position;
  view.worldToView = glm::transpose(viewToWorld);
  return view;
}

// How far a direction seen at the edge of the picture may move on it.
double pixelsBetween(const render::View& a, const render::View& b) {
  double most = 0;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      most = std::max(most, std::abs(a.worldToView[column][row] - b.worldToView[column][row]));
    }
  }
  const double pixelsPerUnit = a.height / (2 * std::tan(a.fovYRad / 2));
  return most * 4 * pixelsPerUnit;  // 4: from the axis to the corner of a wide picture the scale grows less
}

TEST(PoseText, theWordsGiveTheSameViewBack) {
  // Over random attitudes, places as far as the world is used, and the attitudes that have no heading: within
  // a hundredth of a pixel at 4K, and the place bit for bit.
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  std::vector<glm::dquat> attitudes = {{1, 0, 0, 0}};
  for (int i = 0; i < 300; ++i) {
    attitudes.push_back(
        glm::normalize(glm::dquat(normal(random), normal(random), normal(random), normal(random))));
  }
  for (const double pitch : {90.0, -90.0, 90.0 - 1e-7, -90.0 + 1e-10, 89.9}) {
    for (const double roll : {0.0, 30.0, 180.0}) {
      attitudes.push_back(glm::angleAxis(0.7, glm::dvec3(0, 1, 0)) *
                          glm::angleAxis(glm::radians(pitch), glm::dvec3(1, 0, 0)) *
                          glm::angleAxis(glm::radians(roll), glm::dvec3(0, 0, 1)));
    }
  }
  double worst = 0;
  for (const glm::dquat& attitude : attitudes) {
    const glm::dvec3 position(normal(random) * 1e9, normal(random) * 1e3, -1234.5678901234567);
    const render::View view = viewWith(glm::mat3_cast(attitude), position);
    const render::View back = viewOf(poseText(poseOf(view)), view.width, view.height);
    EXPECT_EQ(back.position, view.position);
    worst = std::max(worst, pixelsBetween(view, back));
  }
  EXPECT_LT(worst, 0.01);
}

TEST(PoseText, aPoseComesBackAsItWasGiven) {
  const Pose pose{{-2300, 1000.1, -5200}, 165, -10, 50};
  EXPECT_EQ(poseText(pose), "--pose=-2300,1000.1,-5200,165,-10,50");
  const Pose back = poseOf(viewOf(poseText(pose), 320, 180));
  EXPECT_NEAR(back.yawDegrees, 165, 1e-12);
  EXPECT_NEAR(back.pitchDegrees, -10, 1e-12);
  EXPECT_NEAR(back.rollDegrees, 50, 1e-12);
}

}  // namespace
}  // namespace skydrop::app
