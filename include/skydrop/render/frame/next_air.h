// The air that frames are drawn in while the tables of another one are being made (sky::SkyViews: 70 ms): a
// slider that is dragged stops no frame.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "skydrop/core/latest_job.h"
#include "skydrop/render/frame/frame_input.h"
#include "skydrop/render/frame/render_settings.h"
#include "skydrop/sky/sky_views.h"

namespace skydrop::render {

// Main thread. A thread of its own, which the first change of the air in frames that follow each other
// starts, makes tables and the first sky; it is waited for in the destructor.
class NextAir {
 public:
  NextAir();

  // The air of a frame with these settings: in a frame that follows another (FrameInput::followsLast) the
  // newest whose tables are done, which are asked for; in any other theirs. With the closed form, which has
  // no tables, theirs.
  const AtmosphereSettings& of(const RenderSettings& settings, const FrameInput& frame);
  // The next frame waits for its own, whatever it follows.
  void settle() { drawn_.reset(); }

 private:
  struct Key {
    AtmosphereSettings air;
    double eyeM;
    std::array<double, 2> sines;  // of the elevations of sun and moon
    int number;                   // of the request
  };
  struct Made {
    AtmosphereSettings air;
    int number;
    std::shared_ptr<sky::SkyViews> views;  // so that they are kept
  };
  static Made make(const Key& key);
  void take();

  std::optional<AtmosphereSettings> drawn_, wanted_;
  int requests_ = 0, outdated_ = 0;  // how many there were; those up to this one are not wanted any more
  std::shared_ptr<sky::SkyViews> views_;
  core::LatestJob<Key, Made> job_;
};

}  // namespace skydrop::render
