#include "skydrop/render/sky/rainbow_pass.h"

#include <string>
#include <vector>

#include "render/frame/visibility.h"
#include "render/sky/optics_table.h"
#include "skydrop/render/frame/cloud_transmittance.h"

namespace skydrop::render {
namespace {

constexpr GLuint kDepthUnit = 0, kTableUnit = 1;  // as in shaders/sky/rainbow.glsl
constexpr double kReachDegrees = 90;

}  // namespace

RainbowPass::RainbowPass(gl::Context& context, const RainbowSettings& settings)
    : settings_(settings), triangle_(context), table_(opticsTable(context, "rainbow.dds", false)) {}

std::optional<std::string> RainbowPass::skipReason(const FrameInput& frame) const {
  if (frame.warmsUp) return std::nullopt;
  if (settings_.extinction <= 0 || settings_.farM <= settings_.nearM) return "no rain";
  if (isLightBelowHorizon(frame)) return "the light is below the horizon";
  if (isFartherThan(frame.view, -frame.toSun, kReachDegrees)) return "the rainbow is out of view";
  if (frame.view.position.y >= settings_.topM && leastRise(frame.view) >= 0)
    return "the view is above the rain";
  return std::nullopt;
}

void RainbowPass::draw(FrameContext& context) {
  std::vector<std::string> defines(context.defines.begin(), context.defines.end());
  if (const auto* clouds = context.resources.find<CloudTransmittance>()) {
    defines.emplace_back("CLOUD_TRANSMITTANCE");
    clouds->bind();
  }
  gl::Shader& shader = context.shaders.shader("fullscreen.vert", "sky/rainbow.frag", defines);
  shader.setVec4("rain", glm::vec4(settings_.extinction, settings_.nearM, settings_.farM, settings_.topM));
  shader.setFloat("dropRadiusMm", static_cast<float>(settings_.dropRadiusMm));
  context.sceneDepth.bind(kDepthUnit);
  table_.bind(kTableUnit);
  const gl::Functions& gl = context.gl.api();
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
  shader.use();
  triangle_.draw();
}

}  // namespace skydrop::render
