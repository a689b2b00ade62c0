#include "app/session/compile_ahead.h"

#include <chrono>
#include <exception>
#include <utility>

#include "skydrop/core/thread_priority.h"

namespace skydrop::app {
namespace {

using render::gl::Backend;

// Land is drawn by its program as soon as there is a chunk of it.
void waitForSomeLand(SceneRenderer& renderer, const game::Snapshot& snapshot, Size size,
                     const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    const SceneRenderer::LandProgress land = renderer.load(snapshot, size);
    if (land.complete || land.ready > 0) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

void compile(Backend backend, const SceneRenderer::Setup& setup, const Settings& settings,
             const game::Snapshot& snapshot, Size size, const std::stop_token& stop) {
  const std::unique_ptr<render::gl::Context> context = render::gl::openHeadless(backend);
  SceneRenderer renderer(*context, setup, settings);
  waitForSomeLand(renderer, snapshot, size, stop);
  renderer.warmUp(snapshot, size, stop);
}

}  // namespace

CompileAhead::CompileAhead(const render::gl::Context& like, SceneRenderer::Setup setup,
                           const Settings& settings, const game::Snapshot& snapshot, Size size) {
  setup.compilesAhead = false;
  setup.workers = 1;
  setup.measuring = false;
  const Backend backend = like.backend() == Backend::osmesa ? Backend::osmesa : Backend::egl;
  thread_ = std::jthread(
      [this, backend, setup = std::move(setup), settings, snapshot, size](const std::stop_token& stop) {
        core::lowerThreadPriority();
        try {
          compile(backend, setup, settings, snapshot, size, stop);
        } catch (const std::exception&) {
          // The flight's own context meets the same and tells of it; without a second context it compiles
          // itself.
        }
        isDone_ = true;
      });
}

}  // namespace skydrop::app
