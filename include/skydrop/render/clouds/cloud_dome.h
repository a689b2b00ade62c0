// Clouds on a hemisphere at infinity: behind land, aircraft and all other clouds, before the sky.
// docs/cloud-planes-and-dome.md tells how. Source: Tarantilis, "Simulating clouds with procedural texturing
// techniques using the GPU", 2004, chapters III and IV.
#pragma once

#include <glm/vec3.hpp>
#include <memory>

#include "skydrop/clouds/cloud_dome_settings.h"
#include "skydrop/core/latest_job.h"
#include "skydrop/render/clouds/sheet_noise.h"
#include "skydrop/render/frame/pass.h"
#include "skydrop/render/gl/buffer.h"
#include "skydrop/render/gl/texture.h"
#include "skydrop/render/gl/vertex_array.h"

namespace skydrop::render {

// How far the noise has moved past the dome, in copies of the volume along its axes, each in [0, 1): wrapped
// in double, so it is exact after months. seconds: simulated.
glm::dvec3 domeOffset(const clouds::CloudDomeSettings& settings, double seconds);

class SheetLayer;
class SheetShade;

class CloudDome final : public Pass {
 public:
  // prepared: null, or of other settings: what is missing is made beside the first frames.
  CloudDome(gl::Context& context, const PreparedDomeNoise* prepared,
            const clouds::CloudDomeSettings& settings);
  ~CloudDome() override;

  // For the next frame. Noise that is asked for anew is made beside the frame; until then the dome looks as
  // it did.
  void apply(const clouds::CloudDomeSettings& settings);
  // Returns when no noise is being made.
  void waitForNoise();

  std::string_view name() const override { return "cloudDome"; }
  RenderStage stage() const override { return RenderStage::skySheets; }
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  void settle(const FrameInput&) override { waitForNoise(); }
  void draw(FrameContext& context) override;

 private:
  struct Made {
    clouds::CloudDomeSettings of;
    std::shared_ptr<const SheetNoise> noise;
  };

  void take(std::shared_ptr<const SheetNoise> noise);
  void upload();
  // shaded: mountains may take some of the sun's light.
  void drawSheet(FrameContext& context, bool shaded);
  // The dome's light by this program, into the target that is bound.
  void drawLight(FrameContext& context, gl::Shader& shader);
  void drawMesh(FrameContext& context, gl::Shader& shader);

  gl::Context& context_;
  clouds::CloudDomeSettings settings_;
  clouds::CloudDomeSettings asked_;          // whose noise is there or being made
  std::shared_ptr<const SheetNoise> noise_;  // null until it has been made once
  bool isUploaded_ = false;
  gl::Texture texture_;
  std::unique_ptr<SheetLayer> layer_;
  std::unique_ptr<SheetShade> shade_;
  gl::Buffer vertices_, indices_;
  gl::VertexArray mesh_;
  GLsizei indexCount_ = 0;
  core::LatestJob<clouds::CloudDomeSettings, Made> job_;
};

}  // namespace skydrop::render
