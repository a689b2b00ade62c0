#include "skydrop/render/clouds/ice_shade_pass.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "skydrop/core/shared_ice.h"

namespace skydrop::render {
namespace {

namespace shared = core::shared::f64;

// The map: so many texels along a side, on a lattice fixed in the world, so that nothing swims.
constexpr int kTexels = 32;
constexpr double kTexelM = 3000;
constexpr int kSamples = 2;  // through a layer; as in shaders/clouds/ice_shade.glsl
// The sun's rays pass through no more of a layer than this many times its upright depth, and reach no
// farther.
constexpr double kLeastSine = 0.1;
constexpr double kMostGain = 2;

constexpr std::array<const char*, 3> kGenusDefines = {"CIRRUS", "CIRROSTRATUS", "CIRROCUMULUS"};

double brightness(const glm::dvec3& rgb) { return 0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z; }

}  // namespace

IceShadePass::IceShadePass(gl::Context& context, const IceLayers& layers)
    : layers_(layers), triangle_(context), map_(context, kTexels, kTexels, {GL_R16F, 0}, "ice shade") {}

std::optional<std::string> IceShadePass::skipReason(const FrameInput& frame) const {
  if (frame.warmsUp) return std::nullopt;
  if (frame.toSun.y <= 0) return "the light is below the horizon";
  if (layers_.of(frame).empty()) return "no layer of ice";
  return std::nullopt;
}

void IceShadePass::draw(FrameContext& context) {
  fields_ = layers_.of(context.frame);
  toSun_ = context.frame.toSun;
  const double sky = brightness(context.light.sky);
  const double sun = brightness(context.light.direct.sun) * std::max(toSun_.y, 0.0);
  skyGain_ = sky > 0 ? std::min(sun / sky, kMostGain) : 0;
  middleM_ = 0;
  for (const clouds::IceField& field : fields_)
    middleM_ += 0.5 * (field.layer().baseM + field.layer().topM) / static_cast<double>(fields_.size());
  drawMap(context);
  context.resources.publish<IceShade>(*this);
  before_ = context.resources.replace<LightAtPlaces>(*this);
}

void IceShadePass::drawMap(FrameContext& context) {
  const glm::dvec3& eye = context.frame.view.position;
  const double reach = std::max(middleM_ - eye.y, 0.0) / std::max(toSun_.y, kLeastSine);
  const glm::dvec2 middle = glm::dvec2(eye.x, eye.z) + glm::dvec2(toSun_.x, toSun_.z) * reach;
  corner_ = (glm::floor(middle / kTexelM) - 0.5 * kTexels) * kTexelM;
  const gl::Functions& gl = context.gl.api();
  map_.bind();
  gl.Disable(GL_DEPTH_TEST);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
  const auto program = [&](std::size_t genus) -> gl::Shader& {
    const std::array<std::string, 1> defines = {kGenusDefines[genus]};
    return context.shaders.shader("fullscreen.vert", "clouds/ice_shade.frag", defines);
  };
  for (std::size_t genus = 0; genus < kGenusDefines.size(); ++genus) {
    gl::Shader& shader = program(genus);
    for (const clouds::IceField& field : fields_) {
      const clouds::IceLayer& layer = field.layer();
      if (static_cast<std::size_t>(layer.genus) != genus) continue;
      const clouds::IceAnchor anchor = field.anchor(corner_);
      shader.setIvec2("iceCell", glm::ivec2(anchor.cell));
      shader.setVec2("iceInside", glm::vec2(anchor.inside));
      shader.setVec2("iceAlong", glm::vec2(layer.along));
      shader.setVec3("iceForm", glm::vec3(layer.trailM, layer.hookM, field.threshold()));
      shader.setFloat("iceDepth", static_cast<float>(field.extinction() * (layer.topM - layer.baseM)));
      shader.setFloat("texelM", kTexelM);
      shader.use();
      triangle_.draw();
    }
  }
  map_.unBind();
}

LightShares IceShadePass::below(const glm::dvec3& place) const {
  const double sine = std::max(toSun_.y, kLeastSine);
  double depth = 0;
  for (const clouds::IceField& field : fields_) {
    const clouds::IceLayer& layer = field.layer();
    if (place.y >= layer.topM) continue;
    const double way = std::max(0.5 * (layer.baseM + layer.topM) - place.y, 0.0) / sine;
    depth +=
        field.depthAbove({place.x + toSun_.x * way, place.y, place.z + toSun_.z * way}, kSamples, kTexelM);
  }
  return {shared::iceSunLeft(depth / sine), 1 + shared::iceSpread(depth / sine) * skyGain_};
}

LightShares IceShadePass::at(const glm::dvec3& place) const {
  LightShares shares = before_ ? before_->at(place) : LightShares{};
  const LightShares ice = below(place);
  shares.sun *= ice.sun;
  shares.diffuseSun *= ice.sun;
  shares.sky *= ice.sky;
  return shares;
}

void IceShadePass::bind(gl::ShaderProgram& shader, const View& view) const {
  map_.colorTexture().bind(kMapUnit);
  const double sine = std::max(toSun_.y, kLeastSine);
  // A place below is moved along the sun's rays to the layers' middle.
  const glm::dvec2 along = glm::dvec2(toSun_.x, toSun_.z) / sine;
  const glm::dvec2 eye =
      glm::dvec2(view.position.x, view.position.z) - corner_ + along * (middleM_ - view.position.y);
  shader.setVec4("iceMapPlace", glm::vec4(glm::vec2(eye), glm::vec2(along)));
  shader.setVec3("iceMapScale", {static_cast<float>(1 / (kTexels * kTexelM)), static_cast<float>(1 / sine),
                                 static_cast<float>(skyGain_)});
}

}  // namespace skydrop::render
