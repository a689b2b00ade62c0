#include "render/clouds/placing_shader.h"

#include <vector>

#include "skydrop/render/clouds/cloud_shadow_map.h"
#include "skydrop/render/clouds/ice_shade.h"
#include "skydrop/render/frame/place_map.h"
#include "skydrop/render/shadows/land_shadow_map.h"

namespace skydrop::render {

gl::ComputeShader& placingShader(FrameContext& context, const LandGround& land, const std::string& file) {
  const auto* clouds = context.resources.find<CloudShadowMap>();
  const auto* shade = context.resources.find<LandShadowMap>();
  const auto* ice = context.resources.find<IceShade>();
  const auto* places = context.resources.find<PlaceMap>();
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
    return context.shaders.computeShader(file, defines);
  };
  const bool hasSun = clouds && clouds->hasSun();
  if (context.frame.looksAhead()) {  // the sun and the land's shade may come and go
    if (clouds) variant(!hasSun, shade != nullptr);
    if (context.frame.features.landShadows) variant(hasSun, shade == nullptr);
  }
  gl::ComputeShader& shader = variant(hasSun, shade != nullptr);
  shader.use();
  const View& view = context.frame.view;
  if (clouds) clouds->bind(shader);
  if (shade) shade->bind(shader, {view.position.x, view.position.z});
  if (ice) ice->bind(shader, view);
  if (places) places->set(shader, land.base());
  land.setGround(shader, view);
  return shader;
}

}  // namespace skydrop::render
