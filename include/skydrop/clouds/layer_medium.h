// The medium of one cloud layer: its settings and what its genus adds. What is made of a layer (field,
// occupancy, clear air, sky cover) is made of this. Values; any thread.
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "skydrop/clouds/cloud_settings.h"

namespace skydrop::clouds {

inline constexpr double kNoAnvil = 2;  // height fraction of an anvil that is not there

// What the genus adds (shaders/shared/cloud_form.glsl). The default adds nothing.
struct CloudForm {
  glm::dvec4 profile{0, 0.1, 0.9, 1};  // height fractions, ascending in [0, 1]: density rises, falls
  double own = 0;                      // [0, 1]: share of that profile; the rest is that of the map's type
  double anvilBase = kNoAnvil;         // height fraction from which the anvil is whole; 2: there is none
  double spread = 1;                   // 0 .. 4: cover in the anvil, times that below
  double anvilThreshold = 0;           // -0.95 .. 0: added to the least density there
  double taper = 0;                    // 0 .. 0.9: share of its cover that a tower would lose up to the top
  double contrast = 0;                 // 0 .. 20: how much steeper cover rises with the map, for towers
  // Frequencies of the shape, times those of the scale: less than 1 draws billows out along an axis (east,
  // up, south). Level ones are 1, 1/2, 1/4 ..., so that the field still repeats with the weather map.
  glm::dvec3 stretch{1};

  // As the shaders take the profile.
  glm::dvec4 slopes() const {
    return {profile.x, 1 / (profile.y - profile.x), profile.w, 1 / (profile.w - profile.z)};
  }

  bool operator==(const CloudForm&) const = default;
};

struct LayerMedium {
  CloudLayerSettings layer;
  CloudForm form;
  double fadeDistance = 60000;  // m; bounds the period of the weather map (weatherPeriod())

  bool operator==(const LayerMedium&) const = default;
};

// One of the settings' layers, below kCloudLayers (std::out_of_range).
LayerMedium mediumOf(const CloudSettings& settings, std::size_t layer);

// Side of the period with which the field before erosion repeats, m: weatherPeriod() of its layer, a whole
// number of the shape's periods along both level axes.
double weatherPeriod(const LayerMedium& medium);

}  // namespace skydrop::clouds
