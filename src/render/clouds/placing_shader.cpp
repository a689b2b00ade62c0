#include "render/clouds/placing_shader.h"

#include <vector>

#include "skydrop/render/clouds/cloud_shadow_map.h"
#include "skydrop/render/clouds/ice_shade.h"
#include "skydrop/render/frame/fallen_water.h"
#include "skydrop/render/frame/flash_light.h"
#include "skydrop/render/frame/place_map.h"
#include "skydrop/render/frame/spot_light.h"
#include "skydrop/render/shadows/land_shadow_map.h"

namespace skydrop::render {

namespace {

// Of frames without: in programs that are compiled for them.
const SpotLight kNoSpot;
const FlashLight kNoFlash = [] {
  FlashLight none;
  none.places.fill({0, 1e4, 0, 1});
  return none;
}();
const FallenWater kNothingFallen{.snowLineM = 1e9};

}  // namespace

// Lamp, flash and snow are compiled in where the scene may have them, and dark in frames without: as variants
// they would be eight times as many, and what they take for an instance is not to be seen beside the rest of
// it.
gl::ComputeShader& placingShader(FrameContext& context, const LandGround& land, const std::string& file) {
  const FrameFeatures& features = context.frame.features;
  const auto* clouds = context.resources.find<CloudShadowMap>();
  const auto* shade = context.resources.find<LandShadowMap>();
  const auto* ice = context.resources.find<IceShade>();
  const auto* places = context.resources.find<PlaceMap>();
  const auto* spot = context.resources.find<SpotLight>();
  const auto* flash = context.resources.find<FlashLight>();
  const auto* fallen = context.resources.find<FallenWater>();
  const auto variant = [&](bool hasSun, bool hasLand) -> gl::ComputeShader& {
    std::vector<std::string> defines(context.defines.begin(), context.defines.end());
    if (land.hasAlpineBelts()) defines.emplace_back("ALPINE_BELTS");
    if (clouds) {
      for (const std::string& define : clouds->defines(hasSun)) defines.push_back(define);
      defines.emplace_back("CLOUD_SHADE");
    }
    if (hasLand) defines.emplace_back(LandShadowMap::kDefine);
    if (ice) defines.emplace_back("ICE_SHADE");
    if (places) defines.emplace_back(PlaceMap::kDefine);
    if (features.spotLight) defines.emplace_back(SpotLight::kDefine);
    if (features.flashLight) defines.emplace_back(FlashLight::kDefine);
    if (features.fallenWater) defines.emplace_back(FallenWater::kDefine);
    return context.shaders.computeShader(file, defines);
  };
  const bool hasSun = clouds && clouds->hasSun();
  if (context.frame.looksAhead()) {  // the sun and the land's shade may come and go
    if (clouds) variant(!hasSun, shade != nullptr);
    if (features.landShadows) variant(hasSun, shade == nullptr);
  }
  gl::ComputeShader& shader = variant(hasSun, shade != nullptr);
  shader.use();
  const View& view = context.frame.view;
  if (clouds) clouds->bind(shader, context.frame.eyeRiseM());
  if (shade) shade->bind(shader, {view.position.x, view.position.z});
  if (ice) ice->bind(shader, view);
  if (places) places->set(shader, land.base());
  if (features.spotLight) (spot ? *spot : kNoSpot).set(shader, view);
  if (features.flashLight) (flash ? *flash : kNoFlash).set(shader);
  if (features.fallenWater) (fallen ? *fallen : kNothingFallen).set(shader);
  land.setGround(shader, view);
  return shader;
}

}  // namespace skydrop::render
