#include "skydrop/render/precipitation/rain_veil_pass.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "render/frame/visibility.h"
#include "render/precipitation/falling.h"
#include "skydrop/render/clouds/cloud_shadow_map.h"
#include "skydrop/render/frame/cloud_transmittance.h"
#include "skydrop/render/precipitation/rain_map.h"
#include "skydrop/weather/wind_profile.h"

namespace skydrop::render {
namespace {

constexpr GLuint kDepthUnit = 0;      // as in shaders/precipitation
constexpr double kShaftSpeed = 7;     // m/s, of the drops that are most of a shaft
constexpr double kMostLean = 1.5;     // metres aside a metre of fall
constexpr double kSeenInCloud = 0.1;  // share of the cloud from its base on
constexpr double kLeanOfCloud = 0.5;  // share of the wind by which a shaft leans: it starts with the cloud's

}  // namespace

RainVeilPass::RainVeilPass(gl::Context& context, const PrecipitationSettings& settings)
    : context_(context), settings_(settings), grid_(context, "rain veil") {
  makeGrid();
}

void RainVeilPass::apply(const PrecipitationSettings& settings) {
  const bool isSame = settings.veilColumns == settings_.veilColumns;
  settings_ = settings;
  if (!isSame) makeGrid();
}

void RainVeilPass::makeGrid() {
  columns_ = static_cast<int>(settings_.veilColumns);
  rows_ = std::max(columns_ * 9 / 16, 4);
  std::vector<std::uint16_t> indices;
  for (int y = 0; y < rows_; ++y) {
    for (int x = 0; x < columns_; ++x) {
      const int corner = y * (columns_ + 1) + x, above = corner + columns_ + 1;
      for (const int i : {corner, corner + 1, above, above, corner + 1, above + 1})
        indices.push_back(static_cast<std::uint16_t>(i));
    }
  }
  indices_ = gl::Buffer::of<std::uint16_t>(context_, indices, gl::Buffer::Use::fixed, "rain veil indices");
  grid_.setIndexBuffer(indices_);
}

std::optional<std::string> RainVeilPass::skipReason(const FrameInput& frame) const {
  if (frame.warmsUp) return std::nullopt;
  const std::optional<weather::State> state = weatherOf(frame);
  if (auto reason = whyDry(state)) return reason;
  if (frame.view.position.y >= weather::fallField(*state)->topM && leastRise(frame.view) >= 0)
    return "the view lies above the cloud that feeds it";
  return std::nullopt;
}

// What a program of the veil is compiled with.
struct RainVeilPass::Variant {
  bool clouds = false;  // may lie before it
  bool sun = false;     // with the shade that they cast in it
  bool map = false;     // it has gaps
  bool operator==(const Variant&) const = default;
};

gl::Shader& RainVeilPass::shaderOf(FrameContext& context, const Variant& variant) const {
  std::vector<std::string> defines(context.defines.begin(), context.defines.end());
  if (variant.clouds) defines.emplace_back("CLOUD_TRANSMITTANCE");
  if (variant.map) defines.emplace_back(RainMap::kDefine);
  if (const auto* shadowMap = context.resources.find<CloudShadowMap>()) {
    defines.emplace_back("CLOUD_SHADE");
    for (const std::string& define : shadowMap->defines(variant.sun)) defines.push_back(define);
  }
  return context.shaders.shader("precipitation/veil.vert", "precipitation/veil.frag", defines);
}

void RainVeilPass::draw(FrameContext& context) {
  const View& view = context.frame.view;
  const std::optional<weather::State> state = weatherOf(context.frame);
  const std::optional<weather::FallField> field = state ? weather::fallField(*state) : std::nullopt;
  if (!field) return;
  const auto* clouds = context.resources.find<CloudTransmittance>();
  const auto* shadowMap = context.resources.find<CloudShadowMap>();
  const auto* map = context.resources.find<RainMap>();
  // From below the base the clouds lie behind what falls out of them.
  const Variant wanted{clouds && view.position.y >= field->baseM, shadowMap && shadowMap->hasSun(),
                       map != nullptr};
  const auto f = [](double value) { return static_cast<float>(value); };
  const glm::dvec3 wind =
      weather::WindProfile(state->wind).at(0.5 * field->baseM, std::max(0.5 * field->baseM, 0.0));
  const glm::dvec2 lean = glm::dvec2(wind.x, wind.z) * (kLeanOfCloud / kShaftSpeed);
  const double most = kMostLean / std::max(glm::length(lean), kMostLean);
  // Within the cloud it is the cloud that is seen, and gaps between its towers must not be veiled.
  const double seenTop = field->baseM + kSeenInCloud * (field->topM - field->baseM);
  const auto drawWith = [&](gl::Shader& shader) {
    shader.setVec4("fallLayer", {f(field->baseM), f(seenTop), f(field->groundRate), f(field->evaporation)});
    shader.setVec4("fallKind",
                   {f(field->freezingM), f(field->snowShare), f(lean.x * most), f(lean.y * most)});
    shader.setIvec2("gridSize", {columns_, rows_});
    shader.setVec2("veilSpan", {f(settings_.veilRangeM), f(std::round(settings_.veilSteps))});
    if (map) map->bind(shader, view.position);
    if (shadowMap) shadowMap->bind(shader);
    shader.use();
    context.gl.drawElements(GL_TRIANGLES, 6 * columns_ * rows_, GL_UNSIGNED_SHORT);
  };
  if (clouds) clouds->bind();
  context.sceneDepth.bind(kDepthUnit);
  const gl::Functions& gl = context.gl.api();
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  grid_.bind();
  // All are asked for, and drawn by those who warm up: none is compiled when the sun sinks, a front passes,
  // or the eye enters the clouds.
  for (const bool ofClouds : {false, true}) {
    for (const bool ofSun : {false, true}) {
      for (const bool ofMap : {false, true}) {
        const Variant variant{ofClouds, ofSun, ofMap};
        if ((ofClouds && !clouds) || (ofSun && !shadowMap)) continue;
        if (variant != wanted && !context.frame.looksAhead()) continue;
        gl::Shader& shader = shaderOf(context, variant);
        const bool isTried = context.frame.warmsUp && ofSun <= wanted.sun && ofMap <= wanted.map;
        if (variant == wanted || isTried) drawWith(shader);
      }
    }
  }
}

}  // namespace skydrop::render
