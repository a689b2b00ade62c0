#include "skydrop/render/water/water_mirror_pass.h"

#include "render/water/mirrored_view.h"
#include "skydrop/render/frame/flash_light.h"
#include "skydrop/render/frame/land_surface.h"
#include "skydrop/render/frame/sea_waves.h"

namespace skydrop::render {

bool WaterMirrorPass::isAsked() const {
  return settings_.reflection != WaterReflection::off && settings_.mirror == WaterMirror::plane;
}

void WaterMirrorPass::apply(const WaterDetailSettings& settings) {
  settings_ = settings;
  if (!isAsked()) picture_ = {}, land_ = {};
}

std::optional<std::string> WaterMirrorPass::skipReason(const FrameInput& frame) const {
  if (!isAsked()) return "water mirrors what the picture shows";
  if (frame.warmsUp) return std::nullopt;
  return whyNothingIsMirrored(frame.view);
}

std::optional<View> WaterMirrorPass::alsoShows(const View& view) const {
  if (!isAsked() || whyNothingIsMirrored(view)) return std::nullopt;
  return mirroredView(view, settings_.mirrorMargin, spacingOf(settings_));
}

void WaterMirrorPass::draw(FrameContext& context) {
  mirrored_.view = mirroredView(context.frame.view, settings_.mirrorMargin, spacingOf(settings_));
  const View& view = mirrored_.view;
  if (!picture_) {
    picture_ = gl::FrameBuffer(context.gl, view.width, view.height, {GL_RGBA16F, GL_DEPTH_COMPONENT32F},
                               "mirrored scene");
    land_ = makeLandSurface(context.gl, view.width, view.height);
  }
  picture_.resize(view.width, view.height);
  land_.resize(view.width, view.height);
  picture_.clear();
  FrameResources seen;
  seen.publishAll(context.resources);
  seen.withdraw<SeaWaves>();  // the ground below the water is not mirrored
  FlashLight flash;
  if (const auto* above = seen.find<FlashLight>()) {
    flash = *above;
    const auto rise = static_cast<float>(view.position.y - context.frame.view.position.y);
    for (glm::vec4& place : flash.places) place.y -= rise;
    seen.replace(flash);
  }
  const LandSurface land{&land_};
  seen.publish(land);
  context.drawMirrored(view, picture_, seen);
  mirrored_.light = &picture_.colorTexture();
  mirrored_.depth = &picture_.depthTexture();
  context.resources.publish(mirrored_);
}

}  // namespace skydrop::render
