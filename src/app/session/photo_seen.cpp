#include "app/session/photo_seen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/trigonometric.hpp>

namespace skydrop::app {
namespace {

// Pixels of a photograph between whose centres a place lies, mixed; x goes round where `wraps`.
std::array<std::uint8_t, 4> sampled(const core::Image& photo, double u, double v, bool wraps) {
  const double x = u * photo.width - 0.5, y = v * photo.height - 0.5;
  const double left = std::floor(x), top = std::floor(y);
  std::array<double, 4> sum{};
  for (int dy = 0; dy < 2; ++dy) {
    for (int dx = 0; dx < 2; ++dx) {
      const double weight = (dx ? x - left : 1 - (x - left)) * (dy ? y - top : 1 - (y - top));
      int column = static_cast<int>(left) + dx;
      column =
          wraps ? (column % photo.width + photo.width) % photo.width : std::clamp(column, 0, photo.width - 1);
      const int row = std::clamp(static_cast<int>(top) + dy, 0, photo.height - 1);
      const std::uint8_t* pixel = photo.pixel(column, row);
      for (std::size_t c = 0; c < 4; ++c) sum[c] += weight * pixel[c];
    }
  }
  std::array<std::uint8_t, 4> out{};
  for (std::size_t c = 0; c < 4; ++c) out[c] = static_cast<std::uint8_t>(std::lround(sum[c]));
  return out;
}

}  // namespace

glm::dvec2 photoPlaceOf(const core::Image& photo, const PhotoRequest& request, const render::View& view,
                        const glm::dvec2& pixel) {
  if (request.panoramaFromDegrees) {
    const glm::dvec3 d = render::rayDirection(view, pixel);
    const double heading = glm::degrees(std::atan2(d.x, -d.z)),
                 pitch = glm::degrees(std::asin(std::clamp(d.y, -1.0, 1.0)));
    const double turn = (heading - *request.panoramaFromDegrees) / 360;
    return {turn - std::floor(turn), 0.5 - pitch * photo.width / (360.0 * photo.height)};
  }
  const double half = std::tan(view.fovYRad / 2);
  const glm::dvec2 tangent = view.offAxis + glm::dvec2((2 * pixel.x / view.width - 1) * half * view.aspect(),
                                                       (2 * pixel.y / view.height - 1) * half);
  const double halfWidth =
      request.fieldDegrees ? std::tan(glm::radians(*request.fieldDegrees) / 2) : half * view.aspect();
  return {0.5 + 0.5 * tangent.x / halfWidth, 0.5 - 0.5 * tangent.y / halfWidth * photo.width / photo.height};
}

render::View withRoomToTheLeft(const render::View& view) {
  render::View moved = view;
  moved.offAxis.x -= 0.5 * std::tan(view.fovYRad / 2) * view.aspect();
  return moved;
}

core::Image asSeen(const core::Image& photo, const PhotoRequest& request, const render::View& view) {
  core::Image out(view.width, view.height);
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      const glm::dvec2 at = photoPlaceOf(photo, request, view, {x + 0.5, view.height - y - 0.5});
      if (!(at.x >= 0 && at.x <= 1 && at.y >= 0 && at.y <= 1)) continue;
      const auto pixel = sampled(photo, at.x, at.y, request.panoramaFromDegrees.has_value());
      std::ranges::copy(pixel, out.pixel(x, y));
    }
  }
  return out;
}

core::Image together(const core::Image& picture, const core::Image& photo, PhotoView view, double share) {
  if (view == PhotoView::none) return picture;
  const bool beside = view == PhotoView::beside;
  core::Image out(beside ? 2 * picture.width : picture.width, picture.height);
  const auto wiped = static_cast<int>(std::lround(share * picture.width));
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const std::uint8_t *rendered = picture.pixel(x, y), *taken = photo.pixel(x, y);
      const double opacity = taken[3] / 255.0 * (view == PhotoView::overlay ? share : beside || x < wiped);
      std::uint8_t* to = out.pixel(x, y);
      for (int c = 0; c < 3; ++c) {
        const double under = beside ? 0 : rendered[c];
        to[c] = static_cast<std::uint8_t>(std::lround(under + opacity * (taken[c] - under)));
      }
      to[3] = 255;
      if (beside) std::copy_n(rendered, 4, out.pixel(picture.width + x, y));
    }
  }
  return out;
}

}  // namespace skydrop::app
