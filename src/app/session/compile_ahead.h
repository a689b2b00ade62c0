// Has the driver compile the programs of a set of effects before the flight asks for them: on a thread and an
// OpenGL context of its own. What it made there is thrown away; what stays is the code in the driver's cache
// on disk, from which the flight's own context takes it in milliseconds. Where the driver keeps none, nothing
// is gained and nothing is wrong.
#pragma once

#include <atomic>
#include <thread>

#include "app/session/scene_renderer.h"

namespace skydrop::app {

class CompileAhead {
 public:
  // Main thread. Begins with copies of all that it is given. `like`: the flight's context, whose back-end is
  // taken as far as it can be used beside a window. `size`: of the frames that nobody sees.
  CompileAhead(const render::gl::Context& like, SceneRenderer::Setup setup, const Settings& settings,
               const game::Snapshot& snapshot, Size size);
  // Gives it up and waits for its end.
  ~CompileAhead() = default;

  // Ends it after the frame that it is drawing.
  void giveUp() { thread_.request_stop(); }
  // Whether it has come to its end; also where it could not begin. What fails here fails again, and is told,
  // in the flight's own context.
  bool isDone() const { return isDone_; }

 private:
  std::atomic<bool> isDone_{false};
  std::jthread thread_;
};

}  // namespace skydrop::app
