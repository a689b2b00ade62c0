// How much of the sky's light a cloud layer lets through to what lies below it: a map over a period of the
// weather. The cosine-weighted mean over all directions of what a two-stream layer of droplets passes on
// (Bohren, "Multiple scattering of light and some of its observable consequences", 1987), each direction with
// the optical depth of the column where it meets the layer's base. Immutable; any thread.
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <vector>

#include "skydrop/clouds/cloud_field.h"

namespace skydrop::clouds {

class SkyCover {
 public:
  static constexpr int kSide = 64;  // cells of a weather period, east and south

  // Of one of the settings' layers, below kCloudLayers (std::out_of_range).
  SkyCover(std::shared_ptr<const PackedCloudNoise> noise, const CloudSettings& settings,
           std::size_t layer = 0);
  SkyCover(std::shared_ptr<const PackedCloudNoise> noise, const LayerMedium& medium);

  // Share of the sky's light at sea level, [0, 1], of the middles of the cells; x fastest. 1 where the layer
  // is empty.
  const std::vector<float>& shares() const { return shares_; }
  double meanShare() const;
  double periodM() const { return periodM_; }
  // Between the middles of cells, bilinear, as a texture that repeats is filtered. `place`: x and z in the
  // field (drift taken off).
  double share(const glm::dvec2& place) const;

 private:
  double periodM_;
  std::vector<float> shares_;
};

// Of the light that falls evenly on a layer of such an optical depth (not negative), the share that comes out
// below.
double diffuseTransmittance(double opticalDepth);

}  // namespace skydrop::clouds
