#pragma once

#include <memory>

#include "skydrop/render/frame/pass.h"
#include "skydrop/render/models/model.h"
#include "skydrop/render/models/shadow_source.h"

namespace skydrop::render {

struct PackageModels {
  // Reads assets/models/package.glb and parachute.glb. Throws core::DataError.
  explicit PackageModels(gl::Context& context);

  Model crate, parachute;
};

// The packages, with their parachutes, as they hide the sun.
ShadowSource packageShadows(std::shared_ptr<const PackageModels> models);

// The packages under way and those that have landed, with their parachutes.
class PackagePass final : public Pass {
 public:
  explicit PackagePass(std::shared_ptr<const PackageModels> models) : models_(std::move(models)) {}

  // For the packages' shadows.
  const std::shared_ptr<const PackageModels>& models() const { return models_; }

  std::string_view name() const override { return "packages"; }
  RenderStage stage() const override { return RenderStage::models; }
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  PixelBox extent(const FrameInput& frame) const override;
  void draw(FrameContext& context) override;

 private:
  std::shared_ptr<const PackageModels> models_;
};

}  // namespace skydrop::render
