// The density of a cloud layer at any place, on the processor: what the compute shader marches through, for
// the game and for the reference. Immutable but for setDrift(); const functions may run on any
// thread.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "skydrop/clouds/layer_medium.h"
#include "skydrop/core/dds.h"

namespace skydrop::clouds {

// The noise textures as the medium reads them: channels that are only ever used together packed into one, as
// floats.
struct PackedCloudNoise {
  int shapeSide = 0, detailSide = 0, weatherSide = 0;  // texels
  std::vector<float> base;                             // cloudBase() of the shape texture, x fastest
  std::vector<float> detail;                           // cloudDetail() of the detail texture
  std::vector<glm::vec3> weather;                      // coverage, precipitation, type
  std::vector<float> anvils;                           // anvilReach() of the coverage; empty: as the coverage
};

// rgba8 cubes and a square map, sides powers of two, as clouds::makeNoise() makes them; anything else (read
// from a foreign file) throws core::RangeError.
PackedCloudNoise packCloudNoise(const core::TextureData& shape, const core::TextureData& detail,
                                const core::TextureData& weather);

class CloudField {
 public:
  // Of one of the settings' layers, below kCloudLayers.
  CloudField(std::shared_ptr<const PackedCloudNoise> noise, const CloudSettings& settings,
             std::size_t layer = 0);

  CloudField(std::shared_ptr<const PackedCloudNoise> noise, const LayerMedium& medium);

  const CloudLayerSettings& layer() const { return medium_.layer; }
  const LayerMedium& medium() const { return medium_; }
  double fadeDistance() const { return medium_.fadeDistance; }

  // How far the wind has carried the field (core::windDrift), metres in x and z; the field repeats, so this
  // is wrapped to its periods where it is used.
  void setDrift(glm::dvec2 metres) { drift_ = metres; }

  // In [0, 1]; exact at any distance from the origin that doubles resolve. Trilinear between texels.
  double density(const glm::dvec3& position) const;
  // The same in 32-bit arithmetic from the wrapped position on: what a shader computes.
  float densityInFloat(const glm::dvec3& position) const;
  // cloudShapeEstimate() (shaders/shared/cloud_medium.glsl), in 32-bit arithmetic: not bounded, below 0 where
  // there is no cloud; outside the layer too.
  // (with a form, formedShapeEstimate()).
  float shapeEstimateInFloat(const glm::dvec3& position) const;

 private:
  template <class Shared>
  typename Shared::Real densityAs(const glm::dvec3& position) const;

  std::shared_ptr<const PackedCloudNoise> noise_;
  LayerMedium medium_;
  double periodM_;  // of the weather map
  glm::dvec2 drift_{0};
};

}  // namespace skydrop::clouds
