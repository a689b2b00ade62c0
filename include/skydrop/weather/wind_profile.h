// The mean wind over height, made of a State once and asked often. A value; any thread; the same bits on
// every machine.
//
// Near the ground by the logarithmic law (Prandtl 1932; MIL-F-8785C 3.7.3.1 uses it too) from 0 at the
// ground, u = U ln(1 + h / z0) / ln(1 + H / z0), with the roughness length z0 and the gradient height H:
// within .1 % of ln(h / z0) from 10 m on over grass, and without its singularity. Above H, the free air U:
// linear in both components between the gradient height and the State's levels, constant beyond the last.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "skydrop/weather/state.h"

namespace skydrop::weather {

class WindProfile {
 public:
  WindProfile() = default;  // calm
  explicit WindProfile(const Wind& wind);

  // The air's velocity, m/s, x east, z south, at a height above the sea and above the ground below it, m.
  // Below the ground it is 0; heights that are not finite give 0.
  glm::dvec3 at(double heightM, double aboveGroundM) const;

  // Speed 20 feet above the ground, which turbulence near it goes by (W20 of MIL-F-8785C), m/s, that of the
  // gusts included.
  double w20Mps() const { return w20_; }

 private:
  // Share of the free air's wind that is left near the ground, [0, 1].
  double nearGround(double aboveGroundM) const;

  struct Knot {
    double heightM = 0;
    glm::dvec2 velocity{0};
  };
  std::array<Knot, kWindLevels + 1> knots_{};
  double roughnessM_ = 0.05, gradientHeightM_ = 300, inverseLog_ = 0, w20_ = 0;
};

// The velocity of a wind that comes from a compass direction: x east, y south.
glm::dvec2 windVelocity(double speedMps, double directionDeg);

}  // namespace skydrop::weather
