#pragma once

#include <glm/vec3.hpp>

#include "skydrop/render/frame/frame_resources.h"

namespace skydrop::render {

// What is left of the light of sun and sky (that which the ground sends back included) at a place: [0, 1]
// of the sun, [0, 2] of the sky, which what ice scatters makes more.
struct LightShares {
  double sun = 1, sky = 1;
  double diffuseSun = 0;  // of the sun's light, what clouds have scattered: it comes from all of the sky
};

// Tells what dims the light over more than a model's length, before the shadows that models cast. A resource
// of the frame (FrameResources), published before models are drawn. It belongs to no effect, so that those
// who are lit need not know what stands above them.
class LightAtPlaces {
 public:
  virtual ~LightAtPlaces() = default;
  // Of a place in the world, m. Within the frame that it was published in.
  virtual LightShares at(const glm::dvec3& place) const = 0;
};

// At a place in the world: all, where nobody dims it.
inline LightShares lightAt(const FrameResources& resources, const glm::dvec3& place) {
  const LightAtPlaces* light = resources.find<LightAtPlaces>();
  return light ? light->at(place) : LightShares{};
}

}  // namespace skydrop::render
