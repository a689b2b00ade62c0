// A scene that is drawn headless for studies: everything that a picture of it needs, with a context of its
// own. Main thread.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/session/preparations.h"
#include "app/session/run_config.h"
#include "app/session/scene_renderer.h"
#include "skydrop/accuracy/subject.h"
#include "skydrop/core/image.h"
#include "skydrop/render/gl/context.h"

namespace skydrop::app {

class DrawnScene {
 public:
  // Simulates the seconds of the case. Takes the run over. Throws core::DataError, core::GraphicsUnavailable.
  DrawnScene(std::unique_ptr<RunConfig> run, double seconds, Size size,
             const std::vector<EffectDescriptor>& table);
  ~DrawnScene();
  DrawnScene(const DrawnScene&) = delete;
  DrawnScene& operator=(const DrawnScene&) = delete;

  // From now on with these settings, which differ from those before in nothing that makes another scene, and
  // from this camera.
  void set(const Settings& settings, const accuracy::StudyCase& where);

  // With all its land there. Of a flight (StudyCase::flight) the last frame, after those before it where it
  // depends on them. A frame of more samples is drawn so many times, seen through as many places of each
  // pixel (a Fibonacci lattice).
  void draw(int samples = 1);
  core::Image picture();
  // Linear light; of several samples that which is shown as the mean of what they show
  // (shaders/shared/tone_map.glsl).
  std::vector<float> radiance();

  // Of one more frame of one sample (of a flight: the next), ms: all of it by the wall clock, or a pass
  // ("NAME", or several: "NAME+NAME") by the passes' clock. One that is not there, or does nothing, takes 0.
  double timeFrame();
  double timePasses(const std::string& names);
  std::string passClock() const { return passClock_; }
  std::string device() const { return context_->renderer(); }

 private:
  bool usesFramesBefore() const;
  game::Snapshot snapshotOf(int frame) const;
  void drawFrame(int frame, Streaming streaming);
  void drawSamples(int samples);

  std::unique_ptr<RunConfig> run_;
  Size size_;
  std::unique_ptr<render::gl::Context> context_;
  Preparations preparations_;
  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<SceneRenderer> renderer_;
  std::string passClock_ = "none";
  accuracy::StudyCase where_;
  int frame_ = 0;                // of a flight: the last that was drawn
  std::vector<float> radiance_;  // of several samples; empty of one
};

}  // namespace skydrop::app
