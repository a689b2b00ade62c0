#include "skydrop/render/sky/halo_pass.h"

#include <algorithm>

#include "render/sky/optics_table.h"

namespace skydrop::render {
namespace {

constexpr GLuint kHaloUnit = 0, kSunDogUnit = 1;  // as in shaders/sky/halo.glsl
constexpr double kReachDegrees = 64;

}  // namespace

HaloPass::HaloPass(gl::Context& context, const HaloSettings& settings)
    : settings_(settings),
      triangle_(context),
      halo_(opticsTable(context, "halo.dds", false)),
      sunDogs_(opticsTable(context, "sun_dogs.dds", true)),
      tables_{&halo_, &sunDogs_, settings.plates} {}

std::optional<std::string> HaloPass::skipReason(const FrameInput& frame) const {
  if (frame.warmsUp) return std::nullopt;
  if (isLeft_) return "clouds of ice make the halo";
  if (settings_.opticalDepth <= 0) return "no ice";
  if (frame.view.position.y >= settings_.heightM) return "the view is above the ice";
  if (isLightBelowHorizon(frame)) return "the light is below the horizon";
  if (isFartherThan(frame.view, frame.toSun, kReachDegrees)) return "the halo is out of view";
  return std::nullopt;
}

void HaloPass::draw(FrameContext& context) {
  gl::Shader& shader = context.shaders.shader("fullscreen.vert", "sky/halo.frag", context.defines);
  shader.setFloat("iceDepth", static_cast<float>(settings_.opticalDepth));
  shader.setFloat("plates", static_cast<float>(settings_.plates));
  shader.setFloat("iceAboveM",
                  static_cast<float>(std::max(settings_.heightM - context.frame.view.position.y, 1.0)));
  halo_.bind(kHaloUnit);
  sunDogs_.bind(kSunDogUnit);
  const gl::Functions& gl = context.gl.api();
  gl.DepthMask(GL_FALSE);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
  shader.use();
  triangle_.draw();
}

}  // namespace skydrop::render
