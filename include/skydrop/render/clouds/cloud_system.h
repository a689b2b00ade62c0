// Volumetric clouds over the scene: a compute pass over linear colour and depth. docs/clouds.md tells how.
// Sources: Schneider and Vos 2015 (the medium), Hillaire, "Physically Based Sky, Atmosphere and Cloud
// Rendering in Frostbite", 2016 (the integral over a step), Wrenninge 2015 (octaves of scattering).
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "skydrop/clouds/cloud_field.h"
#include "skydrop/clouds/cloud_settings.h"
#include "skydrop/core/wind.h"
#include "skydrop/render/clouds/cloud_rays.h"
#include "skydrop/render/clouds/cloud_shadow_map.h"
#include "skydrop/render/frame/cloud_transmittance.h"
#include "skydrop/render/frame/light_shares.h"
#include "skydrop/render/frame/pass.h"
#include "skydrop/render/gl/buffer.h"
#include "skydrop/render/shadows/land_shade_volume.h"

namespace skydrop::weather {
struct WeatherSettings;
}

namespace skydrop::render {

class CloudHistory;
class CloudTextures;
class LightVolumes;
class SunOpticalDepthGrid;
class WeatherLayers;

// Draws the layers of the weather around the eye (game::Snapshot::weather) that are volumes, all in one march
// (docs/cloud-layers.md); without weather, layer 0 of the settings (clouds::kCloudLayers). On the context's
// thread; it owns its textures and grids; those with a texel a ray are made again when the view's size
// changes. Publishes CloudTransmittance in frames in which it is not skipped; needs FrameContext::sceneDepth
// of all that may hide clouds.
class CloudSystem final : public Pass {
 public:
  // `noise` is kept: not null, as clouds::packCloudNoise() makes it. Works out the occupancy of each layer.
  // The context must outlive the system.
  CloudSystem(gl::Context& context, std::shared_ptr<const clouds::PackedCloudNoise> noise,
              const clouds::CloudSettings& settings, const core::WindSettings& wind);
  ~CloudSystem() override;

  // Takes the settings over for the next frame, between frames. Where the field of a layer changed
  // (clouds::isSameField) its occupancy is built again before this returns (clouds::Occupancy has the time),
  // beside it on a thread that ends with it clouds::ClearAir and clouds::SkyCover, and shadow maps are filled
  // again in the next frame; where only MarchSettings::detail changed, the shadow maps alone; else it costs
  // nothing.
  void apply(const clouds::CloudSettings& settings, const core::WindSettings& wind);

  // Works the layers of a frame's weather out; draw() and shadowMap() do so themselves, lightAt() needs it.
  void prepare(const FrameInput& frame);

  std::string_view name() const override { return "clouds"; }
  RenderStage stage() const override { return RenderStage::clouds; }
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  // By the layers of the weather that lie above the eye. Works them out.
  Overcast overcast(const FrameInput& frame) override;
  // Only where skipReason() gave none. Throws core::DataError where a shader does not compile.
  void draw(FrameContext& context) override;

  // What the clouds leave of sun and sky on surfaces in this frame, within its draw: CloudShadowPass asks for
  // it. Its textures belong to the system and are valid until it is asked for in the next frame. Only where
  // shadowSkipReason() gives no reason why there are no shadows. Throws core::DataError where a shader does
  // not compile.
  CloudShadowMap shadowMap(FrameContext& context);
  // Gives up what shadowMap() has made; it is made again when it is asked for.
  void forgetShadowMap();
  // The same at a place in the world, worked out on the processor (clouds::sunOpticalDepth(): 28 us a layer).
  // After prepare() of the frame.
  LightShares lightAt(const glm::dvec3& place, const FrameInput& frame) const;
  std::optional<std::string> shadowSkipReason(const FrameInput& frame) const;

  // Which form the loops of the march have from the next frame on: flat ones for a software renderer, plain
  // ones for a graphics card. Both give the same picture; the context decides unless told (measuring, tests).
  void setFlatLoops(bool flat) { flatLoops_ = flat; }

