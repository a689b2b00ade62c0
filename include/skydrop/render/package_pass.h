#pragma once

#include "skydrop/render/model.h"
#include "skydrop/render/pass.h"

namespace skydrop::render {

// The packages under way and those that have landed, with their parachutes.
class PackagePass final : public Pass {
 public:
  // Reads assets/models/package.glb and parachute.glb. Throws core::DataError.
  explicit PackagePass(gl::Context& context);

  std::string_view name() const override { return "packages"; }
  Slot slot() const override { return Slot::models; }
  std::optional<std::string> idleReason(const FrameInput& frame) const override;
  void draw(FrameContext& context) override;

 private:
  void drawPackage(FrameContext& context, const game::PackageSnapshot& package) const;

  Model crate_, parachute_;
};

}  // namespace skydrop::render
