// The graphics of a scene: renderer, the passes that its effects call for, camera, streaming of the land.
// Effects come and go while flying. Main thread, on the context's thread. Draws snapshots; knows nothing of
// time.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/session/effect_table.h"
#include "app/session/land_streaming.h"
#include "app/session/prepared_resources.h"
#include "app/settings/settings.h"
#include "app/settings/settings_change.h"
#include "app/types/size.h"
#include "skydrop/core/cpu_meter.h"
#include "skydrop/core/frame_statistics.h"
#include "skydrop/core/image.h"
#include "skydrop/elevation/aerial_image.h"
#include "skydrop/game/snapshot.h"
#include "skydrop/render/frame/camera.h"
#include "skydrop/render/frame/eye_adaptation.h"
#include "skydrop/render/frame/renderer.h"
#include "skydrop/render/models/shadow_source.h"
#include "skydrop/render/overlay/imgui_pass.h"
#include "skydrop/scene/effect.h"

namespace skydrop::app {

class CompileAhead;

// How a frame treats land, and what else is made beside the frames, that is not there yet: draw what there
// is, or wait until all of it is.
enum class Streaming { asItComes, settled };

class SceneRenderer {
 public:
  struct Setup {
    scene::EffectSet effects;
    std::shared_ptr<const terrain::HeightSource> ground;
    std::optional<int> workers = std::nullopt;
    bool measuring = false;           // times are asked for: a software renderer may be slowed down for them
    PreparedResources prepared = {};  // what the effects prepared (Preparations::results)
    const std::vector<EffectDescriptor>* table = &effectTable();  // what effects are made of; outlives it
    // While effects come, what they draw with is compiled on another thread first (compile_ahead.h).
    bool compilesAhead = false;
    // Frames are drawn one after the other, as they are flown: each may use what the one before it left
    // (render::FrameInput::followsLast). Off, each is a function of snapshot, view and settings.
    bool framesFollow = false;
    std::vector<std::shared_ptr<const elevation::AerialImage>> images = {};  // that the land wears
  };

  // Adds the passes of the effects (effect_table.h). Context and settings must outlive it. Throws
  // core::DataError (shader, model).
  SceneRenderer(render::gl::Context& context, const Setup& setup, const Settings& settings);
  ~SceneRenderer();

  // Whether the next frames follow one another (Setup::framesFollow).
  void setFramesFollow(bool follow) { setup_.framesFollow = follow; }

  render::Camera& camera() { return camera_; }
  // Lets the free camera begin where the last frame was seen from.
  void freeCamera();
  render::Renderer& renderer() { return renderer_; }
  // Null without terrain.
  const terrain::EndlessTerrain* land() const { return land_ ? &land_->terrain() : nullptr; }

  // For the functions of the effect table.
  const Setup& setup() const { return setup_; }
  const PreparedResources& prepared() const { return setup_.prepared; }
  const Settings& settings() const { return *settings_; }
  // Of the effect that adds its passes: something whose shadow falls on land.
  void castShadow(render::ShadowSource source);
  // Makes this the land that frames wait for and cameras keep above.
  void stream(std::unique_ptr<LandStreaming> land) { land_ = std::move(land); }
  LandStreaming* streaming() { return land_.get(); }  // null before stream()

  // The effects that are there, or on the way.
  const scene::EffectSet& effects() const { return setup_.effects; }
  // From now on other effects. What goes has given up everything when this returns. What comes is made, and
  // compiled in frames that nobody sees, by calls of continueSwitch(); it is drawn when all of it is ready.
  // `ground`: of the land from now on.
  void beginSwitch(const scene::EffectSet& effects, std::shared_ptr<const terrain::HeightSource> ground);
  bool isSwitching() const { return switch_.has_value(); }
  // Once a frame before draw(), from when all is prepared that the effects need until isSwitching() is false:
  // makes one effect, or draws unseen what compiles the programs of later frames. It takes `budgetMs`, and
  // then as long as the last of what it does: a program, an effect. Throws core::DataError (shader, model):
  // then beginSwitch() to what was there before is the way back.
  void continueSwitch(const PreparedResources& prepared, const game::Snapshot& snapshot, double budgetMs);

  // After the settings changed: takes over for the next frame what of them is drawn.
  void apply(const SettingsChange& change);

  // From now on draws by these settings, which must outlive it as the first ones must; they differ from those
  // before in nothing that makes another scene. Takes over what differs.
  void useSettings(const Settings& settings);

  // From now on draws what Dear ImGui has built; the interface's context must exist.
  void addOverlay();
  void uploadFonts();  // after the interface changed its fonts

  // Asks for the times of the passes, or no longer: what Setup::measuring says at first.
  void setMeasuring(bool measuring);
  // CPU time of asking for land, of all frames that were measured.
  double streamingMs() const { return streamingCost_.ms(); }

  // Whether the picture leaves its left half to something beside it (withRoomToTheLeft): from the next view
  // on.
  void leaveRoomToTheLeft(bool leaves) { leavesRoom_ = leaves; }

  // From where the snapshot is seen.
  render::View view(const game::Snapshot& snapshot, Size size) const;

  // From now on frames are seen from there and not by the camera, in their own size; none: by the camera.
  void lookFrom(const std::optional<render::View>& view) { lookedFrom_ = view; }

  // A picture beside the frame's (render::Renderer::drawInset): before the draw() of the frame, of the land
  // that is there. Whether there is one to show.
  bool drawInset(const game::Snapshot& snapshot, const render::View& view);
  // After it: the lower left corner, pixels.
  void showInset(int left, int bottom) { renderer_.showInset(left, bottom); }
  void endInset() {
    if (!switch_) renderer_.endWarmUp();
  }

