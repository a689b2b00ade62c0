#include "skydrop/flight/linear_drag.h"

#include "skydrop/core/deterministic_math.h"
#include "skydrop/flight/environment.h"

namespace skydrop::flight {
namespace {

struct Phi {
  double zero, one, two;  // exp(-z), (1 - exp(-z)) / z, (1 - (1 - exp(-z)) / z) / z
};

// The phi functions of exponential integrators (Hochbruck, Ostermann 2010); by series where they cancel.
Phi phiFunctions(double z) {
  Phi p{core::dmath::exp(-z), 0, 0};
  if (z < 0.5) {
    // two = 1/2! - z/3! + z^2/4! - ...; the next term is below 1e-17 of the sum.
    double sum = 0;
    for (int n = 16; n >= 2; --n) sum = (1 - z * sum) / n;
    p.two = sum;
    p.one = 1 - z * p.two;
  } else {
    p.one = (1 - p.zero) / z;
    p.two = (1 - p.one) / z;
  }
  return p;
}

}  // namespace

PointState fallWithLinearDrag(const PointState& start, double k, const glm::dvec3& wind, double seconds) {
  const Phi p = phiFunctions(k * seconds);
  const glm::dvec3 through = start.velocity - wind;
  const glm::dvec3 gravity{0, -kGravity, 0};
  PointState out;
  out.velocity = wind + through * p.zero + gravity * (seconds * p.one);
  out.position =
      start.position + wind * seconds + through * (seconds * p.one) + gravity * (seconds * seconds * p.two);
  return out;
}

}  // namespace skydrop::flight