  // What the last frame that was not skipped marched; 0 before the first. Waits for the GPU.
  struct Work {
    unsigned tiles = 0;  // of 16 x 16 pixels; of 8 x 8 in the exact march
    // Rays that were marched between those that every tile has: 2 pixels and 1 pixel apart.
    unsigned raysBetween = 0, finestRays = 0;
    // Of those that every tile has, where history leaves some out; else 0.
    unsigned widestRays = 0;
  };
  Work lastWork() const;
  // Pictures of rays 1, 2 and 4 pixels apart of the last frame that was not skipped: what they see and where,
  // as in CloudTransmittance. No objects for rays that the settings have no use for.
  const std::array<CloudRays, 3>& rays() const { return rays_; }
  // CloudTransmittance::light of the last frame that was not skipped; no object before the first.
  const gl::Texture& light() const { return rays_[0].light; }
  // The history that the last frame left for the next: null where it left none.
  CloudHistory* history() const { return history_.get(); }

 private:
  void update(FrameContext& context, SunOpticalDepthGrid& grid, double cellM, double radiusM,
              const glm::dvec3& middle);
  CloudShadowMap shadowMapOfLayers(FrameContext& context);
  bool drawsWeather(const FrameInput& frame) const;
  // Takes the light volumes of the frame, where they are asked for and there.
  void takeVolumes(const FrameInput& frame);
  // The march's defines for the frame.
  std::vector<std::string> definesOf(const FrameContext& context) const;
  void setUniforms(FrameContext& context);
  // What the wind has carried the field by is taken off.
  glm::dvec3 inField(const glm::dvec3& place, const FrameInput& frame) const;
  glm::dvec3 eyeInField(const FrameInput& frame) const { return inField(frame.view.position, frame); }
  const clouds::CloudLayerSettings& layer() const { return settings_.layers[kMarchedLayer]; }
  using Defines = std::span<const std::string>;  // of the variant
  bool takeLandShade(FrameContext& context);
  void marchAll(FrameContext& context, Defines defines, bool shaded);
  gl::ComputeShader& marchShader(FrameContext& context, const std::string& file, Defines defines);
  void beginHistory(const FrameContext& context);
  void classify(FrameContext& context, Defines defines);
  void clearOthers(FrameContext& context, Defines defines);
  void march(FrameContext& context, Defines defines);
  void marchTiles(FrameContext& context, Defines defines, int widest);
  void refine(FrameContext& context, Defines defines, int spacing);
  void marchListed(FrameContext& context, Defines defines, int spacing, const gl::Buffer& list);
  void marchExactly(FrameContext& context, Defines defines);
  void marchMultiDispatch();
  void cover(FrameContext& context, Defines defines);
  CloudRays& raysApart(int spacing) { return rays_[static_cast<std::size_t>(spacing) / 2]; }
  void resize(const View& view);

  static constexpr std::size_t kMarchedLayer = 0;

  gl::Context& context_;
  clouds::CloudSettings settings_;
  core::WindSettings wind_;
  bool flatLoops_;
  std::unique_ptr<CloudTextures> textures_;
  std::shared_ptr<const clouds::PackedCloudNoise> noise_;
  std::unique_ptr<WeatherLayers> weather_;         // null until a frame has weather
  std::unique_ptr<LightVolumes> volumes_;          // null while they are not asked for
  std::vector<clouds::LayerMedium> shadowLayers_;  // that the shadow maps are of; none without weather
  std::unique_ptr<CloudHistory> history_;          // null in frames that use none
  std::shared_ptr<const weather::WeatherSettings> historyWeather_;  // that it is of
  std::unique_ptr<SunOpticalDepthGrid> fineShadowMap_, coarseShadowMap_;
  gl::Buffer uniforms_, unionUniforms_, tiles_, spans_;
  std::array<CloudRays, 3> rays_;         // 1, 2 and 4 pixels apart
  std::array<gl::Buffer, 2> listedRays_;  // 1 and 2 pixels apart
  glm::ivec2 tileCount_{0};
  CloudTransmittance transmittance_;  // published by draw()
  LandShadeVolume landShade_;
  bool isShaded_ = false;            // by land, what is being marched
  gl::Texture rayLight_, rayState_;  // of marches in parts
};

}  // namespace skydrop::render
