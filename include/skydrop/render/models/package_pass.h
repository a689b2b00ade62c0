#pragma once

#include <memory>

#include "skydrop/render/frame/pass.h"
#include "skydrop/render/models/model.h"
#include "skydrop/render/models/shadow_source.h"

namespace skydrop::render {

// What all packages are drawn with: loaded once, shared by the pass and the shadows. Owns GL objects: on the
// context's thread, and must go before its context.
struct PackageModels {
  // Reads assets/models/package.glb and parachute.glb, with this. Throws core::DataError for a file that is
  // missing or broken, or a material with too many textures.
  explicit PackageModels(gl::Context& context, const ModelImport& import = importModel);

  Model crate, parachute;
};

// The packages of FrameInput::game, with their parachutes, as they hide the sun; nothing without a game. A
// caster refers to the frame's snapshot, and to the models, which it keeps alive.
ShadowSource packageShadows(std::shared_ptr<const PackageModels> models);

// The packages of FrameInput::game, under way or landed, with their parachutes: closed they are not drawn,
// opening they grow from a streamer to the full canopy along the flow of the air, landed they lie on the
// slope, down the wind. Skipped where no package is in view (each as a ball of 8 m). Publishes nothing, asks
// for nothing.
class PackagePass final : public Pass {
 public:
  // `models`: not null.
  explicit PackagePass(std::shared_ptr<const PackageModels> models) : models_(std::move(models)) {}

  // For the packages' shadows.
  const std::shared_ptr<const PackageModels>& models() const { return models_; }

  std::string_view name() const override { return "packages"; }
  RenderStage stage() const override { return RenderStage::models; }
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  PixelBox extent(const FrameInput& frame) const override;  // only where skipReason() gave none
  // Throws core::DataError where its shaders do not compile.
  bool isMirrored() const override { return true; }
  void draw(FrameContext& context) override;

 private:
  std::shared_ptr<const PackageModels> models_;
};

}  // namespace skydrop::render
