#pragma once

#include "skydrop/render/frame/fullscreen_triangle.h"
#include "skydrop/render/frame/halo_tables.h"
#include "skydrop/render/frame/pass.h"
#include "skydrop/render/gl/texture.h"
#include "skydrop/render/sky/halo_settings.h"

namespace skydrop::render {

// Adds the 22 and 46 degree halos and the sun dogs of ice to the sky, around whatever casts shadows, sun or
// moon (shaders/sky/halo.glsl). Drawn where nothing nearer was, before clouds, which hide it. Publishes
// nothing, asks for nothing.
class HaloPass final : public Pass {
 public:
  // Reads its tables from assets/optics; throws core::DataError where they are not what
  // assets/scripts/make_halo.py writes. The context must outlive it.
  HaloPass(gl::Context& context, const HaloSettings& settings);

  // For the next frame. Costs nothing.
  void apply(const HaloSettings& settings) {
    settings_ = settings;
    tables_.plates = settings.plates;
  }
  // Clouds of ice make the halos from now on, with these tables, and the ice by hand is gone; or not.
  void leaveToClouds(bool leaves) { isLeft_ = leaves; }
  // As long as the pass.
  const HaloTables& tables() const { return tables_; }

  std::string_view name() const override { return "halo"; }
  RenderStage stage() const override { return RenderStage::sky; }
  // Without ice, from above it, with the light below the horizon, and with no ray of the picture within 64
  // degrees of the light.
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  // Throws core::DataError where its shader does not compile.
  void draw(FrameContext& context) override;

 private:
  HaloSettings settings_;
  FullscreenTriangle triangle_;
  gl::Texture halo_, sunDogs_;
  HaloTables tables_;
  bool isLeft_ = false;
};

}  // namespace skydrop::render
