// A scene as it is flown, headless and without hands, for what asks what it costs: each frame is two steps,
// sound, interface and picture. Main thread.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/session/preparations.h"
#include "app/session/run_config.h"
#include "app/session/scene_renderer.h"
#include "app/window/overlay.h"
#include "skydrop/audio/audio_manager.h"
#include "skydrop/audio/sound_scene.h"
#include "skydrop/core/frame_statistics.h"
#include "skydrop/render/gl/context.h"

namespace skydrop::app {

// What is drawn, and from where: the same for games that are to be compared.
struct Sight {
  game::Snapshot snapshot;
  render::View view;
};

class MeasuredGame {
 public:
  struct Setup {
    std::string scene;
    Size size;
    std::vector<std::string> set = {};  // as --set
  };
  // With a context, land and sound (loopback where OpenAL has it) of its own; the noise of clouds comes from
  // the cache. Throws core::DataError, core::UsageError, core::GraphicsUnavailable.
  explicit MeasuredGame(const Setup& setup);
  ~MeasuredGame();

  const scene::EffectSet& effects() const { return simulation_->effects(); }
  std::string renderer() const { return context_->renderer(); }

  // At first what the scene's own camera sees at its start.
  const Sight& sight() const { return sight_; }
  // Draws this from now on; the first frame waits for its land.
  void show(const Sight& sight);

  // Times of the passes and CPU times of all else, from the next frame on: on a software renderer frames are
  // slower then.
  void setMeasuring(bool measuring);

  // One frame of 1/60 s, finished by the renderer: ms by the wall clock. The world goes on, the picture is
  // that of the sight.
  double frame();

  // What the last frame cost (CPU times: the mean of all measured frames).
  core::FrameStatistics statistics();

 private:
  void buildInterface();

  Size size_;
  std::unique_ptr<RunConfig> run_;
  std::unique_ptr<render::gl::Context> context_;
  Preparations preparations_;
  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<SceneRenderer> sceneRenderer_;
  std::unique_ptr<Overlay> overlay_;  // with hud only
  std::unique_ptr<audio::AudioManager> audio_;
  std::unique_ptr<audio::SoundScene> sound_;
  core::CpuMeter soundCost_;
  Sight sight_;
};

}  // namespace skydrop::app
