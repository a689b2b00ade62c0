// Cloud planes over the scene: level sheets of noise that follow the eye. docs/cloud-planes-and-dome.md tells
// how. Source: Tarantilis, "Simulating clouds with procedural texturing techniques using the GPU", 2004,
// chapters III and IV.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <memory>

#include "skydrop/clouds/cloud_planes_settings.h"
#include "skydrop/core/latest_job.h"
#include "skydrop/core/wind.h"
#include "skydrop/render/clouds/sheet_noise.h"
#include "skydrop/render/frame/pass.h"
#include "skydrop/render/gl/buffer.h"
#include "skydrop/render/gl/texture.h"
#include "skydrop/render/gl/vertex_array.h"

namespace skydrop::render {

// Where a plane's texture lies: of the copy that makes clouds, of the wide one that varies their cover, and
// of the fine one that frays their edges.
struct PlaneAnchor {
  glm::dvec2 texture, weather, fine;  // coordinates straight below or above the eye, [0, 1)
};

// World places are wrapped in double, so a place keeps its texel at 1e12 m too. seconds: simulated.
PlaneAnchor planeAnchor(const clouds::CloudPlaneSettings& layer, const core::WindSettings& wind,
                        const glm::dvec3& eye, double seconds);

// One layer: its texture and what is computed for it. Owned by CloudPlanes.
class CloudPlane {
 public:
  explicit CloudPlane(gl::Context& context);

  // Takes settings over; noise that they ask for anew is made beside the frame, and until then the layer
  // looks as it did.
  void apply(const clouds::CloudPlaneSettings& settings);
  // The noise of these settings, made elsewhere.
  void take(const clouds::CloudPlaneSettings& madeOf, std::shared_ptr<const SheetNoise> noise);
  // Asks for its noise, if it has none and none is being made.
  void prepare();
  void waitForNoise();

  const clouds::CloudPlaneSettings& settings() const { return settings_; }
  // Null until the noise has been made once.
  const SheetNoise* noise() const { return noise_.get(); }
  // Uploads what is new and returns the texture. Only where there is noise.
  const gl::Texture& texture();
  // Takes what was made since. Throws what ended it early.
  void update();

 private:
  struct Made {
    clouds::CloudPlaneSettings of;
    std::shared_ptr<const SheetNoise> noise;
  };

  gl::Context& context_;
  clouds::CloudPlaneSettings settings_;
  std::optional<clouds::CloudPlaneSettings> asked_;  // whose noise is there or being made
  std::shared_ptr<const SheetNoise> noise_;
  bool isUploaded_ = false;
  gl::Texture texture_;
  core::LatestJob<clouds::CloudPlaneSettings, Made> job_;
};

class SheetLayer;
class SheetShade;

// The pass of all layers, far to near. Holds textures of the layers that are drawn only.
class CloudPlanes final : public Pass {
 public:
  // prepared: null, or of other settings: what is missing is made beside the first frames.
  CloudPlanes(gl::Context& context, const PreparedPlaneNoise* prepared,
              const clouds::CloudPlanesSettings& settings, const core::WindSettings& wind);
  ~CloudPlanes() override;

  // For the next frame. Costs nothing but requests for noise.
  void apply(const clouds::CloudPlanesSettings& settings, const core::WindSettings& wind);
  // Returns when no noise is being made.
  void waitForNoise();

  std::string_view name() const override { return "cloudPlanes"; }
  RenderStage stage() const override { return RenderStage::cloudSheets; }
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  void settle(const FrameInput&) override { waitForNoise(); }
  void draw(FrameContext& context) override;

 private:
  // Why a layer does not touch the frame; null: it does.
  const char* idleReason(const FrameInput& frame, const CloudPlane& plane) const;
  // shaded: mountains may take some of the sun's light.
  void drawPlane(FrameContext& context, CloudPlane& plane, bool shaded);
  // The plane's light by this program, into the target that is bound.
  void drawLight(FrameContext& context, CloudPlane& plane, gl::Shader& shader);
  void drawMesh(FrameContext& context, gl::Shader& shader);
  void setPlace(gl::Shader& shader, const View& view, const CloudPlane& plane) const;
  std::size_t count() const { return static_cast<std::size_t>(settings_.count); }

  gl::Context& context_;
  clouds::CloudPlanesSettings settings_;
  core::WindSettings wind_;
  std::array<std::unique_ptr<CloudPlane>, clouds::kCloudPlanes> planes_;
  std::unique_ptr<SheetLayer> layer_;  // of whichever plane is being drawn
  std::unique_ptr<SheetShade> shade_;
  gl::Buffer vertices_, indices_;
  gl::VertexArray mesh_;
  GLsizei indexCount_ = 0;
};

}  // namespace skydrop::render
