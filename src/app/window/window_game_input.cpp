// What keys, mouse, gamepad and focus do to the program; those of the flight are PlayerInput's.
#include <array>
#include <string>

#include "app/console/message.h"
#include "app/window/fault_parts.h"
#include "app/window/window_game.h"

namespace skydrop::app {

void WindowGame::handleEvents() {
  using Kind = render::gl::WindowEvent::Kind;
  bool lostFocus = false;
  for (const render::gl::WindowEvent& event : window_.pollEvents()) {
    if (event.kind == Kind::focus) lostFocus = !event.pressed;
    if (event.kind == Kind::mouseMove) pointerMoved_ = true;
    feed_->add(event, window_.context().pixelsPerUnit());
  }
  for (const render::gl::WindowEvent& event : controls_.pollGamepad(overlay_->escapeOpen))
    feed_->addForInterface(event);
  feed_->deliver({[this](const render::gl::WindowEvent& event) { return takeEvent(event); },
                  [this] { return interfaceUsesPointer(); },
                  [this] { serve(buildInterface(snapshotToDraw(), 0)); }});
  // What comes back at once was not lost: a window that opens under the mouse sees the focus come, go and
  // come.
  if (lostFocus) paused_ = true;
  for (const Action action : controls_.input().takeActions()) handleAction(action);  // of a gamepad
  showControls();
}

// True if the event was for the editor of the bindings. What it does to the program takes effect before the
// next.
bool WindowGame::takeEvent(const render::gl::WindowEvent& event) {
  using Kind = render::gl::WindowEvent::Kind;
  // Any key or button closes the briefing, and does what it does besides.
  if (event.pressed && (event.kind == Kind::key || event.kind == Kind::mouseButton)) closeBriefing();
  const bool ofMenu = overlay_->menuOpen && ImGuiInput::isMenuChord(event);
  const bool taken = controls_.handle(event, ImGuiInput::wantsText() || ofMenu);
  for (const Action action : controls_.input().takeActions()) handleAction(action);
  return taken;
}

// What the player steers with, wherever it is told.
void WindowGame::showControls() {
  for (const GamepadMessage& message : controls_.takeMessages()) {
    warn(message.text);
    if (message.isNews) notices_.add(message.text);
  }
  if (!overlay_->menuOpen) controls_.stopWaiting();
  if (controls_.takeChange()) overlay_->showKeys(controls_.help(), controls_.hudKeys());
}

void WindowGame::handleAction(Action action) {
  closeBriefing();  // also by a button of a gamepad
  switch (action) {
    case Action::camera:
      run_->settings.view.camera = camera_.next(*sceneRenderer_);
      notices_.add("Camera: " + std::string(render::cameraModeName(run_->settings.view.camera)));
      break;
    case Action::pause:
      paused_ = !paused_;
      break;
    case Action::help:
      overlay_->helpOpen = !overlay_->helpOpen;
      break;
    case Action::menu:
      overlay_->menuOpen = !overlay_->menuOpen;
      break;
    case Action::escape:
      overlay_->escapeOpen = !overlay_->escapeOpen;
      break;
    case Action::fullScreen:
      window_.toggleFullScreen();
      break;
    case Action::screenshot:
      screenshotWanted_ = true;
      break;
    case Action::freeze:
      toggle("view.freezeTime");
      notices_.add(isFrozen() ? "Time is frozen: the keys move the camera" : "Time goes on");
      break;
    case Action::costs:
      toggleCosts();
      break;
    case Action::split:
      toggleSplit();
      break;
    case Action::ride:
      toggleRide();
      break;
    case Action::deliveries:
      deliveriesOpen_ = !deliveriesOpen_;
      break;
    case Action::landingLight:
      switchLandingLight();
      break;
    case Action::photo:
      nextPhotoView();
      break;
    case Action::mute:
      toggle("audio.mute");
      notices_.add(run_->settings.audio.mute ? "Sound off" : "Sound on");
      break;
    case Action::weatherBar:
    case Action::weatherMode:
    case Action::hourBack:
    case Action::hourForward:
    case Action::timeSlower:
    case Action::timeFaster:
      handleWeatherAction(action);
      break;
    default:
      break;  // flight actions: PlayerInput::step
  }
}

// Not, laid over, wiped, beside: and again.
void WindowGame::nextPhotoView() {
  if (!photo_) return notices_.add("No photograph here: --photo FILE");
  ViewSettings& view = run_->settings.view;
  const std::size_t next = (static_cast<std::size_t>(view.photo) + 1) % kPhotoViewNames.size();
  attempt(part::kChange, [&] {
    core::setField(run_->table.at("view.photo"), static_cast<double>(next));
    applyMenuChanges({"view.photo"});
  });
  constexpr std::array<std::string_view, kPhotoViewNames.size()> kNotices = {
      "Photograph: hidden", "Photograph: laid over the picture", "Photograph: wiped from the left",
      "Photograph: beside the picture"};
  notices_.add(std::string(kNotices[static_cast<std::size_t>(view.photo)]));
}

void WindowGame::switchLandingLight() {
  if (!sceneRenderer_->effects().contains(scene::Effect::landingLight)) {
    notices_.add("No landing light here: F1, Effects");
    return;
  }
  toggle("landingLight.on");
  notices_.add(run_->settings.landingLight.on ? "Landing light on" : "Landing light off");
}

// A flag by its key, as if in the menu.
void WindowGame::toggle(const std::string& path) {
  const core::Field& flag = run_->table.at(path);
  core::setField(flag, flag.get() != 0 ? 0.0 : 1.0);
  attempt(part::kChange, [&] { applyMenuChanges({path}); });
}

}  // namespace skydrop::app
