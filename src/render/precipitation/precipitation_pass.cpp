#include "skydrop/render/precipitation/precipitation_pass.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "render/precipitation/falling.h"
#include "skydrop/game/snapshot.h"
#include "skydrop/render/frame/light_shares.h"
#include "skydrop/render/frame/spot_light.h"
#include "skydrop/render/models/aircraft_lamps.h"
#include "skydrop/render/precipitation/drop_sets.h"
#include "skydrop/render/precipitation/rain_map.h"
#include "skydrop/weather/wind_profile.h"

namespace skydrop::render {
namespace {

constexpr GLuint kDepthUnit = 0, kBlockBinding = 3;  // as in shaders/precipitation
constexpr double kCabinMarginM = 0.05;
// A drop shows the sky from above it, which an overcast has three times as bright as at the horizon (CIE
// S 011, 2003: 9 / (7 pi) of the illuminance in the zenith), and a little of the ground.
constexpr double kSkyOfDrop = 1.15, kCloudsOfDrop = 0.8, kGroundOfDrop = 0.3;
constexpr double kLeastRate = 1e-3;  // mm/h; less is seen by nobody

struct DropBlock {
  glm::vec4 ambient, sun;
  std::array<DropSet, kMostSets> sets;
};

// Two triangles for each drop: corners 4n to 4n + 3.
std::vector<std::uint16_t> quadIndices() {
  std::vector<std::uint16_t> indices;
  indices.reserve(static_cast<std::size_t>(kMostDropsASet) * 6);
  for (int drop = 0; drop < kMostDropsASet; ++drop) {
    for (const int corner : {0, 1, 2, 2, 1, 3})
      indices.push_back(static_cast<std::uint16_t>(4 * drop + corner));
  }
  return indices;
}

weather::Precipitation fallOf(const FrameInput& frame, const weather::State& state, const RainMap* map) {
  const glm::dvec3& eye = frame.view.position;
  const double share = map && !frame.warmsUp ? map->shareAt({eye.x, eye.z}) : 1;
  return weather::fallAt(state, eye.y, share);
}

// The cabin near the eye as a cube; nullopt: there is none.
std::optional<glm::mat4> cabinOf(const FrameInput& frame, double rangeM) {
  if (!frame.game || !frame.game->aircraft.present) return std::nullopt;
  const game::AircraftSnapshot& aircraft = frame.game->aircraft;
  const glm::dvec3 aside = aircraft.position - frame.view.position;
  const glm::dvec3 low = kCabinLow - kCabinMarginM, high = kCabinHigh + kCabinMarginM;
  if (!(glm::length(aside) < rangeM + glm::length(high - low))) return std::nullopt;
  const glm::dmat4 toBody =
      glm::translate(glm::dmat4(glm::mat4_cast(glm::conjugate(aircraft.orientation))), -aside);
  const glm::dmat4 toCube = glm::scale(glm::dmat4(1), 2.0 / (high - low));
  return glm::mat4(toCube * glm::translate(glm::dmat4(1), -0.5 * (low + high)) * toBody);
}

}  // namespace

PrecipitationPass::PrecipitationPass(gl::Context& context, const PrecipitationSettings& settings)
    : settings_(settings),
      uniforms_(context, sizeof(DropBlock), gl::Buffer::Use::write, "drops"),
      indices_(gl::Buffer::of<std::uint16_t>(context, quadIndices(), gl::Buffer::Use::fixed, "drop indices")),
      quads_(context, "drops") {
  quads_.setIndexBuffer(indices_);
}

std::optional<std::string> PrecipitationPass::skipReason(const FrameInput& frame) const {
  if (frame.warmsUp) return std::nullopt;
  const std::optional<weather::State> state = weatherOf(frame);
  if (auto reason = whyDry(state)) return reason;
  if (settings_.drops < 1) return "no drops";
  const double height = frame.view.position.y;
  if (height >= weather::fallField(*state)->topM) return "above the cloud that feeds it";
  if (weather::rateOf(weather::fallAt(*state, height)) < kLeastRate) return "it evaporates above";
  return std::nullopt;
}

std::optional<std::string> PrecipitationPass::skipReasonAfter(const FrameInput& frame,
                                                              const FrameResources& resources) const {
  const auto* map = resources.find<RainMap>();
  if (frame.warmsUp || !map) return std::nullopt;
  if (weather::rateOf(fallOf(frame, *weatherOf(frame), map)) < kLeastRate)
    return "no rain from the clouds overhead";
  return std::nullopt;
}

void PrecipitationPass::draw(FrameContext& context) {
  const FrameInput& frame = context.frame;
  const View& view = frame.view;
  const auto* spot = context.resources.find<SpotLight>();
  const std::optional<glm::mat4> cabin = cabinOf(frame, settings_.rangeM);
  const auto variant = [&](bool hasCabin, bool hasSpot) -> gl::Shader& {
    std::vector<std::string> defines(context.defines.begin(), context.defines.end());
    if (hasCabin) defines.emplace_back("CABIN");
    if (hasSpot) defines.emplace_back(SpotLight::kDefine);
    return context.shaders.shader("precipitation/drops.vert", "precipitation/drops.frag", defines);
  };
  const std::optional<weather::State> state = weatherOf(frame);
  if (!state) return;
  const std::vector<FallClass> classes =
      fallClasses(fallOf(frame, *state, context.resources.find<RainMap>()));
  const glm::dvec3 air =
      weather::WindProfile(state->wind).at(view.position.y, std::max(view.position.y, 0.0));
  const DropSets sets = dropSets(settings_, classes, view, frame.eyeVelocity, air, frame.simulatedSeconds);
  if (sets.mostDrops == 0) return;

  const LightShares shares = lightAt(context.resources, view.position);
  const FrameUniforms& light = context.uniforms;
  DropBlock block{};
  const auto inAll = static_cast<float>(shares.sky / std::numbers::pi);
  block.ambient = (light.skyLight * static_cast<float>(kSkyOfDrop) +
                   light.groundLight * static_cast<float>(kGroundOfDrop)) *
                  inAll;
  // Below clouds the light of the sky is white: they scatter all colours alike.
  const float grey = glm::dot(glm::vec3(block.ambient), glm::vec3(0.2126f, 0.7152f, 0.0722f));
  block.ambient = glm::mix(glm::vec4(grey), block.ambient, static_cast<float>(shares.sky));
  block.ambient.w = static_cast<float>(settings_.rangeM);
  // What they have scattered of the sun's comes from above, about as evenly.
  const double fromClouds = std::max(static_cast<double>(light.toSun.y), 0.0) * shares.diffuseSun;
  block.ambient += light.sunLight * static_cast<float>(kCloudsOfDrop * fromClouds / std::numbers::pi);
  block.sun = light.sunLight * static_cast<float>(shares.sun);
  block.sun.w = static_cast<float>(settings_.shutterS);
  block.sets = sets.sets;
  uniforms_.writeValue(0, block);
  uniforms_.bindBase(GL_UNIFORM_BUFFER, kBlockBinding);

  context.sceneDepth.bind(kDepthUnit);
  const gl::Functions& gl = context.gl.api();
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  quads_.bind();
  // All are asked for, and drawn by those who warm up: none is compiled when the camera leaves the aircraft,
  // or the lamp goes on.
  for (const bool hasCabin : {false, true}) {
    for (const bool hasSpot : {false, true}) {
      if (hasSpot && !spot && !frame.features.spotLight) continue;
      const bool isThis = hasCabin == cabin.has_value() && hasSpot == (spot != nullptr);
      if (!isThis && !frame.looksAhead()) continue;
      gl::Shader& shader = variant(hasCabin, hasSpot);
      if (!isThis && !frame.warmsUp) continue;
      if (cabin) shader.setMatrix("toCabin", *cabin);
      if (spot) spot->set(shader, view);
      shader.use();
      context.gl.drawElementsInstanced(GL_TRIANGLES, 6 * sets.mostDrops, GL_UNSIGNED_SHORT, 0, sets.count);
    }
  }
}

}  // namespace skydrop::render