  // One frame of the size into the renderer's output.
  void draw(const game::Snapshot& snapshot, Size size, Streaming streaming);

  // For a picture that is kept while it is shown (SplitView). Asks for the land of this view, or waits for
  // it; whether all of it is there.
  bool updateLand(const render::View& view, Streaming streaming);
  // Linear light of the snapshot from this view, which nobody sees, with the land of the last update: see
  // Renderer::drawUnseen(), whose targets are kept until endUnseen().
  std::optional<std::vector<float>> drawUnseen(const game::Snapshot& snapshot, const render::View& view);
  void endUnseen() { renderer_.endWarmUp(); }
  // A frame whose picture one of the overlays has kept: Renderer::drawOverlays().
  void drawOverlays(const game::Snapshot& snapshot, Size size, std::string_view reason);

  // Draws frames around this place into the output with an aircraft, a package and a target in them, with and
  // without clouds in view, from outside and from the cockpit: so that no later frame has to wait until a
  // shader is compiled for something that it shows for the first time. Ends early between frames.
  void warmUp(const game::Snapshot& snapshot, Size size, const std::stop_token& stop = {});

  // One round of making the land that this frame will show, without drawing.
  struct LandProgress {
    std::size_t ready = 0, wanted = 0;  // chunks
    bool complete = true;
  };
  LandProgress load(const game::Snapshot& snapshot, Size size);

  // Milliseconds that the last draw() spent in waiting for land.
  double settleMs() const { return settleMs_; }

  // Recompiles changed shaders and gives up nothing: one line for each that is broken, and for each part
  // of the land that could not be made.
  std::vector<std::string> takeMessages();

  // A line about a shader whose file does not compile as it is now; empty: there is none.
  std::string_view standingError() { return renderer_.shaders().standingError(); }

  // The passes' times are medians over the newest `frames`. The bill has a row for each effect of the table:
  // what it draws and holds of the GPU. Other parts of the program add theirs, before or after (billRow).
  void writeTo(core::FrameStatistics& statistics, std::size_t frames = render::Renderer::kKeptTimes);

 private:
  // An effect's own passes, or those that it has together with another one.
  struct Part {
    const EffectDescriptor* row;
    const EffectDescriptor::Joint* joint = nullptr;
    bool castsShadow = false;
    std::string name() const;
    bool operator==(const Part& other) const { return row == other.row && joint == other.joint; }
  };
  struct WarmUpFrame {
    game::Snapshot snapshot;
    render::View view;
    bool smoothModels = true;
  };
  struct Switch {
    render::FrameFeatures drawnFeatures;            // until all is ready
    std::shared_ptr<CompileAhead> ahead = nullptr;  // null before it begins
    std::size_t frame = 0;                          // of the frames to warm up with
    std::size_t passesDrawn = 0;                    // of it
    bool isReady = false;  // what came is drawn; what is not used any more is looked for
  };

  std::vector<Part> partsOf(const scene::EffectSet& effects) const;
  void addPart(const Part& part);
  void removePart(const Part& part);
  // The pass that smooths edges, made anew where the settings ask for it: what it held goes.
  void resetEdges();
  std::vector<WarmUpFrame> warmUpFrames(const game::Snapshot& snapshot, Size size) const;
  // Whether what comes may be compiled here. Begins to have it compiled elsewhere at the first call.
  bool isCompiledAhead(const game::Snapshot& snapshot);
  bool warmUpInPart(const game::Snapshot& snapshot, double budgetMs);
  // Draws on with the frame; true when all of it was drawn.
  bool drawUnseen(const WarmUpFrame& frame, const render::FrameFeatures& features, double budgetMs);
  render::FrameFeatures features() const;
  // Whether the frame shows something else than the one before it.
  bool isCut(const game::Snapshot& snapshot, const render::View& view) const;
  bool eyeAdapts() const { return setup_.framesFollow && settings_->view.eyeAdaptation; }
  render::FrameInput inputOf(const game::Snapshot& snapshot, const render::View& view) const;
  const EffectDescriptor* firstCaster() const;  // who pays for the map of shadows; null: nobody casts one
  core::EffectStatistics billOf(const EffectDescriptor& row, const core::FrameStatistics& frame) const;
  core::EffectStatistics billOfFrame(const core::FrameStatistics& frame) const;
  bool owns(const EffectDescriptor& row, const std::string& part) const;

  Setup setup_;
  const Settings* settings_;
  render::Renderer renderer_;
  render::Camera camera_;
  bool leavesRoom_ = false;
  std::optional<render::View> lastView_, lookedFrom_;
  bool lastLookedFrom_ = false;         // in the last frame there was such a view
  render::EyeAdaptation eye_;           // of frames that follow each other
  std::uint32_t lastSpawn_ = 0;         // of the aircraft in the last frame
  render::CameraMode lastCamera_ = {};  // of the last frame
  Size drawnSize_{1, 1};                // of the last frame
  std::vector<Part> parts_;             // that are there, in the order of adding
  std::optional<Switch> switch_;
  std::vector<std::shared_ptr<CompileAhead>> givenUp_;  // of earlier switches, until they have ended
  std::map<std::string, double> startMs_;               // what each effect took to be made, on this thread
  std::unique_ptr<LandStreaming> land_;                 // with terrain only
  render::ImGuiPass* overlay_ = nullptr;                // the renderer's
  double settleMs_ = 0;
  core::CpuMeter streamingCost_;
};

}  // namespace skydrop::app
