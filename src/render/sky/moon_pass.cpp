#include "skydrop/render/sky/moon_pass.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render/frame/moon_view.h"
#include "render/frame/visibility.h"
#include "skydrop/core/shared.h"
#include "skydrop/sky/night_light.h"

namespace skydrop::render {
namespace {

// Of the disc's light where the sun does not shine on it, by the light of a full earth (10 to 15 lx; Danjon
// 1936); the earth is full where the moon is new.
constexpr double kEarthShine = 1e-4;

}  // namespace

MoonPass::MoonPass(gl::Context& context, const SunSettings& clock) : clock_(clock), array_(context, "moon") {}

std::optional<std::string> MoonPass::skipReason(const FrameInput& frame) const {
  if (frame.warmsUp) return std::nullopt;
  if (clock_.source != SunSource::clock) return "the sun is set by hand (sky.sun)";
  const MoonView moon = moonOf(frame.moon, clock_, frame.simulatedSeconds);
  if (moon.direction.y <
      core::shared::f64::horizonSine(std::max(frame.view.position.y, 0.0)) - std::sin(moon.radiusRad))
    return "the moon is below the horizon";
  constexpr double kFarM = 1e6;
  const double radius = kFarM * std::tan(2 * moon.radiusRad);
  if (!isPotentiallyVisible(frame.view, frame.view.position + kFarM * moon.direction, radius))
    return "the moon is out of view";
  return std::nullopt;
}

void MoonPass::draw(FrameContext& context) {
  const MoonView moon = moonOf(context.frame.moon, clock_, context.frame.simulatedSeconds);
  disc_ = {moon.direction, moon.radiusRad};
  context.resources.publish(disc_);
  gl::Shader& shader = context.shaders.shader("sky/moon.vert", "sky/moon.frag", context.defines);
  const double radiance = sky::moonRadiance(moon.phaseAngleDegrees, moon.distanceKm) * context.light.exposure;
  const double shown = std::min(radiance, kBrightestShown);
  const double earth = 0.5 * (1 - std::cos(glm::radians(moon.phaseAngleDegrees)));
  shader.setVec4("moonPlace", glm::vec4(glm::vec3(moon.direction), static_cast<float>(moon.radiusRad)));
  shader.setVec3("moonNorth", glm::vec3(moon.north));
  shader.setVec3("moonToSun", glm::vec3(moon.toSun));
  shader.setVec2("moonLight", glm::vec2(shown, kEarthShine * earth * radiance));
  const gl::Functions& gl = context.gl.api();
  gl.DepthMask(GL_FALSE);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
  array_.bind();
  shader.use();
  context.gl.drawArrays(GL_TRIANGLES, 0, 6);
}

}  // namespace skydrop::render
