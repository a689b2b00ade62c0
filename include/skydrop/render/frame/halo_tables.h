#pragma once

#include "skydrop/render/gl/texture.h"

namespace skydrop::render {

// What shaders/sky/halo_phase.glsl reads: for whatever has regular crystals of ice in it. The textures belong
// to who hands it out.
struct HaloTables {
  // Texture units of that file.
  static constexpr GLuint kHaloUnit = 0, kSunDogUnit = 1;

  const gl::Texture* halo = nullptr;
  const gl::Texture* sunDogs = nullptr;
  double plates = 0;  // share of the crystals that lie level, [0, 1]
};

}  // namespace skydrop::render
