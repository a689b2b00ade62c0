#include "skydrop/render/shafts/light_shaft_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "render/frame/visibility.h"
#include "skydrop/core/light_shafts.h"
#include "skydrop/render/clouds/cloud_shadow_map.h"
#include "skydrop/render/frame/cloud_transmittance.h"
#include "skydrop/render/frame/sky_light.h"

namespace skydrop::render {
namespace {

namespace shared = core::shared::f64;

constexpr GLuint kDepthUnit = 0, kMarchedUnit = 1;  // as in shaders/shafts
constexpr double kLeastTopM = 1;

GLuint groups(int texels) { return static_cast<GLuint>(texels + 7) / 8; }

// A moon that lights less than this of what the night itself does on level ground throws no shafts: they
// could not be seen.
constexpr double kLeastOverNight = 1;

// Illuminance by the sun, or the moon, on the air at heights from the sea up, times exposure. On the flat
// earth of the shade it sets at one moment for all heights.
std::array<glm::vec4, shared::kShaftHeights> sunAtHeights(const SkyLight& light, double topM) {
  const double share = shared::sunVisibleShare(light.direct.toSun.y) * light.exposure;
  std::array<glm::vec4, shared::kShaftHeights> nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double height = topM * static_cast<double>(i) / (shared::kShaftHeights - 1);
    nodes[i] = glm::vec4(glm::vec3(sky::sunIlluminance(light.direct, height) * share), 0);
  }
  return nodes;
}

// The share of what the air scatters of this light that has its direction (SkyLight::sunGlow). The closed
// form has moonlight from all directions.
double glowOf(const SkyLight& light) {
  const bool isMoon = light.moon && light.direct.toSun == light.moon->toMoon;
  return isMoon ? light.moonGlow : 1;
}

}  // namespace

LightShaftPass::Shade LightShaftPass::shadeOf(const FrameInput& frame, const FrameResources& resources) {
  Shade shade{resources.find<CloudShadowMap>(), resources.find<LandShadowMap>()};
  if (shade.clouds && !shade.clouds->hasSun() && !frame.warmsUp) shade.clouds = nullptr;
  return shade;
}

std::optional<std::string> LightShaftPass::skipReason(const FrameInput& frame) const {
  if (frame.warmsUp) return std::nullopt;
  if (!frame.features.haze) return "there is no haze";
  if (frame.toSun.y <= -std::sin(kSunRadiusRad)) return "neither sun nor moon is above the horizon";
  if (frame.lightOverNight < kLeastOverNight) return "the moon lights the air too little to be seen";
  return std::nullopt;
}

std::optional<std::string> LightShaftPass::skipReasonAfter(const FrameInput& frame,
                                                           const FrameResources& resources) const {
  const Shade shade = shadeOf(frame, resources);
  if (!shade.clouds && !shade.land) return "nothing shades the air";
  if (frame.warmsUp) return std::nullopt;
  if (frame.view.position.y >= topM(frame, shade) && leastRise(frame.view) >= 0)
    return "the view lies above all shade";
  return std::nullopt;
}

double LightShaftPass::topM(const FrameInput& frame, const Shade& shade) const {
  double top = kLeastTopM;
  if (shade.clouds) top = std::max(top, frame.view.position.y + shade.clouds->topAboveEyeM());
  if (shade.land && shade.land->shade()) top = std::max(top, shade.land->shade()->topM());
  return top;
}

void LightShaftPass::resize(FrameContext& context) {
  const View& view = context.frame.view;
  const int spacing = spacingOf(settings_);
  const int width = (view.width + spacing - 1) / spacing, height = (view.height + spacing - 1) / spacing;
  if (marched_ && marched_.width() == width && marched_.height() == height) return;
  marched_ = {};
  filtered_ = {};
  marched_ = gl::Texture::make2D(context.gl, GL_RGBA16F, width, height, "marched shafts");
  filtered_ = gl::Texture::make2D(context.gl, GL_RGBA16F, width, height, "filtered shafts");
}

void LightShaftPass::draw(FrameContext& context) {
  resize(context);
  const Shade shade = shadeOf(context.frame, context.resources);
  if (shade.land)
    land_.take(context.gl, *shade.land);
  else
    land_ = {};
  context.sceneDepth.bind(kDepthUnit);
  // Later frames may have one shade without the other: in frames that nobody sees, what those are marched
  // with is compiled too.
  if (shade.clouds && shade.land && context.frame.warmsUp) {
    march(context, {shade.clouds, nullptr});
    march(context, {nullptr, shade.land});
  }
  march(context, shade);
  compose(context, shade);
}

void LightShaftPass::march(FrameContext& context, const Shade& shade) {
  std::vector<std::string> defines = withCloudTransmittance(context.defines, context.resources);
  if (shade.clouds) {
    for (const std::string& define : shade.clouds->defines(true)) defines.push_back(define);
    defines.emplace_back("CLOUD_SHADE");
  }
  if (shade.land) defines.emplace_back(LandShadowMap::kDefine);
  gl::ComputeShader& shader = context.shaders.computeShader("shafts/march.comp", defines);
  const View& view = context.frame.view;
  if (shade.clouds) shade.clouds->bind(shader);
  if (shade.land) land_.bind(shader, {view.position.x, view.position.z});
  const double top = topM(context.frame, shade);
  setScene(shader, top);
  shader.setInt("steps", static_cast<int>(settings_.steps));
  shader.setVec4s("sunAtHeights", sunAtHeights(context.light, top));
  shader.setFloat("glow", static_cast<float>(glowOf(context.light)));
  marched_.bindImage(0, GL_WRITE_ONLY);
  shader.dispatch(groups(marched_.width()), groups(marched_.height()));
}

// As in shaders/shafts/scene.glsl.
void LightShaftPass::setScene(gl::ShaderProgram& shader, double topM) const {
  shader.setInt("spacing", spacingOf(settings_));
  shader.setFloat("topM", static_cast<float>(topM));
  shader.setFloat("reachM", static_cast<float>(settings_.distanceM));
}

void LightShaftPass::compose(FrameContext& context, const Shade& shade) {
  const gl::Functions& api = context.gl.api();
  api.MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  marched_.bind(kMarchedUnit);
  filtered_.bindImage(0, GL_WRITE_ONLY);
  context.shaders.computeShader("shafts/filter.comp", {})
      .dispatch(groups(marched_.width()), groups(marched_.height()));
  api.MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  filtered_.bind(kMarchedUnit);
  gl::ComputeShader& shader = context.shaders.computeShader(
      "shafts/compose.comp", withCloudTransmittance(context.defines, context.resources));
  setScene(shader, topM(context.frame, shade));
  context.sceneColor.bindImage(0, GL_READ_WRITE);
  shader.dispatch(groups(context.frame.view.width), groups(context.frame.view.height));
  api.MemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

}  // namespace skydrop::render
