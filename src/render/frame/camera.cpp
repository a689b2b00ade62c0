#include "skydrop/render/frame/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "skydrop/core/error.h"
#include "skydrop/game/contact.h"

namespace skydrop::render {
namespace {

constexpr double kFreePitchLimit = std::numbers::pi / 4;

bool isFinite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

// A quaternion of length 0 would normalise to "no rotation" in silence.
void requireAttitude(const glm::dquat& q) {
  if (!(std::abs(glm::length(q) - 1) < 1e-3))
    throw core::RangeError("camera: the aircraft's attitude is not a rotation");
}

// Between the aircraft's attitude and the one that trails behind it.
glm::dquat followed(const game::AircraftSnapshot& aircraft, double softness) {
  const glm::dquat& q = aircraft.orientation;
  const glm::dquat trail = glm::dot(q, aircraft.trailingOrientation) < 0 ? -aircraft.trailingOrientation
                                                                         : aircraft.trailingOrientation;
  const double share = std::clamp(softness, 0.0, 1.0);
  return glm::normalize(q * (1 - share) + trail * share);
}

// The shaking of a stall: two small swings about pitch and roll, with frequencies (Hz) that do not fall
// together.
constexpr double kPitchShakeHz = 11, kRollShakeHz = 7.3;

glm::dquat shake(const game::Snapshot& snapshot, double degrees) {
  const double angle = glm::radians(degrees) * snapshot.aircraft.buffet;
  if (!(std::abs(angle) > 0)) return {1, 0, 0, 0};
  const auto swing = [&](double hertz) {
    return angle * std::sin(2 * std::numbers::pi * std::fmod(hertz * snapshot.simulatedSeconds, 1.0));
  };
  return glm::angleAxis(swing(kPitchShakeHz), glm::dvec3(1, 0, 0)) *
         glm::angleAxis(swing(kRollShakeHz), glm::dvec3(0, 0, 1));
}

// How far an eye this much below its least height rises, m: max(0, missing) with its corner rounded over 1 m
// to both sides, so that a ridge that comes up does not jerk the picture.
double raiseBy(double missing) {
  constexpr double kRound = 1;
  if (missing <= -kRound) return 0;
  return missing >= kRound ? missing : (missing + kRound) * (missing + kRound) / (4 * kRound);
}

// Lifts the eye out of the ground and turns the view by as much as the aircraft then moved in it.
void keepAbove(const terrain::HeightSource& ground, double clearance, const glm::dvec3& aircraft,
               glm::dvec3& eye, glm::dquat& orientation) {
  const double least = game::surfaceAt(ground, {eye.x, eye.z}).height + clearance;
  const double raise = raiseBy(least - eye.y);
  if (!(raise > 0)) return;
  const glm::dvec3 before = glm::normalize(aircraft - eye);
  eye.y += raise;
  const glm::dvec3 after = glm::normalize(aircraft - eye);
  const double cosine = glm::dot(before, after);
  if (cosine < -0.999) return;  // straight above instead of straight below: any way round will do
  orientation = glm::normalize(glm::dquat(1 + cosine, glm::cross(before, after)) * orientation);
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
  glm::dvec3 moved = position_ + glm::transpose(worldToView()) * (rightUpForward * glm::dvec3(1, 1, -1));
  moved.y = std::min(moved.y, std::max(kHighestCameraM, position_.y));
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

View Camera::view(const game::Snapshot& snapshot, const CameraSettings& settings, int width, int height,
                  const terrain::HeightSource* ground) const {
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
    const glm::dquat orientation =
        glm::normalize(aircraft.orientation) * shake(snapshot, settings.buffetDegrees);
    view.worldToView = glm::transpose(glm::mat3_cast(orientation));
  } else {
    requireAttitude(aircraft.orientation);
    requireAttitude(aircraft.trailingOrientation);
    glm::dquat orientation = followed(aircraft, settings.chaseSoftness);
    const glm::dvec3 eye(0, settings.chaseHeight, settings.chaseDistance);
    view.position = aircraft.position + orientation * eye;
    if (!isFinite(view.position)) throw core::RangeError("camera: the aircraft's place is not finite");
    if (ground) keepAbove(*ground, settings.groundClearance, aircraft.position, view.position, orientation);
    orientation = glm::normalize(orientation * shake(snapshot, settings.buffetDegrees));
    view.worldToView = glm::transpose(glm::mat3_cast(orientation));
  }
  requireValid(view);
  return view;
}

}  // namespace skydrop::render
