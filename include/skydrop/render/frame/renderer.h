// Draws frames: owns the passes, the targets, the programs and the timer. Main thread, on the context's
// thread.
#pragma once

#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "skydrop/core/frame_statistics.h"
#include "skydrop/core/image.h"
#include "skydrop/render/frame/pass.h"
#include "skydrop/render/frame/stage_layer.h"
#include "skydrop/render/gl/buffer.h"
#include "skydrop/render/gl/pass_timer.h"

namespace skydrop::render {

class Renderer {
 public:
  // measuring: times are asked for, so a software renderer may be slowed down for them. The context must
  // outlive the renderer.
  Renderer(gl::Context& context, const RenderSettings& settings, bool measuring);
  ~Renderer();

  gl::Context& context() { return context_; }
  gl::ShaderCache& shaders() { return shaders_; }

  // Passes run by stage, and in the order of adding within one.
  void add(std::unique_ptr<Pass> pass);
  // The first pass of this class in the order of the frame; null without one. The renderer owns it.
  template <class T>
  T* find() const {
    for (const std::unique_ptr<Pass>& pass : passes_) {
      if (T* found = dynamic_cast<T*>(pass.get())) return found;
    }
    return nullptr;
  }
  // Of the passes of its stage, from the next frame on, in place of any that was set before. Without one they
  // are drawn into the scene itself.
  void setLayer(std::unique_ptr<StageLayer> layer);

  void apply(const RenderSettings& settings) { settings_ = settings; }
  const RenderSettings& settings() const { return settings_; }

  // Draws one frame of the view's size into the output target. Throws core::RangeError for a view that is not
  // valid (requireValid; nothing is drawn then) and core::DataError for a shader that does not compile:
  // thrown when the rest of the frame has been drawn without that pass, which the statistics give as skipped.
  void draw(const FrameInput& input);

  // Linear light of the last frame.
  const gl::Texture& sceneColor() const { return scene_.colorTexture(); }
  // The output of the last frame; waits for the GPU. Black before the first.
  core::Image readBack();
  // Copies the output to the window's own frame buffer of this size. The caller swaps.
  void present(int width, int height);

  // Recompiles changed shaders; broken ones stay as they were, one line each.
  gl::ShaderCache::Reloaded reloadShaders() { return shaders_.reloadChanged(); }

  // Asks for times, or no longer: see the constructor.
  void setMeasuring(bool measuring) { timer_.setMeasuring(measuring); }

  // The newest frames whose times are kept: an hour of play must not grow without bound.
  static constexpr std::size_t kKeptTimes = 4096;
  // Passes, GL objects, renderer, clock. `ms` of a pass is the median over the newest `frames` frames drawn
  // since the last clearTimes(); the caller fills the rest.
  void fillStatistics(core::FrameStatistics& statistics, std::size_t frames = kKeptTimes);
  void clearTimes();
  // Waits until the GPU has done everything it was asked for.
  void finish();

 private:
  void resize(int width, int height);
  void bindTarget(RenderStage stage);
  // Whether the passes of the layer's stage go into it in this frame; it is then the target.
  bool beginLayer(const FrameInput& input);
  void composeLayer(std::exception_ptr& failure);
  void measured(std::string_view name, const std::function<void()>& draw);
  // measured(), but what the pass throws of core::DataError is kept in `failure`, unless there is one.
  void tried(std::string_view name, std::exception_ptr& failure, const std::function<void()>& draw);
  void noteTimes();

  gl::Context& context_;
  RenderSettings settings_;
  gl::ShaderCache shaders_;
  gl::PassTimer timer_;
  gl::Buffer uniforms_;
  gl::FrameBuffer scene_, sceneColorOnly_, output_;
  std::vector<std::unique_ptr<Pass>> passes_;
  std::unique_ptr<StageLayer> layer_;
  std::map<std::string, std::string, std::less<>> skipped_;
  std::map<std::string, std::vector<double>, std::less<>> times_;
};

}  // namespace skydrop::render
