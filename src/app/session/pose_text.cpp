#include "app/session/pose_text.h"

#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace skydrop::app {
namespace {

constexpr double kLevelEnough = 1e-12;  // share of the view that is horizontal; below it the heading is noise

}  // namespace

Pose poseOf(const render::View& view) {
  const glm::dvec3 forward = view.forward(), right = view.right(), up = view.up();
  const double level = std::hypot(forward.x, forward.z);
  // Looking straight up or down every heading will do, with the roll that belongs to it.
  const double yaw = level > kLevelEnough ? std::atan2(forward.z, forward.x) : std::atan2(-right.x, right.z);
  const double pitch = std::atan2(forward.y, level);
  const glm::dvec3 levelRight(-std::sin(yaw), 0, std::cos(yaw));
  const double roll = std::atan2(glm::dot(up, levelRight), glm::dot(right, levelRight));
  return {view.position, glm::degrees(yaw), glm::degrees(pitch), glm::degrees(roll)};
}

std::string poseText(const Pose& pose) {
  std::string text = "--pose";
  char separator = '=';
  for (const double value : {pose.position.x, pose.position.y, pose.position.z, pose.yawDegrees,
                             pose.pitchDegrees, pose.rollDegrees}) {
    char digits[32];
    text += separator;
    text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
    separator = ',';
  }
  return text;
}

}  // namespace skydrop::app
