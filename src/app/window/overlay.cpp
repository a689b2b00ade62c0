#include "app/window/overlay.h"

#include <optional>
#include <utility>

#include "app/measure/bill.h"
#include "app/session/effect_table.h"
#include "skydrop/ui/guard_list.h"

namespace skydrop::app {

Overlay::Overlay(const scene::EffectSet& effects, Size size, std::vector<ui::HelpRow> help,
                 const ui::InterfaceScale& scale)
    : help_(std::move(help)), interface_(size.width, size.height, scale) {
  showEffects(effects);
}

void Overlay::showEffects(const scene::EffectSet& effects) {
  drawsHud_ = effects.contains(scene::Effect::hud);
  sections_ = menuSections(effects);
}

void Overlay::showKeys(std::vector<ui::HelpRow> help, ui::HudKeys keys) {
  help_ = std::move(help);
  keys_ = std::move(keys);
}

OverlayResult Overlay::build(const OverlayFrame& frame) {
  OverlayResult result;
  cost_.measure([&] { result = buildMeasured(frame); });
  cost_.endRound();
  return result;
}

// The menu belongs to no effect.
void Overlay::writeTo(core::FrameStatistics& statistics) const {
  billRow(statistics, drawsHud_ ? scene::nameOf(scene::Effect::hud) : kFrameRow).updateMs += cost_.meanMs();
}

OverlayResult Overlay::buildMeasured(const OverlayFrame& frame) {
  OverlayResult result;
  result.fontsChanged =
      interface_.beginFrame(frame.size.width, frame.size.height, frame.seconds, frame.scale);
  if (frame.begun) frame.begun();
  if (frame.photo)
    ui::drawPhotoLayer(*frame.photo, static_cast<float>(frame.size.width),
                       static_cast<float>(frame.size.height));
  if (frame.split) result.divider = ui::drawSplitLabels(interface_, *frame.split);
  if (frame.costs) result.costsClosed = !ui::drawCostPanel(interface_, *frame.costs);
  if (frame.guards) ui::drawGuardList(interface_, ui::guardLines(*frame.guards));
  if (frame.weatherBar) result.weatherBar = weatherBar_.draw(interface_, *frame.weatherBar);
  if (menuOpen) {
    ui::MenuContent content{frame.table, sections_, frame.statistics, frame.error, frame.tools};
    content.bindings = frame.bindings;
    result.menu = menu_.draw(interface_, content);
    if (result.menu.closed) menuOpen = false;
  }
  if (escapeOpen) {
    result.escape = escapeMenu_.draw(interface_);
  } else {
    escapeMenu_.reset();
  }
  if (drawsHud_ && hudShown && !frame.split) {
    ui::HudData data = ui::makeHudData(frame.snapshot);
    data.keys = keys_;
    if (frame.eye && !frame.snapshot.paused) data.marks = ui::hudMarks(frame.snapshot, *frame.eye);
    if (frame.instruments && frame.snapshot.aircraft.present)
      data.instruments = ui::readingsOf(frame.snapshot);
    data.panel = frame.panel;
    data.pictureAspect = frame.pictureAspect;
    if (escapeOpen) data.paused = false;  // the small menu covers that place and says so itself
    const std::vector<ui::HelpRow> none;
    const auto menu = menuOpen ? std::optional(menu_.place()) : std::nullopt;
    const float taken = frame.weatherBar ? ui::WeatherBar::height(interface_) : 0;
    const ui::HudLayout layout = ui::layoutHud(interface_, data, helpOpen ? help_ : none, menu, taken);
    ui::drawHud(interface_, data, layout);
    result.picture = layout.picture;
  }
  interface_.endFrame();
  return result;
}

bool Overlay::buildLoading(Size size, const ui::LoadingProgress& progress, const ui::InterfaceScale& scale) {
  const bool fontsChanged = interface_.beginFrame(size.width, size.height, 0, scale);
  ui::drawLoadingPicture(interface_, progress);
  interface_.endFrame();
  return fontsChanged;
}

}  // namespace skydrop::app
