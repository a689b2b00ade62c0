#include "skydrop/render/water/water_detail_pass.h"

#include <glm/common.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <string>
#include <vector>

#include "render/water/mirrored_view.h"
#include "render/water/wave_set.h"
#include "skydrop/game/snapshot.h"
#include "skydrop/render/frame/land_ground.h"
#include "skydrop/render/water/water_mirror_pass.h"
#include "skydrop/weather/wind_profile.h"

namespace skydrop::render {
namespace {

constexpr GLuint kDepthUnit = 5, kColorUnit = 6, kKeptUnit = 7, kPictureDepthUnit = 7;  // as in shaders/water
constexpr const char* kOwnPictureDefine = "MIRRORED_SCENE";
constexpr double kWindHeightM = 10;
constexpr double kMirrorFadesM = 100;  // from this height of the eye on, up to none at kMirrorEndsM

GLuint groups(int texels) { return static_cast<GLuint>(texels + 7) / 8; }

// Over the sea at the eye.
glm::dvec2 windOverSea(const FrameInput& frame, const core::WindSettings& wind) {
  const glm::dvec2 eye(frame.view.position.x, frame.view.position.z);
  if (frame.game && frame.game->weather) {
    const weather::State state = frame.game->weather.at(eye);
    const glm::dvec3 air = weather::WindProfile(state.wind).at(kWindHeightM, kWindHeightM);
    return {air.x, air.z};
  }
  return weather::windVelocity(wind.speed, wind.direction);
}

}  // namespace

void SeaWavesPass::draw(FrameContext& context) {
  const FrameInput& frame = context.frame;
  waves_ = seaWaves(settings_, {frame.view.position.x, frame.view.position.z}, frame.simulatedSeconds,
                    windOverSea(frame, wind_));
  const View& view = frame.view;
  if (settings_.reflection == WaterReflection::off) {
    mirror_ = {};
  } else if (!mirror_ || mirror_.width() != view.width || mirror_.height() != view.height) {
    mirror_ = {};
    mirror_ = gl::Texture::make2D(context.gl, GL_RGBA16F, view.width, view.height, "what the sea mirrors");
  }
  waves_.mirror = mirror_ ? &mirror_ : nullptr;
  context.resources.publish(waves_);
}

std::optional<std::string> WaterReflectionPass::skipReason(const FrameInput& frame) const {
  if (settings_.reflection == WaterReflection::off) return "water mirrors the sky alone";
  if (frame.warmsUp) return std::nullopt;
  return whyNothingIsMirrored(frame.view);
}

std::optional<std::string> WaterReflectionPass::skipReasonAfter(const FrameInput&,
                                                                const FrameResources& resources) const {
  if (!resources.find<LandGround>() || !resources.find<SeaWaves>()) return "no sea has been drawn";
  if (settings_.mirror == WaterMirror::plane && !resources.find<MirroredScene>())
    return "no mirrored scene has been drawn";
  return std::nullopt;
}

void WaterReflectionPass::resize(FrameContext& context) {
  const View& view = context.frame.view;
  const int spacing = spacingOf(settings_);
  const int width = (view.width + spacing - 1) / spacing, height = (view.height + spacing - 1) / spacing;
  if (mirrored_ && mirrored_.width() == width && mirrored_.height() == height) return;
  mirrored_ = {};
  mirrored_ = gl::Texture::make2D(context.gl, GL_RGBA16F, width, height, "mirrored scene");
  mirrored_.setFilter(GL_LINEAR, GL_LINEAR);
  mirrored_.setWrap(GL_CLAMP_TO_EDGE);
}

void WaterReflectionPass::draw(FrameContext& context) {
  resize(context);
  const gl::Functions& api = context.gl.api();
  const View& view = context.frame.view;
  const LandGround& land = context.resources.get<LandGround>();
  const SeaWaves& waves = context.resources.get<SeaWaves>();
  std::vector<std::string> defines(context.defines.begin(), context.defines.end());
  defines.emplace_back(SeaWaves::kDefine);
  const auto* picture =
      settings_.mirror == WaterMirror::plane ? context.resources.find<MirroredScene>() : nullptr;
  if (picture) defines.emplace_back(kOwnPictureDefine);
  gl::ComputeShader& mirror = context.shaders.computeShader("water/mirror.comp", defines);
  land.setSurface(mirror, view);
  waves.set(mirror);
  mirror.setInt("spacing", spacingOf(settings_));
  mirror.setInt("mirrorSteps", static_cast<int>(settings_.reflectionSteps));
  mirror.setInt("mirrorRays", static_cast<int>(settings_.reflectionRays));
  mirror.setFloat("mirrorM", static_cast<float>(settings_.reflectionM));
  const double high = (view.position.y - kMirrorFadesM) / (kMirrorEndsM - kMirrorFadesM);
  mirror.setFloat("mirrorLeft", static_cast<float>(1 - glm::smoothstep(0.0, 1.0, high)));
  context.sceneDepth.bind(kDepthUnit);
  if (picture) {
    picture->light->bind(kColorUnit);
    picture->depth->bind(kPictureDepthUnit);
    mirror.setMatrix("toPicture", glm::translate(viewProjection(picture->view),
                                                 relativeToEye(picture->view, view.position)));
    mirror.setVec2("pictureSize", glm::vec2(picture->view.width, picture->view.height));
  } else {
    context.sceneColor.bind(kColorUnit);
  }
  mirrored_.bindImage(0, GL_WRITE_ONLY);
  mirror.dispatch(groups(mirrored_.width()), groups(mirrored_.height()));
  api.MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);  // of the sea's own too, which it keeps in its pass

  gl::ComputeShader& compose = context.shaders.computeShader("water/compose.comp", context.defines);
  land.setSurface(compose, view);
  compose.setInt("spacing", spacingOf(settings_));
  context.sceneDepth.bind(kDepthUnit);
  mirrored_.bind(kColorUnit);
  waves.mirror->bind(kKeptUnit);
  context.sceneColor.bindImage(0, GL_READ_WRITE);
  compose.dispatch(groups(view.width), groups(view.height));
  api.MemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

}  // namespace skydrop::render
