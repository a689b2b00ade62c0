#include "skydrop/render/frame/frame_uniforms.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace skydrop::render {
namespace {

glm::vec4 rgb(const glm::dvec3& light, double w = 0) {
  return glm::vec4(glm::vec3(light), static_cast<float>(w));
}

constexpr double kTimeWrap = 3600;  // s: keeps float time exact to 0.25 ms

}  // namespace

FrameUniforms frameUniforms(const View& view, const SkyLight& light, double simulatedSeconds) {
  const double e = light.exposure;
  FrameUniforms u{};
  u.viewProjection = viewProjection(view);
  u.ndcToRay = glm::mat4(glm::mat3(rayMatrix(view)));
  u.eye = glm::vec4(view.position.y, view.nearM, e, std::fmod(simulatedSeconds, kTimeWrap));
  u.viewport = glm::vec4(view.width, view.height, 1.0 / view.width, 1.0 / view.height);
  u.toSun = rgb(light.direct.toSun, light.directRadiusRad);
  u.skySun = rgb(light.toSun, kSunRadiusRad);
  u.sunLight = rgb(light.direct.sun * e);
  u.skyLight = rgb(light.sky * e);
  u.groundLight = rgb(light.ground * e);
  u.sunDisc = rgb(sunDiscRadiance(light) * e);
  // Of the closed form: moonlight scattered by the air is the same in all directions.
  const glm::dvec3 night =
      light.night + (light.moon ? light.moon->illuminance / std::numbers::pi : glm::dvec3(0));
  u.nightRadiance = rgb(night * e);
  u.airRayleigh = rgb(light.air.rayleigh, light.air.rayleighHeight);
  u.airHaze = glm::vec4(light.air.haze, light.air.hazeHeight, light.air.hazeAlbedo, light.air.hazeAnisotropy);
  u.columnDepth = rgb(light.column.depth, light.column.sunMass);
  u.columnHere = rgb(light.column.airHere, light.column.hazeHere);
  u.airLight = rgb(light.column.airLight * light.sunOutside * e);
  u.hazeLight = rgb(light.column.hazeLight * light.sunOutside * e);
  u.overhead = rgb(light.column.overhead * light.sunOutside * e);
  const double height = std::max(view.position.y, 1.0);
  u.depthToSea = rgb(sky::opticalDepth(light.air, height, 0, height), view.pixelAngleRad());
  u.horizonRayleigh = rgb(light.horizon.rayleigh * light.sunOutside * e);
  u.horizonHaze = rgb(light.horizon.haze * light.sunOutside * e);
  u.horizonIsotropic = rgb((light.horizon.isotropic * light.sunOutside + night) * e);
  const glm::dvec3& glow = light.toGlow();
  const double across = std::hypot(glow.x, glow.z), perAcross = across > 1e-6 ? 1 / across : 0;
  const sky::SkyView* sky = light.view.get();
  u.skyTable =
      glm::vec4(sky ? sky->horizon : 0, sky ? sky->airEnds : 1, glow.x * perAcross, glow.z * perAcross);
  u.skyGlow = rgb(glow);
  u.overcast = glm::vec4(light.overcast.cover, light.overcast.left,
                         std::clamp(light.overcast.baseM - view.position.y, 1.0, 1e5), 0);
  return u;
}

}  // namespace skydrop::render
