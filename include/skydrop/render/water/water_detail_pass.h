// Water close by: publishes the waves for the passes that draw land and sea (SeaWaves), and adds what the sea
// mirrors of the scene (docs/water.md).
#pragma once

#include "skydrop/core/wind.h"
#include "skydrop/render/frame/pass.h"
#include "skydrop/render/frame/sea_waves.h"
#include "skydrop/render/gl/texture.h"
#include "skydrop/render/water/water_detail_settings.h"

namespace skydrop::render {

// Draws nothing.
class SeaWavesPass final : public Pass {
 public:
  // `wind`: that of scenes without weather.
  SeaWavesPass(const WaterDetailSettings& settings, const core::WindSettings& wind)
      : settings_(settings), wind_(wind) {}

  // For the next frame. Costs nothing.
  void apply(const WaterDetailSettings& settings, const core::WindSettings& wind) {
    settings_ = settings, wind_ = wind;
  }

  std::string_view name() const override { return "seaWaves"; }
  RenderStage stage() const override { return RenderStage::shadows; }
  void draw(FrameContext& context) override;

 private:
  WaterDetailSettings settings_;
  core::WindSettings wind_;
  gl::Texture mirror_;  // SeaWaves::mirror; while the sea mirrors the scene
  SeaWaves waves_;      // published
};

// After everything that is mirrored and before what veils it: rays from the sea are followed through the
// depths of the picture. Where they meet nothing the sky stays that the sea was drawn with.
class WaterReflectionPass final : public Pass {
 public:
  explicit WaterReflectionPass(const WaterDetailSettings& settings) : settings_(settings) {}

  // For the next frame.
  void apply(const WaterDetailSettings& settings) { settings_ = settings; }

  std::string_view name() const override { return "waterReflection"; }
  RenderStage stage() const override { return RenderStage::clouds; }
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  std::optional<std::string> skipReasonAfter(const FrameInput& frame,
                                             const FrameResources& resources) const override;
  void draw(FrameContext& context) override;

 private:
  void resize(FrameContext& context);

  WaterDetailSettings settings_;
  gl::Texture mirrored_;  // what is added, of each ray
};

}  // namespace skydrop::render
