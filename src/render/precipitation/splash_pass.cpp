#include "skydrop/render/precipitation/splash_pass.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "render/precipitation/falling.h"
#include "skydrop/render/frame/light_shares.h"
#include "skydrop/render/precipitation/rain_map.h"

namespace skydrop::render {
namespace {

constexpr GLuint kDepthUnit = 0;    // as in shaders/precipitation
constexpr double kFullRate = 20;    // mm/h from which each cell has a splash at any time
constexpr double kLeastRate = 0.1;  // mm/h

// The low 24 bits of a whole number: exact in a float, and enough for a hash.
int lowBits(double number) {
  return static_cast<int>(static_cast<std::int64_t>(std::fmod(number, 16777216.0)));
}

double rainOnSea(const FrameInput& frame, const RainMap* map) {
  const std::optional<weather::State> state = weatherOf(frame);
  if (!state) return 0;
  const glm::dvec3& eye = frame.view.position;
  const weather::Precipitation fall = weather::fallAt(*state, 0, map ? map->shareAt({eye.x, eye.z}) : 1);
  return fall.rain + fall.sleet + fall.hail;
}

}  // namespace

std::optional<std::string> SplashPass::skipReason(const FrameInput& frame) const {
  if (frame.warmsUp) return std::nullopt;
  if (auto reason = whyDry(weatherOf(frame))) return reason;
  if (settings_.splashes < 1) return "no splashes";
  if (frame.view.position.y >= kRangeM || frame.view.position.y <= 0) return "the sea is too far below";
  if (rainOnSea(frame, nullptr) < kLeastRate) return "no rain reaches the sea";
  return std::nullopt;
}

void SplashPass::draw(FrameContext& context) {
  const View& view = context.frame.view;
  gl::Shader& shader =
      context.shaders.shader("precipitation/splashes.vert", "precipitation/splashes.frag", context.defines);
  const double rate = rainOnSea(context.frame, context.resources.find<RainMap>());
  if (rate < kLeastRate || settings_.splashes < 1) return;
  const int side = std::max(static_cast<int>(std::sqrt(settings_.splashes)), 1);
  const double cell = 2 * kRangeM / side;
  const double firstX = std::floor((view.position.x - kRangeM) / cell),
               firstZ = std::floor((view.position.z - kRangeM) / cell);
  const double spans = context.frame.simulatedSeconds / kLifeS, span = std::floor(spans);
  const auto f = [](double value) { return static_cast<float>(value); };
  shader.setIvec3("firstSplash", {lowBits(firstX), lowBits(firstZ), lowBits(span)});
  shader.setVec4("splashCells",
                 {f(firstX * cell - view.position.x), f(firstZ * cell - view.position.z), f(cell), f(side)});
  shader.setVec4("splashRain", {f(std::min(rate / kFullRate, 1.0)), f(spans - span), f(kRangeM), 0});
  const LightShares shares = lightAt(context.resources, view.position);
  const FrameUniforms& light = context.uniforms;
  const glm::vec4 above = light.skyLight * f(shares.sky) +
                          light.sunLight * (std::max(light.toSun.y, 0.0f) * f(shares.diffuseSun));
  shader.setVec4("splashLight", above / std::numbers::pi_v<float>);
  context.sceneDepth.bind(kDepthUnit);
  const gl::Functions& gl = context.gl.api();
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  shader.use();
  empty_.bind();
  context.gl.drawArrays(GL_TRIANGLES, 0, 6 * side * side);
}

}  // namespace skydrop::render
