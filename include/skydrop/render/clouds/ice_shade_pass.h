// What layers of ice leave of the light below them: on land, models and lower clouds. Draws a small map of
// its own, nothing into the scene.
#pragma once

#include <vector>

#include "skydrop/render/clouds/ice_layers.h"
#include "skydrop/render/clouds/ice_shade.h"
#include "skydrop/render/frame/fullscreen_triangle.h"
#include "skydrop/render/frame/pass.h"
#include "skydrop/render/gl/frame_buffer.h"

namespace skydrop::render {

// Publishes IceShade, and LightAtPlaces: what was published before it, times what ice leaves. Skipped, it
// publishes nothing. On the context's thread.
class IceShadePass final : public Pass, private IceShade, private LightAtPlaces {
 public:
  // Context and layers must outlive it.
  IceShadePass(gl::Context& context, const IceLayers& layers);

  std::string_view name() const override { return "iceShade"; }
  RenderStage stage() const override { return RenderStage::shadows; }
  // Without a layer, and with the light below the horizon.
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  // Throws core::DataError where a shader does not compile.
  void draw(FrameContext& context) override;

 private:
  LightShares below(const glm::dvec3& place) const override;
  void bind(gl::ShaderProgram& shader, const View& view) const override;
  LightShares at(const glm::dvec3& place) const override;

  void drawMap(FrameContext& context);

  const IceLayers& layers_;
  FullscreenTriangle triangle_;
  gl::FrameBuffer map_;
  // Of the frame being drawn.
  std::vector<clouds::IceField> fields_;
  glm::dvec3 toSun_{0, 1, 0};
  double skyGain_ = 0;    // of what is scattered, over the light of the sky
  glm::dvec2 corner_{0};  // of the map, m in the world
  double middleM_ = 0;    // height of the layers' middles
  const LightAtPlaces* before_ = nullptr;
};

}  // namespace skydrop::render
