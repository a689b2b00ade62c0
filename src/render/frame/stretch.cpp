#include "render/frame/stretch.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace skydrop::render {
namespace {

// The two neighbours of a target pixel's centre along one side, and the weight of the second.
struct Between {
  std::size_t first, second;
  float weight;
};

Between between(int target, int targets, int sources) {
  const double at = (target + 0.5) * sources / targets - 0.5;
  const double low = std::clamp(std::floor(at), 0.0, sources - 1.0);
  const double high = std::clamp(std::floor(at) + 1, 0.0, sources - 1.0);
  return {static_cast<std::size_t>(low), static_cast<std::size_t>(high),
          static_cast<float>(std::clamp(at - std::floor(at), 0.0, 1.0))};
}

}  // namespace

std::vector<float> stretched(const LightPicture& picture, const glm::ivec2& size) {
  std::vector<float> all;
  all.reserve(3 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  const auto width = static_cast<std::size_t>(picture.width);
  for (int y = 0; y < size.y; ++y) {
    const Between rows = between(y, size.y, picture.height);
    for (int x = 0; x < size.x; ++x) {
      const Between columns = between(x, size.x, picture.width);
      for (std::size_t k = 0; k < 3; ++k) {
        const auto at = [&](std::size_t row, std::size_t column) {
          return picture.light[3 * (row * width + column) + k];
        };
        const auto along = [&](std::size_t row) {
          const float first = at(row, columns.first);
          return first + (at(row, columns.second) - first) * columns.weight;
        };
        const float first = along(rows.first);
        all.push_back(first + (along(rows.second) - first) * rows.weight);
      }
    }
  }
  return all;
}

}  // namespace skydrop::render
