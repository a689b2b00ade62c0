// Noise for tests of clouds.
#pragma once

#include <memory>

#include "skydrop/clouds/cloud_field.h"
#include "skydrop/clouds/noise_textures.h"

namespace skydrop::test {

// Made in 0.2 s: the shape is the detail texture, of 32^3. Thinner than the game's:
// cloudySettings() make up for it.
inline std::shared_ptr<const clouds::PackedCloudNoise> quickNoise() {
  static const auto noise = [] {
    const core::TextureData detail = clouds::makeNoise(clouds::NoiseTexture::detail, 0);
    return std::make_shared<const clouds::PackedCloudNoise>(
        clouds::packCloudNoise(detail, detail, clouds::makeNoise(clouds::NoiseTexture::weather, 0)));
  }();
  return noise;
}

inline clouds::CloudSettings cloudySettings() {
  clouds::CloudSettings settings;
  settings.layers[0].densityThreshold = 0.3;
  settings.layers[0].coverage = 0.9;
  return settings;
}

}  // namespace skydrop::test
