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

// What of a frame comes and goes while one flies, each with a variant of the program.
struct Variant {
  bool cloudSun = false, landShade = false, spot = false, flash = false, fallen = false;
};

}  // namespace

gl::ComputeShader& placingShader(FrameContext& context, const LandGround& land, const std::string& file) {
  const auto* clouds = context.resources.find<CloudShadowMap>();
  const auto* shade = context.resources.find<LandShadowMap>();
  const auto* ice = context.resources.find<IceShade>();
  const auto* places = context.resources.find<PlaceMap>();
  const auto* spot = context.resources.find<SpotLight>();
  const auto* flash = context.resources.find<FlashLight>();
  const auto* fallen = context.resources.find<FallenWater>();
  const auto variant = [&](const Variant& of) -> gl::ComputeShader& {
    std::vector<std::string> defines(context.defines.begin(), context.defines.end());
    if (land.hasAlpineBelts()) defines.emplace_back("ALPINE_BELTS");
    if (clouds) {
      for (const std::string& define : clouds->defines(of.cloudSun)) defines.push_back(define);
      defines.emplace_back("CLOUD_SHADE");
    }
    if (of.landShade) defines.emplace_back(LandShadowMap::kDefine);
    if (ice) defines.emplace_back("ICE_SHADE");
    if (places) defines.emplace_back(PlaceMap::kDefine);
    if (of.spot) defines.emplace_back(SpotLight::kDefine);
    if (of.flash) defines.emplace_back(FlashLight::kDefine);
    if (of.fallen) defines.emplace_back(FallenWater::kDefine);
    return context.shaders.computeShader(file, defines);
  };
  const Variant now{clouds && clouds->hasSun(), shade != nullptr, spot != nullptr, flash != nullptr,
                    fallen != nullptr};
  if (context.frame.looksAhead()) {  // the next frame may differ in one of them
    const auto ask = [&](bool Variant::*one, bool mayChange) {
      if (!mayChange) return;
      Variant next = now;
      next.*one = !(next.*one);
      variant(next);
    };
    const FrameFeatures& features = context.frame.features;
    ask(&Variant::cloudSun, clouds != nullptr);
    ask(&Variant::landShade, features.landShadows);
    ask(&Variant::spot, features.spotLight);
    ask(&Variant::flash, features.flashLight);
    ask(&Variant::fallen, features.fallenWater);
  }
  gl::ComputeShader& shader = variant(now);
  shader.use();
  const View& view = context.frame.view;
  if (clouds) clouds->bind(shader, context.frame.eyeRiseM());
  if (shade) shade->bind(shader, {view.position.x, view.position.z});
  if (ice) ice->bind(shader, view);
  if (places) places->set(shader, land.base());
  if (spot) spot->set(shader, view);
  if (flash) flash->set(shader);
  if (fallen) fallen->set(shader);
  land.setGround(shader, view);
  return shader;
}

}  // namespace skydrop::render
