// The sky that frames are drawn under while the tables of another one are being made, a slice a frame: a sun
// that jumps stops no frame.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "skydrop/render/frame/frame_input.h"
#include "skydrop/render/frame/render_settings.h"
#include "skydrop/render/frame/sky_light.h"

namespace skydrop::render {

// Main thread. Only the tables of the sky lag behind, for some frames; whatever is not one of them (the
// discs, their light, shadows) is where it belongs at once.
class NextSky {
 public:
  // Rows of tables made in a frame: 2 to 4 ms. A sun that jumps takes 320 of them, with a moon 640.
  static constexpr int kRowsAFrame = 40;

  // Where the tables of a frame with these settings are seen from: in a frame that follows another
  // (FrameInput::followsLast) the newest whose tables are done or need no more than a slice, and a slice of
  // the others is made. In any other, after a leap of the eye, and with the closed form, which has no tables:
  // nothing, which is its own.
  std::optional<SkyPlaces> of(const RenderSettings& settings, const FrameInput& frame, MoonOfFrame* moon);
  // The next frame waits for its own, whatever it follows.
  void settle() { drawn_.reset(); }

 private:
  glm::dvec3 eye_{0};  // of the frame before
  std::optional<SkyPlaces> drawn_;
  std::optional<SkyPlaces> next_;  // that is being made; frames may want another one by now
};

}  // namespace skydrop::render
