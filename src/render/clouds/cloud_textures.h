// The textures of the cloud fields: the packed noise that all layers are made of, and what is worked out of
// each layer. Context's thread.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "skydrop/clouds/clear_air.h"
#include "skydrop/clouds/cloud_field.h"
#include "skydrop/clouds/sky_cover.h"
#include "skydrop/render/gl/texture.h"

namespace skydrop::render {

class CloudTextures {
 public:
  CloudTextures(gl::Context& context, std::shared_ptr<const clouds::PackedCloudNoise> noise,
                const clouds::CloudSettings& settings);

  // Works occupancy, clear air and sky cover of a layer out again.
  void rebuild(const clouds::CloudSettings& settings, std::size_t layer);

  bool isEmpty(std::size_t layer) const { return layers_[layer].isEmpty; }
  double meanDetail() const { return meanDetail_; }
  const clouds::ClearAir& clearAir(std::size_t layer) const { return layers_[layer].clearAir; }

  const clouds::CloudField& field(std::size_t layer) const { return *layers_[layer].field; }
  const clouds::SkyCover& skyCover(std::size_t layer) const { return *layers_[layer].skyCover; }
  // Of skyCover(), R32F, repeats.
  const gl::Texture& skyShares(std::size_t layer) const { return layers_[layer].skyShares; }

  void bind(std::size_t layer) const;  // units 0 to 3, as in shaders/clouds

 private:
  struct Layer {
    bool isEmpty = true;
    clouds::ClearAir clearAir;
    std::optional<clouds::CloudField> field;  // without drift
    std::optional<clouds::SkyCover> skyCover;
    gl::Texture distances, skyShares;
  };

  std::shared_ptr<const clouds::PackedCloudNoise> noise_;
  double meanDetail_ = 0;
  gl::Texture base_, detail_, weather_;
  std::array<Layer, clouds::kCloudLayers> layers_;
};

}  // namespace skydrop::render
