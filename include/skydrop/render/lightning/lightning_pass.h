#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "skydrop/render/frame/flash_light.h"
#include "skydrop/render/frame/fullscreen_triangle.h"
#include "skydrop/render/frame/pass.h"
#include "skydrop/render/gl/vertex_array.h"
#include "skydrop/weather/lightning.h"

namespace skydrop::render {

// The flash that shines in a frame. A resource of the frame, for the pass that draws it.
struct LitFlash {
  weather::Flash flash;
  weather::Channel channel;
  FlashLight light;         // what of it lights land and clouds
  double intensityKcd = 0;  // of the whole channel, times exposure
};

// The flash of the frame's weather (game::Snapshot::weather) that shines at its moment within sight of the
// eye: a function of the snapshot, the settings and the eye's place. Publishes LitFlash, and FlashLight where
// its light is more than a five-hundredth of what shows. Draws nothing.
//
// The intensity is that of the eye's impression (weather::kFlashIntensityKcd), held down so that white land
// below the channel has kMostShown at the most: a night's exposure is that of eyes that have got used to
// darkness. Exposure itself knows no flash: it follows from sun, moon and sky.
class LightningLightPass final : public Pass {
 public:
  static constexpr double kMostShown = 0.7;

  // groundM: height of land or sea at a place (x east, z south), m.
  using Ground = std::function<double(const glm::dvec2&)>;
  LightningLightPass(const weather::LightningSettings& settings, Ground groundM)
      : settings_(settings), groundM_(std::move(groundM)) {}

  // For the next frame. Costs nothing.
  void apply(const weather::LightningSettings& settings) { settings_ = settings; }

  std::string_view name() const override { return "lightningLight"; }
  RenderStage stage() const override { return RenderStage::shadows; }
  // Without weather, and between flashes.
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  void draw(FrameContext& context) override;

 private:
  weather::LightningSettings settings_;
  Ground groundM_;
  LitFlash lit_;  // published; its channel is kept while the flash is the same
};

// The flash as it is looked at: the channel as a line of light, what the air around sends on of it
// (shared/flash.glsl), and the clouds that it lights from within, by how far each pixel's cloud is from the
// channel (CloudTransmittance). Skipped where nothing was published.
class LightningPass final : public Pass {
 public:
  // The context must outlive it.
  explicit LightningPass(gl::Context& context);

  std::string_view name() const override { return "lightning"; }
  RenderStage stage() const override { return RenderStage::translucents; }
  std::optional<std::string> skipReasonAfter(const FrameInput& frame,
                                             const FrameResources& resources) const override;
  // Throws core::DataError where its shaders do not compile.
  void draw(FrameContext& context) override;

 private:
  struct Piece {
    glm::vec4 from, to;  // as in shaders/lightning/channel_place.glsl
  };

  void drawGlow(FrameContext& context, const LitFlash& lit);
  void drawChannel(FrameContext& context, const LitFlash& lit);

  gl::Buffer pieces_, corners_;
  gl::VertexArray array_;
  FullscreenTriangle triangle_;
};

}  // namespace skydrop::render
