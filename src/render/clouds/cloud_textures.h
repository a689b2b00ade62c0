// The textures of the cloud fields: the packed noise that all layers are made of, and the occupancy of each.
// Context's thread.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "skydrop/clouds/cloud_field.h"
#include "skydrop/clouds/occupancy.h"
#include "skydrop/render/gl/texture.h"

namespace skydrop::render {

class CloudTextures {
 public:
  CloudTextures(gl::Context& context, std::shared_ptr<const clouds::PackedCloudNoise> noise);

  // Takes over what the settings say of the layers. True when a field changed.
  bool apply(const clouds::CloudSettings& settings);

  bool isEmpty(std::size_t layer) const {
    return !layers_[layer].occupancy || layers_[layer].occupancy->isEmpty();
  }
  double meanDetail() const { return meanDetail_; }

  void bind(std::size_t layer) const;  // units 0 to 3, as in shaders/clouds

 private:
  struct Layer {
    clouds::CloudLayerSettings settings;  // that the occupancy is of
    double weatherPeriodM = 0;            // likewise
    std::optional<clouds::Occupancy> occupancy;
    gl::Texture distances;
  };

  std::shared_ptr<const clouds::PackedCloudNoise> noise_;
  double meanDetail_ = 0;
  gl::Texture base_, detail_, weather_;
  std::array<Layer, clouds::kCloudLayers> layers_;
};

}  // namespace skydrop::render
