#include "skydrop/ui/hud_marks.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include "skydrop/core/guards.h"

namespace skydrop::ui {
namespace {

// A target this near the edge, as a share of the width, counts as out of view.
constexpr double kInset = 0.03;
// Tangent of the angle beside the eye's direction within which a target is ahead.
constexpr double kAhead = 0.3;
constexpr double kNearest = 0.1;  // m before the eye

glm::dvec3 inView(const Eye& eye, const glm::dvec3& world) {
  return eye.worldToView * (world - eye.position);
}

// Pixels; nothing behind the eye.
std::optional<glm::dvec2> pixelOf(const Eye& eye, const glm::dvec3& seen) {
  if (!core::isFinite(seen) || -seen.z < kNearest) return {};
  const double scale = eye.height / (2 * std::tan(eye.fovYRad / 2)) / -seen.z;
  const glm::dvec2 pixel(eye.width / 2 + seen.x * scale, eye.height / 2 - seen.y * scale);
  if (!std::isfinite(pixel.x) || !std::isfinite(pixel.y)) return {};
  return pixel;
}

bool isInside(const Eye& eye, const glm::dvec2& pixel, double inset) {
  return pixel.x >= inset && pixel.x <= eye.width - inset && pixel.y >= 0 && pixel.y <= eye.height;
}

}  // namespace

std::vector<HudMark> hudMarks(const game::Snapshot& snapshot, const Eye& eye) {
  std::vector<HudMark> marks;
  const auto add = [&](HudMark::Kind kind, const glm::dvec3& place, bool isInTarget, std::string text) {
    const auto pixel = pixelOf(eye, inView(eye, place));
    if (pixel && isInside(eye, *pixel, 0)) marks.push_back({kind, *pixel, isInTarget, std::move(text)});
  };
  for (auto package = snapshot.packages.rbegin(); package != snapshot.packages.rend(); ++package) {
    if (!package->landing) continue;
    std::array<char, 32> text{};
    if (std::isfinite(package->landing->seconds) && std::abs(package->landing->seconds) < 1e5)
      std::snprintf(text.data(), text.size(), "%.0f s", package->landing->seconds);
    add(HudMark::Kind::landing, package->landing->position, package->landing->hits, text.data());
    break;
  }
  const game::AircraftSnapshot& craft = snapshot.aircraft;
  if (!craft.present || craft.crashed || !snapshot.target.present) return marks;
  if (snapshot.predictedLanding && snapshot.target.distance < kAimRangeM)
    add(HudMark::Kind::aim, *snapshot.predictedLanding, snapshot.dropZone, "");
  const glm::dvec3 seen = inView(eye, snapshot.target.position);
  if (!core::isFinite(seen)) return marks;
  const auto pixel = pixelOf(eye, seen);
  if (pixel && isInside(eye, *pixel, kInset * eye.width)) return marks;
  // Left or right as a map has it, however the eye is banked; straight up or down there is no such way.
  const glm::dvec2 ahead(-eye.worldToView[0][2], -eye.worldToView[2][2]);
  const glm::dvec2 way(snapshot.target.position.x - eye.position.x,
                       snapshot.target.position.z - eye.position.z);
  const double along = ahead.x * way.x + ahead.y * way.y, right = ahead.x * way.y - ahead.y * way.x;
  // Ahead, and below or above the picture, it need not be turned to.
  if (along > 0 && std::abs(right) < kAhead * along) return marks;
  const double side = ahead == glm::dvec2(0) ? seen.x : right;
  marks.push_back({HudMark::Kind::toTarget, {side < 0 ? 0 : eye.width, eye.height / 2}, false, ""});
  return marks;
}

}  // namespace skydrop::ui
