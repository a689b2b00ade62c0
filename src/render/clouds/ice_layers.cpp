#include "skydrop/render/clouds/ice_layers.h"

#include "skydrop/game/ice_layers.h"
#include "skydrop/game/snapshot.h"

namespace skydrop::render {

std::vector<clouds::IceField> IceLayers::of(const FrameInput& frame) const {
  std::vector<clouds::IceLayer> layers;
  const glm::dvec3& eye = frame.view.position;
  if (frame.game && frame.game->weather)
    layers = game::iceLayersAt(frame.game->weather, {eye.x, eye.z});
  else
    layers.push_back(clouds::iceLayerOf(settings_));
  const glm::dvec2 drift = core::windDrift(wind_, frame.simulatedSeconds);
  std::vector<clouds::IceField> fields;
  for (const clouds::IceLayer& layer : layers) {
    if (layer.cover > 0 && layer.opticalDepth > 0) fields.emplace_back(layer, drift);
  }
  return fields;
}

}  // namespace skydrop::render
