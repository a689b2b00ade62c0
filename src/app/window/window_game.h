// The game in its window: events in, steps of the simulation, frames out, until the player quits. Main
// thread.
#pragma once

#include <chrono>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/input/event_feed.h"
#include "app/input/glfw_joysticks.h"
#include "app/input/imgui_input.h"
#include "app/input/player_controls.h"
#include "app/measure/cost_history.h"
#include "app/measure/frame_times.h"
#include "app/session/clock_pace.h"
#include "app/session/frame_budget.h"
#include "app/session/package_camera.h"
#include "app/session/player_camera.h"
#include "app/session/preparations.h"
#include "app/session/run_config.h"
#include "app/session/scene_renderer.h"
#include "app/session/split_view.h"
#include "app/settings/best_results.h"
#include "app/types/command_line.h"
#include "app/window/cursor_auto_hide.h"
#include "app/window/faults.h"
#include "app/window/file_watch.h"
#include "app/window/game_window.h"
#include "app/window/knob_stands.h"
#include "app/window/loading.h"
#include "app/window/menu_controller.h"
#include "app/window/notices.h"
#include "app/window/overlay.h"
#include "app/window/photo_overlay.h"
#include "app/window/screenshots.h"
#include "app/window/weather_bar_data.h"
#include "skydrop/audio/audio_manager.h"
#include "skydrop/audio/sound_scene.h"
#include "skydrop/core/cpu_meter.h"
#include "skydrop/core/fixed_step.h"
#include "skydrop/core/guard_watch.h"
#include "skydrop/core/output_file.h"
#include "skydrop/forecast/renewal.h"
#include "skydrop/game/lesson.h"

namespace skydrop::app {

class WindowGame {
 public:
  // Throws core::GraphicsUnavailable, core::DataError, core::UsageError.
  explicit WindowGame(const CommandLine& line);
  ~WindowGame();

  // Returns when the window was closed, the player quit or a signal asked to end; then the statistics, the
  // end of the recording and the player's settings are written. So they are before it throws what ended the
  // flight early. The exit code: 1 where the recording is incomplete.
  int run();

  // Whether a signal has asked this process to end.
  static bool wasAskedToEnd();

 private:
  void tellOfSoftware();
  // What is made again for another scene or another land.
  struct Flight {
    std::unique_ptr<Simulation> simulation;
    std::unique_ptr<SceneRenderer> sceneRenderer;
    std::unique_ptr<audio::SoundScene> sound;
  };
  Flight loadFlight(bool& lostFocus);
  void buildScene();
  void beginPreparations();
  void handleEventsWhileLoading(bool& lostFocus);
  bool ends();
  void fly();
  void handleEvents();
  bool takeEvent(const render::gl::WindowEvent& event);
  void handleAction(Action action);
  void switchLandingLight();
  void nextPhotoView();
  void toggle(const std::string& path);
  void showControls();
  void advance(double seconds);
  void drawFrame(double seconds);
  void visitLaboratory();  // in a window of its own, while the flight is paused
  void drawScene(const game::Snapshot& snapshot, Size size);
  void drawSplit(const game::Snapshot& snapshot, Size size);
  OverlayResult buildInterface(const game::Snapshot& snapshot, double seconds);
  void serve(const OverlayResult& result);
  // Carries a change out. What fails leaves the last good state and a line about this part of the program.
  bool attempt(std::string_view part, const std::function<void()>& change);
  void goBack();
  void tell(std::string_view part, const std::string& line);
  void applyMenuChanges(SettingsChange picked);
  void registerDependents();
  // A change that was taken over into the run: loads the flight again where the description asks for that.
  void carryOut(const SettingsChange& change);
  void toggleCosts();
  void noteCosts();  // of the frame before, while the panel of costs is open
  ui::CostPanelContent costContent() const;
  // The budget that the settings ask for in place of the one there is, or none. Throws core::DataError, and
  // then changes nothing.
  void renewBudget();
  void followBudget(double drawnMs, double frameMs);  // of the frame that was drawn last
  SettingsChange takeByHand(const SettingsChange& picked);
  void toggleSplit();
  void beginSplit();
  void endSplit();
  void followSplit(const SettingsChange& change);
  // Of the drop: what is seen, told and kept of it (window_game_delivery.cpp).
  void toggleRide();
  void followPackages(const game::Snapshot& snapshot, Size size);
  void noteDeliveries();
  std::optional<ui::HudPanel> panel() const;
  ui::HudPanel briefingPanel() const;
  ui::HudPanel deliveriesPanel() const;
  bool showsPicture() const;
  void drawPicture(const game::Snapshot& snapshot, const ui::ScreenRect& place);
  void faceTarget();
  void beginDeliveries();  // of another flight
  void beginBriefing();
  void closeBriefing();
  void followLesson();
  std::string lessonText() const;
  void releaseFreeze();  // that was for the split view alone
  void dragDivider(double divider);
  // Effects come and go: at once in the simulation and in what is heard, in steps in what is drawn.
  void switchEffects();
  void continueSwitch(double seconds);
  void openSound();
  void renewLostSound();
  audio::Listener listener(const game::Snapshot& snapshot, Size size) const;
  void hear(const game::Snapshot& snapshot, Size size);
  void apply(const SettingsChange& change);  // to all dependents
  void watchFiles();
  void beginRenewal();
  void followRenewal();
  bool showsWeatherBar() const { return run_->settings.view.weatherBar && run_->setup.forecast && !split_; }
  ui::WeatherBarContent weatherBarContent(const game::Snapshot& snapshot, Size size);
  void serve(const ui::WeatherBarResult& asked);
  void handleWeatherAction(Action action);
  void moveForecastTo(double utcMs);
  void paceForecastAt(double speed);
  void followForecast(bool live);
  void writeWeatherTo(core::WindowStatistics& window) const;
  void reloadSceneFile();
  void watchLand();
  void reloadLandFiles();
  void reloadPlayerFile();
  void servePreset(const ui::PresetRequest& request);
  ui::MenuTools menuTools(const game::Snapshot& snapshot, Size size);
  void announce(const std::string& line, const std::string& notice);
  void tellOfRefusals(const std::vector<std::string>& reasons);
  void keepRecording();
  void saveScreenshot(const game::Snapshot& drawn);
  void measureIfAsked();
  void renewCosts();
  void report();
  void keepChoices();
  game::Snapshot snapshotToDraw();
  core::FrameStatistics statistics(std::size_t frames = render::Renderer::kKeptTimes);
  // Everything that has to be kept; throws `failure`, or else the first that its steps met.
  void finish(std::exception_ptr failure);

