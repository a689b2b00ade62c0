// The textures of a cloud field: packed noise and the occupancy of the layer. Context's thread.
#pragma once

#include <memory>
#include <optional>

#include "skydrop/clouds/cloud_field.h"
#include "skydrop/clouds/occupancy.h"
#include "skydrop/render/gl/texture.h"

namespace skydrop::render {

class CloudTextures {
 public:
  CloudTextures(gl::Context& context, std::shared_ptr<const clouds::PackedCloudNoise> noise);

  // Takes over what the settings say of the medium. True when it changed.
  bool apply(const clouds::CloudSettings& settings);

  bool isEmpty() const { return !occupancy_ || occupancy_->isEmpty(); }
  double meanDetail() const { return meanDetail_; }

  void bind() const;  // units 0 to 3, as in shaders/clouds

 private:
  std::shared_ptr<const clouds::PackedCloudNoise> noise_;
  double meanDetail_ = 0;
  gl::Texture base_, detail_, weather_, distances_;
  clouds::CloudSettings settings_;
  std::optional<clouds::Occupancy> occupancy_;
};

}  // namespace skydrop::render
