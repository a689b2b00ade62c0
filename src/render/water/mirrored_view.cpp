#include "render/water/mirrored_view.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

#include "render/frame/visibility.h"

namespace skydrop::render {
namespace {

constexpr double kWidestRad = 2.9;
constexpr int kMostPixels = 16384;

glm::dvec3 mirrored(const glm::dvec3& v) { return {v.x, -v.y, v.z}; }

}  // namespace

std::optional<std::string> whyNothingIsMirrored(const View& view) {
  if (view.position.y <= 0) return "the view is below the sea";
  if (view.position.y >= kMirrorEndsM) return "the view is too high for what water mirrors";
  if (leastRise(view) > 0) return "the view shows no water";
  return std::nullopt;
}

View mirroredView(const View& view, double margin, int spacing) {
  View result = view;
  result.position = mirrored(view.position);
  const glm::dvec3 right = mirrored(view.right()), up = -mirrored(view.up()),
                   forward = mirrored(view.forward());
  result.worldToView = glm::transpose(glm::dmat3(right, up, -forward));
  result.offAxis.y = -view.offAxis.y;
  const double ofPixel = view.pixelAngleRad() * spacing;  // tangents
  const auto pixels = [&](int side) {
    const double wider =
        std::min(side * view.pixelAngleRad() * (1 + 2 * margin), 2 * std::tan(kWidestRad / 2));
    return std::clamp(static_cast<int>(std::ceil(wider / ofPixel - 1e-9)), 1, kMostPixels);
  };
  result.width = pixels(view.width);
  result.height = pixels(view.height);
  result.fovYRad = 2 * std::atan(0.5 * ofPixel * result.height);
  return result;
}

}  // namespace skydrop::render
