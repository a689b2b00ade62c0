// Trees that stand on the land: near by as meshes, farther as pictures of them, chosen and placed on the GPU
// in each frame (docs/vegetation.md). They are part of the scene: lit as the land is, behind clouds and fog.
#pragma once

#include <memory>
#include <vector>

#include "skydrop/render/frame/land_ground.h"
#include "skydrop/render/frame/pass.h"
#include "skydrop/render/frame/standing_woods.h"
#include "skydrop/render/gl/buffer.h"
#include "skydrop/render/gl/frame_buffer.h"
#include "skydrop/render/gl/vertex_array.h"
#include "skydrop/render/vegetation/vegetation_settings.h"
#include "skydrop/terrain/woods.h"

namespace skydrop::render {

// Publishes StandingWoods for the pass that draws the land. Draws nothing.
class WoodFloorPass final : public Pass {
 public:
  WoodFloorPass(const VegetationSettings& settings, double density)
      : settings_(settings), density_(density) {}

  // For the next frame. Costs nothing.
  void apply(const VegetationSettings& settings, double density) { settings_ = settings, density_ = density; }

  std::string_view name() const override { return "woodFloor"; }
  RenderStage stage() const override { return RenderStage::shadows; }
  void draw(FrameContext& context) override;

 private:
  VegetationSettings settings_;
  double density_;
  StandingWoods woods_;  // published
};

class VegetationPass final : public Pass {
 public:
  // `woods`: those of the land that is drawn, not null; their density counts, whether or not they are
  // obstacles.
  VegetationPass(gl::Context& context, std::shared_ptr<const terrain::Woods> woods,
                 const VegetationSettings& settings);

  // For the next frame; the atlas is drawn anew where its size changes.
  void apply(std::shared_ptr<const terrain::Woods> woods, const VegetationSettings& settings);

  std::string_view name() const override { return "vegetation"; }
  RenderStage stage() const override { return RenderStage::terrain; }
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  std::optional<std::string> skipReasonAfter(const FrameInput& frame,
                                             const FrameResources& resources) const override;
  bool isMirrored() const override { return true; }
  void draw(FrameContext& context) override;

  // How many of the last frame drawn were meshes, of the three kinds, and impostors. Waits for the GPU: for
  // tests.
  std::array<std::uint32_t, 4> drawn() const;
  // What of the last frame was placed as meshes (or as impostors): feet relative to the eye, and heights.
  // Waits for the GPU: for tests.
  std::vector<glm::vec4> feet(int list) const;
  const gl::Texture& atlas() const { return atlas_; }

 private:
  struct Kind {
    GLsizei indices = 0;
    GLuint firstIndex = 0;
    GLint baseVertex = 0;
    float slender = 0, reach = 0;
  };

  void makeRoom(std::size_t tiles, std::size_t nearTiles);
  void place(FrameContext& context, const LandGround& land, std::size_t tiles);
  void bakeAtlas(FrameContext& context);
  void drawMeshes(FrameContext& context);
  void drawImpostors(FrameContext& context);

  gl::Context& context_;
  std::shared_ptr<const terrain::Woods> woods_;
  VegetationSettings settings_;
  std::array<Kind, 3> kinds_;
  gl::Buffer vertices_, indices_, tiles_, instances_, commands_;
  gl::VertexArray trees_;
  gl::Texture atlas_;
  GLuint firstQuadIndex_ = 0;
  std::size_t meshRoom_ = 0, impostorRoom_ = 0;  // instances of each list
};

}  // namespace skydrop::render
