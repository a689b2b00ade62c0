#pragma once

#include <span>
#include <string>
#include <vector>

#include "skydrop/render/frame/frame_resources.h"
#include "skydrop/render/gl/texture.h"

namespace skydrop::render {

// The clouds of a frame as they were seen: for whatever is drawn after them and may lie behind. A resource of
// the frame (FrameResources), published by the pass that draws clouds, valid until the frame has been drawn.
// It belongs to no effect, so that those who are veiled need not know who veils them.
//
// Both textures have one texel for each pixel of the view, row 0 at the bottom. They belong to the pass,
// which overwrites them in the next frame. Where a ray met no cloud, and where an opaque surface hides the
// clouds, transmittance is 1.
struct CloudTransmittance {
  // Texture units of shaders/cloud_transmittance.glsl.
  static constexpr GLuint kLightUnit = 2, kDistancesUnit = 3;

  // Neither is null once this is published.
  // RGBA16F. rgb: the clouds' own light, linear after exposure; a: share of the light behind them that comes
  // through, [0, 1].
  const gl::Texture* light = nullptr;
  // R16F, metres from the eye: mean distance of the clouds' light, kFarDistance (65 km,
  // shaders/shared/half_float.glsl) where there is none.
  const gl::Texture* distances = nullptr;

  // For programs that include that file.
  void bind() const {
    light->bind(kLightUnit);
    distances->bind(kDistancesUnit);
  }
};

// Of a program that includes that file: `defines`, and CLOUD_TRANSMITTANCE in frames that have clouds, whose
// textures are then bound.
inline std::vector<std::string> withCloudTransmittance(std::span<const std::string> defines,
                                                       const FrameResources& resources) {
  std::vector<std::string> all(defines.begin(), defines.end());
  if (const auto* clouds = resources.find<CloudTransmittance>()) {
    all.emplace_back("CLOUD_TRANSMITTANCE");
    clouds->bind();
  }
  return all;
}

}  // namespace skydrop::render
