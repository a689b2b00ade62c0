#include "skydrop/render/fog/ground_fog_pass.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "render/frame/visibility.h"
#include "skydrop/render/frame/cloud_transmittance.h"

namespace skydrop::render {
namespace {

constexpr GLuint kDepthUnit = 0;  // as in shaders/fog

// Changes light by a fiftieth of a half float's step where fog is as bright as what is behind it.
constexpr double kInvisibleDepth = 1e-5;

}  // namespace

std::optional<std::string> GroundFogPass::skipReason(const FrameInput& frame) const {
  if (frame.warmsUp) return std::nullopt;
  if (settings_.density <= 0) return "no density";
  const double above = std::max(frame.view.position.y - settings_.baseM, 0.0) / settings_.scaleHeightM;
  const double overhead = settings_.density * settings_.scaleHeightM * std::exp(-above);
  if (overhead < kInvisibleDepth * leastRise(frame.view)) return "the view lies above the fog";
  return std::nullopt;
}

void GroundFogPass::draw(FrameContext& context) {
  const std::vector<std::string> defines = withCloudTransmittance(context.defines, context.resources);
  gl::Shader& shader = context.shaders.shader("fullscreen.vert", "fog/ground_fog.frag", defines);
  shader.setFloat("eyeAboveBaseM", static_cast<float>(context.frame.view.position.y - settings_.baseM));
  shader.setFloat("extinction", static_cast<float>(settings_.density));
  shader.setFloat("scaleHeightM", static_cast<float>(settings_.scaleHeightM));
  context.sceneDepth.bind(kDepthUnit);
  const gl::Functions& gl = context.gl.api();
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  shader.use();
  triangle_.draw();
}

}  // namespace skydrop::render
