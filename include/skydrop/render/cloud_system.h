// Volumetric clouds over the scene: a compute pass over linear colour and depth. docs/clouds.md tells how.
#pragma once

#include <memory>

#include "skydrop/clouds/cloud_field.h"
#include "skydrop/clouds/cloud_settings.h"
#include "skydrop/render/gl/buffer.h"
#include "skydrop/render/pass.h"

namespace skydrop::render {

class CloudVolumes;
class LightGrid;

class CloudSystem final : public Pass {
 public:
  CloudSystem(gl::Context& context, std::shared_ptr<const clouds::FoldedNoise> noise,
              const clouds::CloudSettings& settings);
  ~CloudSystem() override;

  // Takes the settings over for the next frame; about 20 ms where the medium changed, else nothing.
  void apply(const clouds::CloudSettings& settings);

  std::string_view name() const override { return "clouds"; }
  Slot slot() const override { return Slot::clouds; }
  std::optional<std::string> idleReason(const FrameInput& frame) const override;
  void draw(FrameContext& context) override;

  // What the last frame marched: 0 where it was idle. Waits for the GPU.
  struct Work {
    unsigned tiles = 0;  // of 8 x 8 rays
    unsigned edges = 0;  // single rays
  };
  Work lastWork() const;
  // Of the last frame that was not idle, a texel a ray: radiance, and the share of light behind that comes
  // through.
  const gl::Texture& light() const { return light_; }

 private:
  void updateLight(FrameContext& context);
  void marchInParts();
  void resize(const View& view);

  gl::Context& context_;
  clouds::CloudSettings settings_;
  std::unique_ptr<CloudVolumes> volumes_;
  std::unique_ptr<LightGrid> near_, far_;
  gl::Buffer uniforms_, tiles_, edges_;
  gl::Texture light_, distances_;
  gl::Texture carriedLight_, carriedWay_;  // of marches in parts
};

}  // namespace skydrop::render
