#include "skydrop/render/frame/view.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <string>

#include "skydrop/core/error.h"

namespace skydrop::render {
namespace {

// How far worldToView may be from a rotation, in any element of R R^T.
constexpr double kRotationTolerance = 1e-6;
constexpr int kMaxSide = 16384;

[[noreturn]] void refuse(const std::string& reason) { throw core::RangeError("camera: " + reason); }

bool isFinite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

void requireValid(const View& view) {
  if (!isFinite(view.position)) refuse("position is not finite");
  if (!std::isfinite(view.offAxis.x) || !std::isfinite(view.offAxis.y)) refuse("axis is not finite");
  const glm::dmat3& m = view.worldToView;
  if (!isFinite(m[0]) || !isFinite(m[1]) || !isFinite(m[2])) refuse("orientation is not finite");
  const glm::dmat3 product = m * glm::transpose(m);
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      if (std::abs(product[column][row] - (column == row ? 1.0 : 0.0)) > kRotationTolerance) {
        refuse("orientation is not a rotation");
      }
    }
  }
  if (glm::determinant(m) < 0) refuse("orientation is mirrored");
  if (!(view.fovYRad > 0 && view.fovYRad < 3)) refuse("field of view must lie between 0 and 3 rad");
  if (!(view.nearM > 0 && std::isfinite(view.nearM))) refuse("near plane must be positive");
  if (view.width < 1 || view.height < 1 || view.width > kMaxSide || view.height > kMaxSide) {
    refuse("picture of " + std::to_string(view.width) + "x" + std::to_string(view.height) + " pixels");
  }
}

View partOf(const View& whole, const glm::ivec2& corner, int side, int pixelSize) {
  View part = whole;
  part.width = part.height = side;
  const double ofPixel = whole.pixelAngleRad() * pixelSize;
  part.fovYRad = 2 * std::atan(0.5 * ofPixel * side);
  const glm::dvec2 middle = glm::dvec2(corner) + 0.5 * side * pixelSize;
  part.offAxis += (middle - 0.5 * glm::dvec2(whole.width, whole.height)) * whole.pixelAngleRad();
  return part;
}

glm::mat4 projection(const View& view) {
  const double focal = 1 / std::tan(view.fovYRad / 2);
  glm::mat4 m(0);
  m[0][0] = static_cast<float>(focal / view.aspect());
  m[1][1] = static_cast<float>(focal);
  m[2][0] = static_cast<float>(focal / view.aspect() * view.offAxis.x);
  m[2][1] = static_cast<float>(focal * view.offAxis.y);
  m[2][3] = -1;
  m[3][2] = static_cast<float>(view.nearM);
  return m;
}

View scaled(const View& view, double share) {
  const auto side = [share](int pixels) {
    return std::clamp(static_cast<int>(std::lround(share * pixels)), 1, kMaxSide);
  };
  View result = view;
  result.width = side(view.width);
  result.height = side(view.height);
  return result;
}

glm::mat4 viewProjection(const View& view) {
  return projection(view) * glm::mat4(glm::mat3(view.worldToView));
}

glm::mat4 bodyMatrix(const View& view, const glm::dvec3& position, const glm::dquat& orientation,
                     double scale) {
  glm::mat4 m(glm::mat3(glm::mat3_cast(orientation) * scale));
  m[3] = glm::vec4(relativeToEye(view, position), 1);
  return m;
}

glm::dmat3 rayMatrix(const View& view) {
  const double tangent = std::tan(view.fovYRad / 2);
  return glm::dmat3(view.right() * (tangent * view.aspect()), view.up() * tangent,
                    view.forward() + view.right() * view.offAxis.x + view.up() * view.offAxis.y);
}

glm::dvec3 rayDirection(const View& view, const glm::dvec2& pixel) {
  const glm::dvec2 ndc = 2.0 * pixel / glm::dvec2(view.width, view.height) - 1.0;
  return glm::normalize(rayMatrix(view) * glm::dvec3(ndc, 1));
}

}  // namespace skydrop::render
