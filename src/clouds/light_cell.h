// What one cell of a light volume does to light that goes straight through it (Lathrop and Carlson 1966).
#pragma once

#include <cmath>

#include "skydrop/core/shared.h"

namespace skydrop::clouds {

// Of light that enters a cell of an optical depth >= 0: the share that leaves it, and the share that the mean
// over the way has. depth * kept = 1 - left: what a cell takes is what its mean loses, so that no light is
// made or lost.
struct CellPassage {
  float left = 1, kept = 1;
};
inline CellPassage cellPassage(float depth) {
  return {std::exp(-depth), core::shared::f32::oneMinusExpOverX(depth)};
}

}  // namespace skydrop::clouds
