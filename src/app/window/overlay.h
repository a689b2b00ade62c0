// What is drawn over the frame: HUD, help, configuration menu, Escape menu. Owns the interface and remembers
// what is open; what follows from a change or an action is the caller's business. Main thread.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/types/size.h"
#include "skydrop/core/cpu_meter.h"
#include "skydrop/core/frame_statistics.h"
#include "skydrop/core/guard_watch.h"
#include "skydrop/core/settings_table.h"
#include "skydrop/game/snapshot.h"
#include "skydrop/scene/effect.h"
#include "skydrop/ui/cost_panel.h"
#include "skydrop/ui/hud.h"
#include "skydrop/ui/imgui_context.h"
#include "skydrop/ui/loading_picture.h"
#include "skydrop/ui/menu.h"
#include "skydrop/ui/photo_layer.h"
#include "skydrop/ui/split_labels.h"
#include "skydrop/ui/weather_bar.h"

namespace skydrop::app {

struct OverlayFrame {
  const game::Snapshot& snapshot;
  Size size;
  double seconds = 0;  // since the last frame
  const core::SettingsTable& table;
  const core::FrameStatistics* statistics = nullptr;
  std::string_view error = {};  // what is broken now (faults.h)
  ui::MenuTools tools = {};
  const ui::BindingsContent* bindings = nullptr;  // null: the menu does not show them
  ui::InterfaceScale scale = {};
  const ui::SplitLabels* split = nullptr;  // of the split view, which takes the place of the HUD; null: none
  const ui::CostPanelContent* costs = nullptr;  // of the panel of costs; null: it is closed
  const std::vector<core::FiredGuard>* guards =
      nullptr;                                        // of this frame, to be listed; null: they are not shown
  const ui::PhotoLayer* photo = nullptr;              // null: there is none, or it is hidden
  const ui::WeatherBarContent* weatherBar = nullptr;  // null: it is hidden, or there is no weather data
  std::optional<ui::Eye> eye = std::nullopt;  // for marks on places of the world; none: they are not shown
  bool instruments = false;                   // the dials
  std::optional<ui::HudPanel> panel = std::nullopt;
  double pictureAspect = 0;               // of the package's picture (ui::HudData)
  std::function<void()> begun = nullptr;  // called when the frame has taken the input (EventFeed::frameBuilt)
};

struct OverlayResult {
  ui::MenuResult menu;
  ui::EscapeAction escape = ui::EscapeAction::none;
  std::optional<double> divider;  // where the split view's was dragged, 0 .. 1 of the width
  bool costsClosed = false;       // the cross of the panel of costs was clicked
  ui::WeatherBarResult weatherBar;
  ui::ScreenRect picture;     // where the package's belongs; empty: nowhere
  bool fontsChanged = false;  // render::ImGuiPass::uploadFonts() is due before the frame is drawn
};

class Overlay {
 public:
  Overlay(const scene::EffectSet& effects, Size size, std::vector<ui::HelpRow> help,
          const ui::InterfaceScale& scale = {});

  ui::ConfigurationMenu& menu() { return menu_; }
  // After the interface of another window (ui::Interface::makeCurrent).
  void makeCurrent() const { interface_.makeCurrent(); }
  const ui::WeatherBar& weatherBar() const { return weatherBar_; }
  // Somebody looks at what the passes cost.
  bool showsCosts() const { return menuOpen && menu_.showsCosts(); }

  bool menuOpen = false;
  bool helpOpen = false;
  bool escapeOpen = false;
  bool hudShown = true;

  // What the scene calls for from now on: sections of the menu, HUD.
  void showEffects(const scene::EffectSet& effects);

  // What the help lists, and the keys that the display names.
  void showKeys(std::vector<ui::HelpRow> help, ui::HudKeys keys);

  // Builds the draw data of this frame (ImGui::GetDrawData). The cross of the menu has closed it when this
  // returns.
  OverlayResult build(const OverlayFrame& frame);

  // Measures the CPU time of build() from the next one on, or no longer; and adds it to the bill.
  void setMeasuring(bool measuring) { cost_.setMeasuring(measuring); }
  void writeTo(core::FrameStatistics& statistics) const;
  double costMs() const { return cost_.ms(); }  // of all frames that were measured

  // The same with what is shown while the land is made. True if the fonts changed.
  bool buildLoading(Size size, const ui::LoadingProgress& progress, const ui::InterfaceScale& scale);

 private:
  OverlayResult buildMeasured(const OverlayFrame& frame);

  core::CpuMeter cost_;
  bool drawsHud_ = false;
  std::vector<ui::HelpRow> help_;
  ui::HudKeys keys_;
  std::vector<ui::MenuSection> sections_;
  ui::Interface interface_;
  ui::ConfigurationMenu menu_;
  ui::EscapeMenu escapeMenu_;
  ui::WeatherBar weatherBar_;
};

}  // namespace skydrop::app
