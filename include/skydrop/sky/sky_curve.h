// What lies between the texels of a table of the sky: a curve, where a straight line would show its kinks.
#pragma once

#include <glm/common.hpp>

namespace skydrop::sky {

// At a share t of the way from b to c, [0, 1]: the cubic through both with the slopes that their neighbours
// give (Catmull and Rom 1974), not below 0. Without a neighbour (null) the way goes on straight there.
template <class Light, class Real>
Light curveThrough(const Light* before, const Light& b, const Light& c, const Light* after, Real t) {
  const Light rise = c - b;
  const Light slope = before ? Real(0.5) * (c - *before) : rise,
              next = after ? Real(0.5) * (*after - b) : rise;
  const Light bent = Real(3) * rise - Real(2) * slope - next, twisted = slope + next - Real(2) * rise;
  return glm::max(b + t * (slope + t * (bent + t * twisted)), Light(0));
}

}  // namespace skydrop::sky
