// Tables of the air's light that depend on the air alone, so that any light outside it (sun, moon) shares
// them: what the air leaves of it, and what many scatterings make of it. Of the shell of
// shaders/shared/atmosphere_shell.glsl.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "skydrop/core/shared.h"

namespace skydrop::sky {

using core::shared::f64::Atmosphere;

// Light that was scattered before, at a place, per irradiance of the light outside the air, 1/sr. The place's
// axes: x is level and towards the light's azimuth, y up, z to the side, on both sides of which the light is
// the same.
struct ScatteredBefore {
  glm::vec3 mean{0};               // radiance of all orders, mean over all directions
  glm::vec3 alongX{0}, alongY{0};  // of the light scattered once: mean of radiance times direction
  glm::vec3 xx{0}, yy{0}, xy{0},
      once{0};  // mean of radiance times products of the direction's components; mean radiance
};

// Immutable; all functions are pure, from any thread. Heights in m above the sea are clamped to the air, [0,
// kShellTop]; `cosine` is that of the zenith angle of the light, [-1, 1].
class AirTables {
 public:
  // Takes about 50 ms of one core.
  explicit AirTables(const Atmosphere& air);

  const Atmosphere& air() const { return air_; }
  const core::shared::f32::Atmosphere& airInFloat() const { return airInFloat_; }

  // What is the same for all lights at one height, so that several can be asked for at little cost.
  class Level {
   public:
    // Of light from outside the air down to the height, without the ground: below the horizon as at the
    // horizon.
    glm::vec3 transmittance(float cosine) const;
    float visibleShare(float cosine) const;  // of the light's disc above the horizon (sunVisibleShareAt)
    ScatteredBefore scatteredBefore(float cosine) const;

   private:
    friend class AirTables;
    const glm::vec3* transmittance_;
    const float* scattered_;
    float radius_, horizon_, perHorizonCosine_, toAirEnd_, shortest_, perLength_, transmittanceShare_,
        scatteredShare_;
  };
  Level at(float heightM) const;

 private:
  void makeTransmittance();
  void makeScatteredBefore();
  ScatteredBefore gatherAt(float heightM, float cosine) const;

  Atmosphere air_;
  core::shared::f32::Atmosphere airInFloat_;
  std::vector<glm::vec3> transmittance_;
  std::vector<float> scatteredBefore_;
};

}  // namespace skydrop::sky
