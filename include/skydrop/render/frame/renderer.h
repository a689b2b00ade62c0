// Draws frames: owns the passes, the targets, the programs and the timer. Main thread, on the context's
// thread.
#pragma once

#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "skydrop/core/frame_statistics.h"
#include "skydrop/core/image.h"
#include "skydrop/render/frame/next_air.h"
#include "skydrop/render/frame/next_sky.h"
#include "skydrop/render/frame/pass.h"
#include "skydrop/render/frame/sky_tables.h"
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

  gl::Context& context() const { return context_; }
  gl::ShaderCache& shaders() { return shaders_; }

  // Whom passes belong to. Within a stage those of a lower order come first.
  struct Group {
    std::string name;
    int order = 0;
  };
  // Passes that are added from now on belong to this group, and what they make pays for it in the resource
  // tracker. At first it is one without a name.
  void setGroup(Group group) { group_ = std::move(group); }
  const Group& group() const { return group_; }
  // Passes that are added from now on wait: draw() leaves them out until releaseHeld(), and only warmUp()
  // draws them.
  void holdAdded() { holds_ = true; }
  void releaseHeld();
  // Deletes the passes of the groups with this name, and what of the targets may have been made for them.
  void removeGroup(std::string_view name);

  // Passes run by stage, within one by the order of their groups, and then in the order of adding.
  void add(std::unique_ptr<Pass> pass);
  // The first pass of this class in the order of the frame; null without one. The renderer owns it.
  template <class T>
  T* find() const {
    for (const Entry& entry : passes_) {
      if (T* found = dynamic_cast<T*>(entry.pass.get())) return found;
    }
    return nullptr;
  }
  // Of the passes of its stage, from the next frame on, in place of any that was set before. Without one they
  // are drawn into the scene itself.
  void setLayer(std::unique_ptr<StageLayer> layer);

  // The other views in which passes show the scene in a frame of this one (Pass::alsoShows).
  std::vector<View> viewsBeside(const View& view) const;

  void apply(const RenderSettings& settings) { settings_ = settings; }
  const RenderSettings& settings() const { return settings_; }

  // Waits for what is made beside the frames: the air's tables, what passes make (Pass::settle).
  void settle(const FrameInput& input);

  // Draws one frame of the view's size into the output target. Throws core::RangeError for a view that is not
  // valid (requireValid; nothing is drawn then) and core::DataError for a shader that does not compile:
  // thrown when the rest of the frame has been drawn without that pass, which the statistics give as skipped.
  void draw(const FrameInput& input);

  // Draws a frame of the view's size that nobody sees, those passes included that are held, so that no later
  // frame has to wait for what they compile. Pass by pass from the first: those that earlier calls have
  // drawn, one more, and then more until `budgetMs` are used up or a second program would have to be
  // compiled. `drawn`: how many passes earlier calls for this frame have drawn, 0 at first; it is moved on.
  // True when all were drawn. Keep the view small: targets of its size are kept until endWarmUp(). To be
  // called before the draw() of a frame, whose times and counts it leaves alone. Throws what draw() throws.
  bool warmUp(const FrameInput& input, double budgetMs, std::size_t& drawn);
  void endWarmUp() { unseen_ = {}; }

  // Draws the scene of a frame that nobody sees, without tone map and interface, and returns its linear light
  // as readRadiance() does. Nothing where a second program would have to be compiled: call again. Targets of
  // its size are kept until endWarmUp(); times and counts of draw() are left alone. Throws what draw()
  // throws.
  std::optional<std::vector<float>> drawUnseen(const FrameInput& input);

  // A small picture beside the frame's: drawn whole, but for the interface, before the draw() of a frame,
  // whose times and counts it leaves alone, and copied over the frame's output after it, its lower left
  // corner there (pixels; what does not fit is left out). False where a second program would have to be
  // compiled: then there is nothing to show, and the next call goes on. Targets of its size are kept until
  // endWarmUp(). Throws what draw() throws.
  bool drawInset(const FrameInput& input);
  void showInset(int left, int bottom);

  // Draws the stages after the tone map over black into the output: a frame whose picture is one that was
  // kept (SplitPass). The passes that it leaves out are given as skipped, with this reason.
  void drawOverlays(const FrameInput& input, std::string_view reason);

  // Light in the view of the last frame that draw() drew, klx (levelInView()); 0 before the first.
  double lightInView() const { return levelInView_; }
  // Linear light of the last frame, in the size in which the scene was drawn.
  const gl::Texture& sceneColor() const { return screen_.scene.colorTexture(); }
  // The output of the last frame; waits for the GPU. Black before the first.
  core::Image readBack();
  // Linear light of the last frame, red, green and blue of each pixel, the top row first; empty before the
  // first. Where the scene has fewer pixels than the picture (RenderSettings::scale) it is stretched as the
  // tone map does. Waits for the GPU.
  std::vector<float> readRadiance();
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
  // Of each pass that the last frame drew, in its order, what it took when it was last measured, ms; empty
  // while nothing is measured. Names are valid until the passes change.
  std::vector<std::pair<std::string_view, double>> newestTimes() const;
  // What times the passes (core::FrameStatistics::clock).
  std::string_view clockName() const { return timer_.clockName(); }
  void clearTimes();
  // Waits until the GPU has done everything it was asked for.
  void finish();

 private:
  struct Entry {
    std::unique_ptr<Pass> pass;
    Group group;
    bool held = false;
  };
  struct Targets {
    gl::FrameBuffer scene, sceneColorOnly, output;
  };
  enum class Which { drawn, all };

  void resize(const View& scene, const View& picture);
  // Asked after each pass whether to go on with the next.
  using GoesOn = std::function<bool(std::size_t passesDrawn)>;
  struct Stages {
    RenderStage first = RenderStage::shadows, last = RenderStage::menu;
    std::string_view others = {};  // why those that are left out are
    bool contains(RenderStage stage) const { return stage >= first && stage <= last; }
  };
  Overcast overcastOf(const FrameInput& frame, Which which);
  bool isLit() const;  // some pass may ask for the light of the sky
  // FrameContext::drawMirrored, of which this is the frame; the uniform block then holds `after` again.
  void drawMirrored(FrameContext& frame, gl::FrameBuffer& target, Which which, const FrameUniforms& after);
  // False when it ended before the last pass.
  bool drawPasses(const FrameInput& input, Which which, const GoesOn& goesOn, const Stages& stages);
  // The work with the targets, the times and the counts of frames that nobody sees. False where more programs
  // would have to be compiled: one is, and further ones while the budget lasts.
  bool unseen(double budgetMs, const std::function<void()>& work);
  void bindTarget(RenderStage stage);
  // Whether the passes of the layer's stage go into it in this frame; it is then the target.
  bool beginLayer(const FrameInput& input, Which which);
  void composeLayer(FrameContext& context, std::exception_ptr& failure);
  void measured(std::string_view name, const Group& group, const std::function<void()>& draw);
  // measured(), but what the pass throws of core::DataError is kept in `failure`, unless there is one.
  void tried(std::string_view name, const Group& group, std::exception_ptr& failure,
             const std::function<void()>& draw);
  void noteTimes();
  // Of the picture's size, whatever that of the scene.
  static std::vector<float> radianceOf(const Targets& targets);

  gl::Context& context_;
  RenderSettings settings_;
  NextAir air_;
  NextSky sky_;
  gl::ShaderCache shaders_;
  gl::PassTimer timer_;
  std::unique_ptr<MoonOfFrame> moon_;
  gl::Buffer uniforms_;
  SkyTables skyTables_;
  Targets screen_, unseen_;      // of draw(), of warmUp()
  Targets* targets_ = &screen_;  // of the frame that is drawn
  std::vector<Entry> passes_;
  Group group_;
  bool holds_ = false;
  double levelInView_ = 0;
  std::unique_ptr<StageLayer> layer_;
  std::map<std::string, std::string, std::less<>> skipped_;
  std::map<std::string, std::vector<double>, std::less<>> times_;
};

}  // namespace skydrop::render
