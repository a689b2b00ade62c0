// The squares of the ground's materials on the GPU, for the pass that draws the land (docs/ground-detail.md).
#pragma once

#include <memory>

#include "skydrop/render/frame/ground_detail.h"
#include "skydrop/render/frame/pass.h"
#include "skydrop/terrain/ground_relief.h"

namespace skydrop::render {

// Publishes GroundDetail before the land is drawn. Draws nothing. On the context's thread; must go before the
// context.
class GroundDetailPass final : public Pass {
 public:
  // `relief`: squares made before, or null; of another number of texels than the settings ask for they are
  // made again, which takes up to a second.
  GroundDetailPass(gl::Context& context, const std::shared_ptr<const terrain::GroundRelief>& relief,
                   const terrain::GroundDetailSettings& settings);

  // For the next frame; squares of another number of texels are made at once.
  void apply(const terrain::GroundDetailSettings& settings);

  std::string_view name() const override { return "groundDetail"; }
  RenderStage stage() const override { return RenderStage::shadows; }
  void draw(FrameContext& context) override;

  const gl::Texture& squares() const { return squares_; }

 private:
  void upload(const terrain::GroundRelief& relief);

  gl::Context& context_;
  gl::Texture squares_;
  terrain::GroundDetailSettings settings_;
  GroundDetail detail_;  // published
};

}  // namespace skydrop::render
