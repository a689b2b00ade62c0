#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "skydrop/render/frame/frame_features.h"
#include "skydrop/render/frame/view.h"

namespace skydrop::game {
struct Snapshot;
}

namespace skydrop::render {

class MoonOfFrame;

// What a frame is a pure function of, beside the renderer's settings. Values: nothing in here changes while
// it is drawn. The first three are what any picture needs; a frame without a game shows sky, land, clouds and
// interface.
struct FrameInput {
  View view{};
  FrameFeatures features{};
  double simulatedSeconds = 0;           // finite, any sign: waves and clouds move by it
  const game::Snapshot* game = nullptr;  // null: there is no game; must outlive Renderer::draw()
  // The renderer puts here what follows from its settings: the unit vector to what casts shadows (the sun, at
  // night the moon), and the sine of the sun's elevation.
  glm::dvec3 toSun{0, 1, 0};
  double sunSine = 1;
  // How many times the illuminance by what casts shadows, on what faces it, is that of the night without sun
  // and moon on level ground. And the moon, for all passes that ask for it; null: each works it out.
  double lightOverNight = 1e9;
  MoonOfFrame* moon = nullptr;
  // The frame may use what passes kept of the one that the same renderer drew before it: only then is it a
  // function of more than what is in here. It need not fit: passes find out what of it does.
  bool followsLast = false;
  // Drawn so that what it is drawn with is compiled, and seen by nobody: passes that settings leave nothing
  // to draw (no density, no cloud) draw it all the same, so that turning a setting up compiles nothing.
  bool warmsUp = false;
  // Whether what later frames may need is compiled now: a picture alone has no later frames.
  bool looksAhead() const { return followsLast || warmsUp; }
  // The small picture beside the scene's: what passes keep of the scene's eye is not given up for it.
  bool isInset = false;
  // The eye is that of the scene mirrored at the plane of the sea, and what lies below the plane is not drawn
  // (FrameContext::drawMirrored). What passes have published counts from the eye of the scene.
  bool isMirrored = false;
  // How much higher the eye is than that of the scene, m: not above 0.
  double eyeRiseM() const { return isMirrored ? 2 * view.position.y : 0; }
  // What the eye is adapted to (SkyLight::level, klx), where it is not what follows from the light of this
  // frame: EyeAdaptation.
  std::optional<double> adaptedLevel = std::nullopt;
  // How fast the eye moves, m/s, world axes, finite: what falls is drawn as long as it passes by while the
  // shutter is open.
  glm::dvec3 eyeVelocity{0};
};

// A frame of the game at the moment of the snapshot, which must outlive Renderer::draw().
FrameInput gameFrame(const game::Snapshot& snapshot, const View& view, const FrameFeatures& features);

}  // namespace skydrop::render
