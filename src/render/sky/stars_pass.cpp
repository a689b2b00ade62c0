#include "skydrop/render/sky/stars_pass.h"

#include <algorithm>
#include <cstddef>
#include <glm/mat3x3.hpp>
#include <string>
#include <vector>

#include "skydrop/render/frame/sky_clock.h"
#include "skydrop/render/sky/moon_pass.h"
#include "skydrop/sky/almanac.h"
#include "skydrop/sky/night_light.h"

namespace skydrop::render {
namespace {

struct StarVertex {
  glm::vec3 place;  // equator and equinox of J2000
  glm::vec3 light;  // illuminance, lux: kilolux of faint stars would be denormals after some factors
};

constexpr double kLuxPerKilolux = 1e3;

}  // namespace

StarsPass::StarsPass(gl::Context& context, std::span<const sky::Star> stars, const StarsSettings& settings)
    : settings_(settings) {
  std::vector<StarVertex> vertices;
  vertices.reserve(stars.size());
  magnitudes_.reserve(stars.size());
  for (const sky::Star& star : stars) {
    const double lux = sky::illuminanceOfMagnitude(star.magnitude) * kLuxPerKilolux;
    vertices.push_back({glm::vec3(star.direction), glm::vec3(sky::starColor(star.colorIndex) * lux)});
    magnitudes_.push_back(static_cast<float>(star.magnitude));
  }
  vertices_ = gl::Buffer::of(context, std::span<const StarVertex>(vertices), gl::Buffer::Use::fixed, "stars");
  array_ = gl::VertexArray(context, "stars");
  array_.setVertexBuffer(0, vertices_, 0, sizeof(StarVertex));
  array_.setAttribute(0, 0, 3, GL_FLOAT, offsetof(StarVertex, place));
  array_.setAttribute(1, 0, 3, GL_FLOAT, offsetof(StarVertex, light));
}

void StarsPass::apply(const StarsSettings& settings) { settings_ = settings; }

std::optional<std::string> StarsPass::skipReason(const FrameInput& frame) const {
  if (frame.warmsUp) return std::nullopt;
  if (frame.sunSine > 0) return "the sun is up";
  if (settings_.brightness <= 0) return "the brightness is 0";
  return std::nullopt;
}

void StarsPass::draw(FrameContext& context) {
  std::vector<std::string> defines(context.defines.begin(), context.defines.end());
  const auto* moon = context.resources.find<MoonDisc>();
  if (moon) defines.emplace_back("MOON");
  gl::Shader& shader = context.shaders.shader("sky/stars.vert", "sky/stars.frag", defines);
  const SunSettings& sun = context.settings.sun;
  const double days = clockDays(sun, context.frame.simulatedSeconds);
  shader.setMatrix("toWorld", glm::mat3(sky::j2000ToWorld(days, placeOf(sun))));
  shader.setFloat("brightness",
                  static_cast<float>(settings_.brightness * context.light.exposure / kLuxPerKilolux));
  shader.setFloat("twinkle", static_cast<float>(settings_.twinkle));
  if (moon) {
    const double cosine = std::cos(moon->radiusRad);
    shader.setVec4("moon", glm::vec4(glm::vec3(moon->direction), static_cast<float>(cosine)));
  }
  const gl::Functions& gl = context.gl.api();
  gl.DepthMask(GL_FALSE);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
  gl.Enable(GL_PROGRAM_POINT_SIZE);
  array_.bind();
  shader.use();
  const auto end = std::ranges::upper_bound(magnitudes_, static_cast<float>(settings_.faintestMagnitude));
  context.gl.drawArrays(GL_POINTS, 0, static_cast<GLsizei>(end - magnitudes_.begin()));
}

}  // namespace skydrop::render
