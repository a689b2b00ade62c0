// High clouds of ice: cirrus, cirrostratus, cirrocumulus (docs/ice-clouds.md). Each layer is a thin shell
// with a density of its own (shaders/shared/ice_clouds.glsl), asked at a few places along each ray.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "skydrop/clouds/ice_clouds.h"
#include "skydrop/render/clouds/ice_layers.h"
#include "skydrop/render/frame/fullscreen_triangle.h"
#include "skydrop/render/frame/halo_tables.h"
#include "skydrop/render/frame/pass.h"
#include "skydrop/render/frame/pixel_box.h"

namespace skydrop::render {

class SheetLayer;

// Drawn after volumes of cloud: asks for CloudTransmittance, and puts each layer before or behind them by
// their mean distance, exactly. Surfaces cut it by the scene's depth. Publishes nothing. On the context's
// thread.
class IceCloudsPass final : public Pass {
 public:
  // The context must outlive it.
  IceCloudsPass(gl::Context& context, const clouds::IceCloudSettings& settings,
                const core::WindSettings& wind);
  ~IceCloudsPass() override;

  // For the next frame. Costs nothing.
  void apply(const clouds::IceCloudSettings& settings, const core::WindSettings& wind) {
    layers_ = {settings, wind};
  }
  // Regular crystals among the ice make halos by these tables, which must outlive the next frames; null:
  // none.
  void takeHalo(const HaloTables* tables) { halo_ = tables; }
  // As long as the pass.
  const IceLayers& layers() const { return layers_; }

  std::string_view name() const override { return "iceClouds"; }
  RenderStage stage() const override { return RenderStage::cloudSheets; }
  // Without a layer, whose texture is let go then, and where no ray of the picture meets one.
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  // Throws core::DataError where a shader does not compile.
  void draw(FrameContext& context) override;

 private:
  // What a layer is drawn with.
  struct Programs {
    gl::Shader* light;    // of the layer, into a picture of fewer pixels or the scene itself
    gl::Shader* compose;  // null in full resolution
  };

  Programs programs(FrameContext& context, clouds::IceGenus genus, bool isBehindAll) const;
  void drawLayer(FrameContext& context, const clouds::IceField& field, const PixelBox& box);
  static void setLevels(gl::Shader& shader, const View& view, const clouds::IceLayer& layer);
  void setLayer(FrameContext& context, gl::Shader& shader, const clouds::IceField& field) const;

  IceLayers layers_;
  const HaloTables* halo_ = nullptr;
  std::unique_ptr<SheetLayer> layer_;
  FullscreenTriangle triangle_;
};

}  // namespace skydrop::render
