#include "skydrop/clouds/anvil_reach.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace skydrop::clouds {
namespace {

struct Step {
  int x, y;
};

// Those before a texel in the order of lines; the others are their opposites.
constexpr std::array<Step, 8> kBefore{
    {{-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {-2, -1}, {-1, -2}, {1, -2}, {2, -1}}};

}  // namespace

std::vector<float> anvilReach(const std::vector<glm::vec3>& map, int side) {
  std::vector<float> reach(map.size());
  std::transform(map.begin(), map.end(), reach.begin(), [](const glm::vec3& texel) { return texel.x; });
  const int wrap = side - 1;
  const auto sweep = [&](int sign) {
    bool changes = false;
    for (int n = 0; n < side * side; ++n) {
      const int at = sign > 0 ? n : side * side - 1 - n, x = at & wrap, y = at / side;
      float& here = reach[static_cast<std::size_t>(at)];
      for (const Step& step : kBefore) {
        const int from = ((y + sign * step.y) & wrap) * side + ((x + sign * step.x) & wrap);
        const float loss =
            kAnvilLossATexel * std::sqrt(static_cast<float>(step.x * step.x + step.y * step.y));
        const float carried = reach[static_cast<std::size_t>(from)] - loss;
        changes = changes || carried > here;
        here = std::max(here, carried);
      }
    }
    return changes;
  };
  // The map repeats, so what crosses its border needs another round.
  while (sweep(1) | sweep(-1)) {
  }
  return reach;
}

}  // namespace skydrop::clouds
