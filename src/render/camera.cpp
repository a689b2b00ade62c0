#include "skydrop/render/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "skydrop/core/error.h"

namespace skydrop::render {
namespace {

constexpr double kFreePitchLimit = std::numbers::pi / 4;

bool isFinite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

// A quaternion of length 0 would normalise to "no rotation" in silence.
void requireAttitude(const glm::dquat& q) {
  if (!(std::abs(glm::length(q) - 1) < 1e-3))
    throw core::RangeError("camera: the aircraft's attitude is not a rotation");
}

// The chase camera hangs back by what the aircraft turned in the last moments. This is a function of the
// state, not of a history, so the same state gives the same view at any frame rate.
glm::dquat lagged(const game::AircraftSnapshot& aircraft, double seconds) {
  const glm::dvec3 turn = aircraft.angularVelocityBody * -seconds;
  const double angle = glm::length(turn);
  if (!(angle > 1e-9)) return aircraft.orientation;
  return glm::normalize(aircraft.orientation * glm::angleAxis(angle, turn / angle));
}

}  // namespace

std::string_view cameraModeName(CameraMode mode) {
  switch (mode) {
    case CameraMode::chase:
      return "chase";
    case CameraMode::cockpit:
      return "cockpit";
    case CameraMode::free:
      return "free";
  }
  return "";
}

void Camera::nextMode() {
  mode_ = mode_ == CameraMode::chase     ? CameraMode::cockpit
          : mode_ == CameraMode::cockpit ? CameraMode::free
                                         : CameraMode::chase;
}

glm::dvec3 Camera::direction() const {
  return {std::cos(yawRad_) * std::cos(pitchRad_), std::sin(pitchRad_),
          std::sin(yawRad_) * std::cos(pitchRad_)};
}

void Camera::setPose(const glm::dvec3& position, double yawRad, double pitchRad, double rollRad) {
  if (!isFinite(position) || !isFinite({yawRad, pitchRad, rollRad})) {
    throw core::RangeError("camera: position and angles must be finite");
  }
  position_ = position;
  yawRad_ = yawRad;
  pitchRad_ = pitchRad;
  rollRad_ = rollRad;
}

void Camera::standAt(const View& view) {
  const glm::dvec3 forward = view.forward(), right = view.right();
  position_ = view.position;
  pitchRad_ = std::asin(std::clamp(forward.y, -1.0, 1.0));
  // Straight up or down any yaw will do: then roll says all.
  yawRad_ = std::hypot(forward.x, forward.z) > 1e-9 ? std::atan2(forward.z, forward.x) : 0;
  const glm::dvec3 level(-std::sin(yawRad_), 0, std::cos(yawRad_));
  rollRad_ = std::atan2(-glm::dot(right, glm::cross(level, forward)), glm::dot(right, level));
}

void Camera::move(const glm::dvec3& rightUpForward) {
  const glm::dvec3 moved =
      position_ + glm::transpose(worldToView()) * (rightUpForward * glm::dvec3(1, 1, -1));
  if (isFinite(moved)) position_ = moved;
}

void Camera::turn(double yawRad, double pitchRad) {
  if (!std::isfinite(yawRad) || !std::isfinite(pitchRad)) return;
  yawRad_ = std::remainder(yawRad_ + yawRad, 2 * std::numbers::pi);
  pitchRad_ = std::clamp(pitchRad_ + pitchRad, -kFreePitchLimit, kFreePitchLimit);
  rollRad_ = 0;
}

// Right is taken from the yaw alone: d x up would vanish where the camera looks straight up or down.
glm::dmat3 Camera::worldToView() const {
  const glm::dvec3 forward = direction();
  const glm::dvec3 level(-std::sin(yawRad_), 0, std::cos(yawRad_));
  const glm::dvec3 above = glm::cross(level, forward);
  const glm::dvec3 right = level * std::cos(rollRad_) - above * std::sin(rollRad_);
  const glm::dvec3 up = above * std::cos(rollRad_) + level * std::sin(rollRad_);
  return glm::transpose(glm::dmat3(right, up, -forward));
}

glm::dmat4 Camera::getView() const {
  glm::dmat4 translation(1);
  translation[3] = glm::dvec4(-position_, 1);
  return glm::dmat4(worldToView()) * translation;
}

View Camera::view(const game::Snapshot& snapshot, const CameraSettings& settings, int width,
                  int height) const {
  View view;
  view.fovYRad = glm::radians(settings.fovDegrees);
  view.nearM = settings.nearM;
  view.width = width;
  view.height = height;
  const game::AircraftSnapshot& aircraft = snapshot.aircraft;
  if (mode_ == CameraMode::free || !aircraft.present) {
    view.position = position_;
    view.worldToView = worldToView();
  } else if (mode_ == CameraMode::cockpit) {
    requireAttitude(aircraft.orientation);
    const glm::dvec3 eye(0, settings.cockpitHeight, -settings.cockpitForward);
    view.position = aircraft.position + aircraft.orientation * eye;
    view.worldToView = glm::transpose(glm::mat3_cast(glm::normalize(aircraft.orientation)));
  } else {
    requireAttitude(aircraft.orientation);
    const glm::dquat orientation = lagged(aircraft, settings.chaseLag);
    const glm::dvec3 eye(0, settings.chaseHeight, settings.chaseDistance);
    view.position = aircraft.position + orientation * eye;
    view.worldToView = glm::transpose(glm::mat3_cast(glm::normalize(orientation)));
  }
  requireValid(view);
  return view;
}

}  // namespace skydrop::render
