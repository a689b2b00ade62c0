#include "render/clouds/ice_view.h"

#include <algorithm>
#include <cmath>

#include "render/clouds/sheet_view.h"
#include "skydrop/core/shared.h"

namespace skydrop::render {
namespace {

constexpr double kRadiusM = core::shared::f64::kEarthRadiusM;

// Sine by which a ray may at most fall and still meet a layer that it starts below, or above the top: at the
// horizon of the sea, and nothing less.
double leastSine(const View& view) { return -std::sqrt(2 * std::max(view.position.y, 0.0) / kRadiusM); }

// From above, the sine from which on rays pass over the layer.
double mostSine(const View& view, const clouds::IceLayer& layer) {
  const double above = view.position.y - layer.topM;
  return above > 0 ? -std::sqrt(2 * above / kRadiusM) : 1;
}

}  // namespace

PixelBox pixelsOfIce(const View& view, const clouds::IceLayer& layer) {
  constexpr double kMargin = 1e-3;  // of sines: rounding, and the shell's own approximation
  if (view.position.y < layer.baseM && steepestUp(view) < leastSine(view) - kMargin) return {};
  if (-steepestDown(view) > mostSine(view, layer) + kMargin) return {};
  // From below it lies above a line that falls and rises no more than the horizon's: rows from the lowest
  // point of a grid that may see it, one cell more to each side.
  constexpr int kCells = 16;
  const auto mayMeet = [&](int x, int y) {
    const double sine =
        rayDirection(view, {x * view.width / double{kCells}, y * view.height / double{kCells}}).y;
    return sine >= (view.position.y < layer.baseM ? leastSine(view) : -1) - kMargin &&
           sine <= mostSine(view, layer) + kMargin;
  };
  int low = kCells + 1, high = -1;
  for (int y = 0; y <= kCells; ++y) {
    for (int x = 0; x <= kCells; ++x) {
      if (!mayMeet(x, y)) continue;
      low = std::min(low, y);
      high = std::max(high, y);
    }
  }
  if (high < 0) return {0, 0, view.width, view.height};  // between two points of the grid
  const auto row = [&](int cell) { return std::clamp(cell, 0, kCells) * view.height; };
  return {0, row(low - 1) / kCells, view.width, (row(high + 1) + kCells - 1) / kCells};
}

}  // namespace skydrop::render
