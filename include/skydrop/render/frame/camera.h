#pragma once

#include <glm/mat4x4.hpp>
#include <string_view>

#include "skydrop/flight/environment.h"
#include "skydrop/game/snapshot.h"
#include "skydrop/render/frame/render_settings.h"
#include "skydrop/render/frame/view.h"
#include "skydrop/terrain/height_source.h"

namespace skydrop::render {

// No camera in the world stands higher (m, above the sea); docs/rendering.md shows why.
inline constexpr double kHighestCameraM = flight::kCeiling;

enum class CameraMode { chase, cockpit, free };
std::string_view cameraModeName(CameraMode mode);

// From where the game is seen. The free camera looks along <cos yaw cos pitch, sin pitch, sin yaw cos pitch>,
// with pitch within +-45 degrees; set by pose it takes any attitude, straight up and upside down included.
// The other two ride the aircraft and roll with it: they take its orientation as it is, so no attitude is
// singular. The chase camera swings round the aircraft's place at the moment that is drawn, by the attitude
// that trails behind its own (game::AircraftSnapshot): the aircraft stays where it is in the picture and is
// seen to turn in it. A view is a function of camera, settings, snapshot and land, never of time passed.
class Camera {
 public:
  CameraMode mode() const { return mode_; }
  void setMode(CameraMode mode) { mode_ = mode; }
  // chase, cockpit, free, chase ...
  void nextMode();

  const glm::dvec3& position() const { return position_; }
  double yawRad() const { return yawRad_; }
  double pitchRad() const { return pitchRad_; }
  double rollRad() const { return rollRad_; }
  glm::dvec3 direction() const;

  // Any attitude; angles in radians, roll positive right side down. Throws core::RangeError for a value that
  // is not finite.
  void setPose(const glm::dvec3& position, double yawRad, double pitchRad, double rollRad);
  // The free camera where this view is, so that a change to it moves nothing. The view must be valid.
  void standAt(const View& view);
  // The free camera's own moves: metres along right, up and forward; radians, pitch kept within +-45 degrees.
  // Level again after a pose with roll, and no higher than kHighestCameraM.
  void move(const glm::dvec3& rightUpForward);
  void turn(double yawRad, double pitchRad);

  // The free camera's R^T T(-p).
  glm::dmat4 getView() const;

  // The view of this mode, valid (requireValid). Without an aircraft: the free camera, whatever the mode.
  // With `ground` the chase camera keeps above it. Throws core::RangeError if the aircraft's place or
  // attitude is not finite.
  View view(const game::Snapshot& snapshot, const CameraSettings& settings, int width, int height,
            const terrain::HeightSource* ground = nullptr) const;

 private:
  glm::dmat3 worldToView() const;

  CameraMode mode_ = CameraMode::chase;
  glm::dvec3 position_{0};
  double yawRad_ = 0, pitchRad_ = 0, rollRad_ = 0;
};

}  // namespace skydrop::render