  // A pause holds everything; a freeze holds simulated time, and the keys move the free camera.
  bool isPaused() const { return paused_ || briefing_ || overlay_->escapeOpen; }
  bool interfaceUsesPointer() const {
    return overlay_->menuOpen || overlay_->escapeOpen || split_ || costs_ || showsWeatherBar();
  }
  bool isFrozen() const { return run_->settings.view.freezeTime; }

  CommandLine line_;
  std::unique_ptr<RunConfig> run_;
  SettingsDependencies simulationDependencies_;    // of the simulation
  SettingsDependencies presentationDependencies_;  // of what is seen and heard
  std::optional<core::OutputFile> stats_;          // --stats; opened before the window
  GameWindow window_;
  Preparations preparations_;  // of what the scene calls for; kept while scenes go on to call for it
  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<Overlay> overlay_;  // before the sceneRenderer, whose pass draws its fonts
  std::unique_ptr<SceneRenderer> sceneRenderer_;
  std::unique_ptr<SplitView> split_;            // while it is shown: draws by the renderer above
  bool splitFroze_ = false;                     // time is held for it
  std::unique_ptr<audio::AudioManager> audio_;  // with sound only
  std::unique_ptr<audio::SoundScene> sound_;
  audio::SurroundingsEar surroundings_;
  core::CpuMeter soundCost_;                                           // of its updates
  std::optional<std::chrono::steady_clock::time_point> soundRenewed_;  // after its device was lost
  std::unique_ptr<Clipboard> clipboard_;
  std::optional<ImGuiInput> imguiInput_;  // for the overlay's context
  std::optional<EventFeed> feed_;         // for imguiInput_
  GlfwJoysticks joysticks_;
  PlayerControls controls_;
  PlayerCamera camera_;
  PackageCamera ride_;        // while the player rides along
  std::uint32_t ridden_ = 0;  // the package that was last ridden with, so that it begins once
  PackageCamera pictured_;    // of the small picture
  std::uint32_t picturedPackage_ = 0;
  std::optional<std::pair<int, int>> picturedSize_;  // of the picture that is kept
  int pictureAge_ = 0;                               // frames since it was drawn
  bool hasPicture_ = false;                          // it was drawn beside this frame
  BestResults best_;
  std::uint64_t deliveryStep_ = 0;  // up to which deliveries are counted
  bool briefing_ = false, deliveriesOpen_ = false;
  std::optional<game::Lesson> lesson_;  // where the settings have one
  MenuController menuController_;
  CursorAutoHide pointer_;
  bool pointerMoved_ = false;
  core::FixedStep clock_;
  ClockPace clockPace_;      // of the sky
  double drawnSeconds_ = 0;  // simulated, of the last frame

  bool paused_ = false;
  bool screenshotWanted_ = false;
  bool laboratoryWanted_ = false;
  bool replayEnded_ = false;
  bool menuWasOpen_ = false;
  bool saveChoicesPending_ = false;  // to be kept, once the files were looked at
  Screenshots screenshots_;
  Faults faults_;                // the latest is shown in the menu
  Choices lastGood_;             // that a frame was drawn with
  bool changeNotDrawn_ = false;  // what is in force since no frame has been drawn with yet
  bool menuChangedIt_ = false;   // and the menu remembers a step of it
  Notices notices_;
  std::vector<game::GameEvent> events_;  // of the steps since the last frame
  FrameTimes times_;
  // While the panel of costs is open.
  struct OpenCosts {
    CostHistory history;
    MeasuredFronts fronts;
    std::vector<ui::KnobStand> knobs;  // of the settings as they are
    std::string clock;
  };
  std::unique_ptr<OpenCosts> costs_;
  core::GuardWatch guards_;                             // looked at once a frame
  std::unique_ptr<FrameBudget> budget_;                 // while one is set
  std::string budgetText_;                              // of it, for the panel
  std::chrono::steady_clock::time_point drawingSince_;  // of the frame, while a budget is set
  core::FrameStatistics shownStatistics_;               // what the menu shows of costs
  std::chrono::steady_clock::time_point nextWatch_, nextStatistics_, nextCosts_, nextFlush_;
  std::chrono::steady_clock::time_point lastFrame_;
  double loadedMs_ = 0;
  std::int64_t programsLoaded_ = 0;
  FileWatch sceneFile_, playerFile_;
  FilesWatch landFiles_;
  std::unique_ptr<forecast::Renewal> renewal_;  // with --live only
  WeatherBarData weatherBarData_;
  std::optional<PhotoOverlay> photo_;  // with --photo only
  bool saidRenewalFailed_ = false;     // on stderr, of the failures since the last answer
};

}  // namespace skydrop::app
