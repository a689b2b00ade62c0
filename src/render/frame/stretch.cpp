#include "render/frame/stretch.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "skydrop/core/shared.h"

namespace skydrop::render {
namespace {

namespace shared = core::shared::f32;

// The two neighbours of a target pixel's centre along one side, and the weight of the second.
struct Between {
  std::size_t first, second;
  float weight;
};

Between between(double target, int targets, int sources) {
  const double at = target * sources / targets - 0.5;
  const double low = std::clamp(std::floor(at), 0.0, sources - 1.0);
  const double high = std::clamp(std::floor(at) + 1, 0.0, sources - 1.0);
  return {static_cast<std::size_t>(low), static_cast<std::size_t>(high),
          static_cast<float>(std::clamp(at - std::floor(at), 0.0, 1.0))};
}

glm::vec3 lightBetween(const LightPicture& picture, const Between& rows, const Between& columns) {
  const auto at = [&](std::size_t row, std::size_t column) {
    const float* light = &picture.light[3 * (row * static_cast<std::size_t>(picture.width) + column)];
    return glm::vec3(light[0], light[1], light[2]);
  };
  const auto along = [&](std::size_t row) {
    const glm::vec3 first = at(row, columns.first);
    return first + (at(row, columns.second) - first) * columns.weight;
  };
  const glm::vec3 first = along(rows.first);
  return first + (along(rows.second) - first) * rows.weight;
}

}  // namespace

int samplesAcross(const glm::ivec2& scene, const glm::ivec2& picture) {
  const auto of = [](int pixels, int pictures) { return (pixels + pictures - 1) / pictures; };
  return std::max(of(scene.x, picture.x), of(scene.y, picture.y));
}

std::vector<float> stretched(const LightPicture& picture, const glm::ivec2& size) {
  const int across = samplesAcross({picture.width, picture.height}, size);
  std::vector<float> all;
  all.reserve(3 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  const auto light = [&](double x, double y) {
    return lightBetween(picture, between(y, size.y, picture.height), between(x, size.x, picture.width));
  };
  const auto mean = [&](int x, int y) {
    if (across == 1) return light(x + 0.5, y + 0.5);
    glm::vec3 curve(0);
    for (int i = 0; i < across * across; ++i)
      curve += shared::toneCurve(
          glm::max(light(x + (i % across + 0.5) / across, y + (i / across + 0.5) / across), glm::vec3(0)));
    return shared::lightOfToneCurve(curve / static_cast<float>(across * across));
  };
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const glm::vec3 value = mean(x, y);
      all.insert(all.end(), {value.x, value.y, value.z});
    }
  }
  return all;
}

}  // namespace skydrop::render
