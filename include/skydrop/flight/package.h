// The package: a box that falls, tumbles, opens a parachute and drifts down. A rigid body; its translation is
// solved exactly (linear_drag.h), its rotation by the default integrator. Deterministic, not thread-safe. It
// knows nothing of the ground: who owns it stops it there (land()).
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "skydrop/flight/linear_drag.h"
#include "skydrop/flight/package_settings.h"
#include "skydrop/flight/rigid_body.h"

namespace skydrop::flight {

// Share of the canopy that is open `age` seconds after the release: 0 before the delay, then a smooth step
// to 1.
double parachuteOpenAt(const PackageSettings& settings, double age);

// Drag rate in 1/s at a share of opening. Terminal speed is kGravity over it.
double dragRateAt(const PackageSettings& settings, double open);

// The translation over dt >= 0 seconds from `age` (s since the release) on. Exact but while the canopy opens,
// where the error is of order 4; the step is cut where the opening begins and ends, wherever in it that is.
PointState packageStep(const PackageSettings& settings, PointState state, double age, const glm::dvec3& wind,
                       double dt);

class Package {
 public:
  // Released from a body in this state. Throws core::RangeError when settings or state are unusable.
  Package(const PackageSettings& settings, const BodyState& release);

  // Advances by dt > 0 seconds; a landed package stays as it is. Translation and rotation are of order 4,
  // also in steps in which the opening begins or ends.
  void step(const glm::dvec3& wind, double dt);
  // Comes to rest at this position.
  void land(const glm::dvec3& position);

  const BodyState& state() const { return body_.state(); }
  double age() const { return age_; }  // s since the release, does not count on the ground
  double parachuteOpen() const { return parachuteOpenAt(settings_, age_); }
  bool landed() const { return landed_; }

 private:
  PackageSettings settings_;
  RigidBody body_;
  double age_ = 0;
  bool landed_ = false;
};

// Where and when a package in this state would land, `age` seconds after its release, on a surface given by
// its height at (x, z); the same equations as the package itself, longer steps. Empty when it is still in the
// air kLongestFallSeconds after the release, and for a state, an age or a wind that is no number.
struct Landing {
  glm::dvec3 position{0};
  double seconds = 0;  // from this state on
};
inline constexpr double kLongestFallSeconds = 3600;
std::optional<Landing> predictLanding(const PackageSettings& settings, const PointState& state,
                                      const glm::dvec3& wind,
                                      const std::function<double(const glm::dvec2&)>& surfaceHeight,
                                      double age = 0);
// The same in a wind that changes with the place: asked at the middle of each step, which then is at most a
// fifth of the height above the surface or 6 m high. The surface's height there is handed along.
using WindField = std::function<glm::dvec3(const glm::dvec3& position, double surfaceHeight)>;
std::optional<Landing> predictLanding(const PackageSettings& settings, const PointState& state,
                                      const WindField& wind,
                                      const std::function<double(const glm::dvec2&)>& surfaceHeight,
                                      double age = 0);

}  // namespace skydrop::flight
