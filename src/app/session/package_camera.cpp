#include "app/session/package_camera.h"

#include <algorithm>
#include <cmath>

#include "skydrop/game/contact.h"
#include "skydrop/render/frame/camera.h"

namespace skydrop::app {
namespace {

// Behind and above the box, m: the open canopy is in the picture too.
constexpr double kBehind = 17, kAbove = 5;
// What is looked at, above the box.
constexpr double kLooksAbove = 2;
constexpr double kClearance = 2.5;  // of the eye above land and sea, m

}  // namespace

const game::PackageSnapshot* newestPackage(const game::Snapshot& now) {
  return now.packages.empty() ? nullptr : &now.packages.back();
}

bool PackageCamera::begin(const game::Snapshot& now) {
  const game::PackageSnapshot* package = newestPackage(now);
  if (!package) return false;
  package_ = package->id;
  landedAt_.reset();
  const glm::dvec3& v = package->velocity;
  headingRad_ = std::hypot(v.x, v.z) > 1 ? std::atan2(v.x, -v.z) : now.aircraft.headingRad;
  if (!std::isfinite(headingRad_)) headingRad_ = 0;
  return true;
}

bool PackageCamera::follow(const game::Snapshot& now) {
  if (!package_) return false;
  const auto package = std::ranges::find(now.packages, *package_, &game::PackageSnapshot::id);
  if (package == now.packages.end()) {
    end();
    return false;
  }
  if (package->landed && !landedAt_) landedAt_ = now.simulatedSeconds;
  if (landedAt_ && now.simulatedSeconds - *landedAt_ > kStaysSeconds) end();
  return rides();
}

std::optional<render::View> PackageCamera::view(const game::Snapshot& now,
                                                const render::CameraSettings& settings, Size size,
                                                const terrain::HeightSource* ground) const {
  if (!package_) return {};
  const auto package = std::ranges::find(now.packages, *package_, &game::PackageSnapshot::id);
  if (package == now.packages.end()) return {};
  const glm::dvec3 ahead(std::sin(headingRad_), 0, -std::cos(headingRad_));
  const glm::dvec3 aim = package->position + glm::dvec3(0, kLooksAbove, 0);
  glm::dvec3 eye = package->position - ahead * kBehind + glm::dvec3(0, kAbove, 0);
  if (ground) eye.y = std::max(eye.y, game::surfaceAt(*ground, {eye.x, eye.z}).height + kClearance);
  const double down = std::atan2(aim.y - eye.y, kBehind);
  render::Camera camera;
  camera.setMode(render::CameraMode::free);
  // The camera's yaw counts from +x.
  camera.setPose(eye, std::atan2(ahead.z, ahead.x), down, 0);
  return camera.view(now, settings, size.width, size.height);
}

}  // namespace skydrop::app
