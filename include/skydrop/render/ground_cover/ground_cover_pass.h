// What stands on the ground near the eye: grass, flowers, reeds, stones, placed on the GPU in each frame
// (docs/ground-cover.md). It is part of the scene: lit as the land is, behind clouds and fog.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "skydrop/render/frame/land_ground.h"
#include "skydrop/render/frame/pass.h"
#include "skydrop/render/gl/buffer.h"
#include "skydrop/render/gl/vertex_array.h"
#include "skydrop/render/ground_cover/ground_cover_settings.h"
#include "skydrop/terrain/height_source.h"

namespace skydrop::render {

class GroundCoverPass final : public Pass {
 public:
  // Tufts with fine blades, tufts, flowers, reeds, stones of few pixels, stones, boulders close by.
  static constexpr std::size_t kLists = 7;

  // `ground`: the land that is drawn, not null.
  GroundCoverPass(gl::Context& context, std::shared_ptr<const terrain::HeightSource> ground,
                  const GroundCoverSettings& settings);

  // For the next frame.
  void apply(const GroundCoverSettings& settings) { settings_ = settings; }

  std::string_view name() const override { return "groundCover"; }
  RenderStage stage() const override { return RenderStage::terrain; }
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  std::optional<std::string> skipReasonAfter(const FrameInput& frame,
                                             const FrameResources& resources) const override;
  bool isMirrored() const override { return true; }
  void draw(FrameContext& context) override;

  // How many of each list the last frame drawn had. Waits for the GPU: for tests.
  std::array<std::uint32_t, kLists> drawn() const;
  // Their feet, relative to the eye, and heights (m). Waits for the GPU: for tests.
  std::vector<glm::vec4> feet(std::size_t list) const;

 private:
  struct Mesh {
    GLuint indices = 0, firstIndex = 0;
    GLint baseVertex = 0;
  };

  void makeRoom(std::size_t tiles);
  void place(FrameContext& context, const LandGround& land, std::size_t tiles);

  gl::Context& context_;
  std::shared_ptr<const terrain::HeightSource> ground_;
  GroundCoverSettings settings_;
  std::array<Mesh, kLists> meshes_;
  gl::Buffer vertices_, indices_, tiles_, instances_, lists_, commands_;
  gl::VertexArray cover_;
  std::size_t room_ = 0;  // cells, each an instance that may be; and so many numbers in each list
};

}  // namespace skydrop::render
