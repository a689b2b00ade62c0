// The game as the program runs it, without a window: land, passes and HUD of a scene, drawn headless from a
// camera that the benchmark moves. A frame ends when the renderer has finished it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/session/run_config.h"
#include "app/session/scene_renderer.h"
#include "app/window/overlay.h"
#include "skydrop/render/gl/context.h"

namespace skydrop::bench {

inline constexpr app::Size kFrameSize{640, 360};

class BenchGame {
 public:
  struct Setup {
    bool measuring = false;  // times of the passes are asked for, which slows a software renderer down
    std::string scene = "terrain";
    std::vector<std::string> set = {};                    // --set
    std::optional<scene::Effect> without = std::nullopt;  // of the scene's effects
  };
  explicit BenchGame(const Setup& setup);

  const terrain::HeightSource& ground() const { return *simulation_.ground(); }
  app::SceneRenderer& sceneRenderer() { return sceneRenderer_; }
  const terrain::EndlessTerrain& land() const { return *sceneRenderer_.land(); }
  std::string renderer() const { return context_->renderer(); }

  // As with --set while flying, from the next frame on.
  void set(const std::string& assignment);

  // What is thrown up in the frames from now on (seconds of simulated time: World::now()).
  void show(const std::vector<game::SurfaceBurst>& bursts) { bursts_ = bursts; }
  double seconds() const { return simulation_.world().now().simulatedSeconds; }

  // One frame from there, in ms. Metres; degrees as in app::Pose.
  double draw(const app::Pose& pose);

  // Median of a pass over so many of the newest frames, ms; 0 where it is not measured.
  double medianMs(std::string_view pass, std::size_t frames);

  // Begins to switch to these effects. From then on continueSwitch() is called before each draw() until
  // isSwitching() is false; the time that it takes belongs to the frame.
  void switchTo(const scene::EffectSet& effects);
  bool isSwitching() const { return sceneRenderer_.isSwitching(); }
  double continueSwitch(double budgetMs);  // ms
  const scene::EffectSet& effects() const { return simulation_.effects(); }

  // Draws until all land that the pose shows is there.
  void settle(const app::Pose& pose);

 private:
  std::unique_ptr<app::RunConfig> run_;
  std::unique_ptr<render::gl::Context> context_;
  app::Simulation simulation_;
  app::PreparedResources prepared_;
  app::SceneRenderer sceneRenderer_;
  app::Overlay overlay_;
  std::vector<game::SurfaceBurst> bursts_;
};

}  // namespace skydrop::bench
