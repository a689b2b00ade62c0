#include "skydrop/render/models/lamp_glow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "skydrop/core/shared_lamps.h"
#include "skydrop/render/frame/cloud_transmittance.h"

namespace skydrop::render {
namespace {

namespace shared = core::shared::f64;

constexpr GLuint kDepthUnit = 8;  // as in shaders/models/lamp_glow.glsl
constexpr double kLeastSpreadPixels = 0.7;
constexpr double kSpreadsDrawn = 3.5;

// What air leaves of it.
glm::dvec3 throughAir(const FrameContext& context, const glm::dvec3& radiance, const glm::dvec3& relative) {
  if (!context.frame.features.haze) return radiance;
  const double height = context.frame.view.position.y;
  return glm::max(sky::applyAerialPerspective(context.light, radiance, height, relative) -
                      sky::applyAerialPerspective(context.light, glm::dvec3(0), height, relative),
                  glm::dvec3(0));
}

// On the way to this for the brightest of the three, so that the colour stays.
glm::dvec3 atMost(const glm::dvec3& light, double most) {
  const double brightest = std::max({light.x, light.y, light.z});
  return light / (1 + brightest / most);
}

}  // namespace

void LampGlow::draw(FrameContext& context, std::span<const Glow> glows) const {
  const View& view = context.frame.view;
  const double pixelAngle = view.pixelAngleRad();
  std::array<glm::vec4, kMost> places{}, cores{}, veils{};
  std::size_t count = 0;
  for (const Glow& glow : glows.first(std::min(glows.size(), kMost))) {
    const glm::dvec3 relative = glow.position - view.position;
    const double distance = std::max(glm::length(relative), shared::kLampLensM);
    const double spread = std::max(kLeastSpreadPixels, 0.5 * glow.lensM / distance / pixelAngle);
    const glm::dvec3 atEye =
        throughAir(context, glow.intensity * context.light.exposure / (distance * distance), relative);
    const double solidAngle = 2 * std::numbers::pi * spread * spread * pixelAngle * pixelAngle;
    const glm::dvec3 core = atMost(atEye / solidAngle, kBrightestLens);
    const glm::dvec3 veil = atMost(10.0 * atEye, kMostVeil);  // of the law of glare; degree^2
    const double brightest = std::max({veil.x, veil.y, veil.z});
    const double reach = std::sqrt(brightest / kFaintestVeil);
    places[count] = glm::vec4(glm::vec3(relative), static_cast<float>(std::max(reach, 0.01)));
    cores[count] = glm::vec4(glm::vec3(core), static_cast<float>(spread));
    veils[count] =
        glm::vec4(glm::vec3(veil),
                  static_cast<float>(std::max(kSpreadsDrawn * spread, glm::radians(reach) / pixelAngle)));
    ++count;
  }
  const std::vector<std::string> defines = withCloudTransmittance(context.defines, context.resources);
  gl::Shader& shader = context.shaders.shader("models/lamp_glow.vert", "models/lamp_glow.frag", defines);
  if (count == 0) return;
  shader.setVec4s("glowPlaces", places);
  shader.setVec4s("glowCores", cores);
  shader.setVec4s("glowVeils", veils);
  context.sceneDepth.bind(kDepthUnit);
  const gl::Functions& gl = context.gl.api();
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
  empty_.bind();
  shader.use();
  context.gl.drawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(6 * count));
}

}  // namespace skydrop::render
