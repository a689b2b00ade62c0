// Draws the maps of the shadows that fall on land in view.
#pragma once

#include <utility>
#include <vector>

#include "skydrop/render/frame/pass.h"
#include "skydrop/render/models/shadow_source.h"
#include "skydrop/render/shadows/cast_shadows.h"

namespace skydrop::render {

// Publishes CastShadows in frames in which a shadow falls into view, for the passes from stage terrain on; in
// other frames it is skipped and publishes nothing. If more shadows fall into view than CastShadows::kMost,
// those of the casters nearest to the eye are drawn, in the order of their sources where two are as near.
// Main thread; it owns the maps, which are made at the first shadow and must go before the context. Asks for
// nothing.
class ShadowPass final : public Pass {
 public:
  // From the next frame on. Not null. There is no way to take one out: sources live as long as the pass.
  void add(ShadowSource source) { sources_.push_back(std::move(source)); }

  std::string_view name() const override { return "shadows"; }
  RenderStage stage() const override { return RenderStage::shadows; }
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  // Only where skipReason() gave none. Throws core::DataError where its shader does not compile.
  void draw(FrameContext& context) override;

 private:
  std::vector<ShadowCaster> castersIn(const FrameInput& frame) const;

  std::vector<ShadowSource> sources_;
  CastShadows shadows_;
};

}  // namespace skydrop::render
