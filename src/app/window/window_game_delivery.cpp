// What the window shows and keeps of the drop: the ride with a package, its small picture, the briefing, the
// list of deliveries and the best results.
#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <utility>

#include "app/console/message.h"
#include "app/window/fault_parts.h"
#include "app/window/window_game.h"

namespace skydrop::app {
namespace {

constexpr std::size_t kShownDeliveries = 6, kShownBest = 3;

template <class... Values>
std::string text(const char* format, Values... values) {
  std::array<char, 96> out{};
  std::snprintf(out.data(), out.size(), format, values...);
  return out.data();
}

}  // namespace

// A player's flight in a window begins with the target ahead, unless it is said how it begins.
void WindowGame::faceTarget() {
  const bool isPlayers = run_->setup.pilot == Pilot::player && !line_.pose;
  const bool isSaid = sets(line_, "delivery.startFacesTarget");
  const bool isSet = run_->settings.delivery.startFacesTarget;
  if (isPlayers && !isSaid && !isSet && !run_->settings.view.lesson &&
      run_->setup.scene.start.strip == scene::StripStart::none) {
    run_->settings.delivery.startFacesTarget = true;
    // So that it stays when the player's file is read again.
    run_->overrides.emplace_back("delivery.startFacesTarget=true");
  }
}

// Before the first one there are words about it.
void WindowGame::beginBriefing() {
  const bool isPlayers = simulation_ && simulation_->pilot() == Pilot::player && !line_.pose;
  const bool hasTargets = simulation_ && simulation_->effects().contains(scene::Effect::targets) &&
                          simulation_->effects().contains(scene::Effect::hud);
  briefing_ = isPlayers && hasTargets && run_->settings.view.briefing && window_.wantsBriefing();
}

void WindowGame::closeBriefing() {
  if (!std::exchange(briefing_, false)) return;
  window_.noteBriefing();
}

void WindowGame::beginDeliveries() {
  ride_.end(), pictured_.end();
  picturedSize_.reset();
  ridden_ = picturedPackage_ = 0;
  deliveryStep_ = 0;
  lesson_.reset();
}

void WindowGame::followLesson() {
  if (!run_->settings.view.lesson || simulation_->pilot() != Pilot::player) return lesson_.reset();
  if (!lesson_) lesson_.emplace();
  using Step = game::Lesson::Step;
  const Step before = lesson_->step();
  if (lesson_->update(simulation_->world().now()) == Step::done && before != Step::done)
    notices_.add("The lesson is over: well done", Notices::kUnrequestedSeconds);
}

std::string WindowGame::lessonText() const {
  const auto key = [this](std::initializer_list<Action> actions) { return controls_.keyOf(actions); };
  switch (lesson_->step()) {
    case game::Lesson::Step::turn:
      return "1 of 3: turn with " + key({Action::rollLeft, Action::rollRight}) +
             " until the beam of light is ahead";
    case game::Lesson::Step::height:
      return "2 of 3: climb or sink by 50 m with " + key({Action::noseUp, Action::noseDown});
    case game::Lesson::Step::drop:
      return "3 of 3: fly to the beam, " + key({Action::drop}) + " when DROP is shown";
    case game::Lesson::Step::done:
      return "Fly on as you like: " + key({Action::help}) + " has all keys";
  }
  return {};
}

void WindowGame::toggleRide() {
  if (ride_.rides()) {
    ride_.end();
    return;
  }
  if (!ride_.begin(simulation_->world().now())) notices_.add("No package in the air");
}

// Begins, follows and ends the views of packages, once a frame.
void WindowGame::followPackages(const game::Snapshot& snapshot, Size size) {
  const render::CameraSettings& camera = run_->settings.render.camera;
  const DropView how = run_->settings.view.dropView;
  const game::PackageSnapshot* newest = newestPackage(snapshot);
  if (how == DropView::ride && newest && !newest->landed && newest->id != std::exchange(ridden_, newest->id))
    ride_.begin(snapshot);
  if (how == DropView::picture && newest && !newest->landed &&
      newest->id != std::exchange(picturedPackage_, newest->id))
    pictured_.begin(snapshot);
  if (!newest) ridden_ = picturedPackage_ = 0;  // another flight counts from 1 again
  const bool pictured = pictured_.rides();
  if (how != DropView::picture) pictured_.end();
  if (pictured && !pictured_.follow(snapshot)) {
    sceneRenderer_->endInset();
    picturedSize_.reset();
  }
  const terrain::HeightSource* ground = simulation_->ground().get();
  if (ride_.rides()) ride_.follow(snapshot);
  sceneRenderer_->lookFrom(split_ ? std::nullopt : ride_.view(snapshot, camera, size, ground));
}

bool WindowGame::showsPicture() const {
  return pictured_.rides() && !ride_.rides() && !split_ && !sceneRenderer_->isSwitching();
}

void WindowGame::drawPicture(const game::Snapshot& snapshot, const ui::ScreenRect& place) {
  hasPicture_ = false;
  const Size size{static_cast<int>(place.right - place.left), static_cast<int>(place.bottom - place.top)};
  if (!showsPicture() || size.width < 16 || size.height < 9) return picturedSize_.reset();
  const auto view = pictured_.view(snapshot, run_->settings.render.camera, size, simulation_->ground().get());
  if (!view) return;
  // Where the processor draws it is renewed in every third frame: the land's triangles weigh more than
  // pixels.
  const bool isDue = !picturedSize_ || *picturedSize_ != std::pair(size.width, size.height) ||
                     ++pictureAge_ >= (window_.context().isSoftware() ? 3 : 1);
  hasPicture_ = !isDue;
  if (!isDue) return;
  picturedSize_.reset();
  attempt(part::kFrame, [&] { hasPicture_ = sceneRenderer_->drawInset(snapshot, *view); });
  if (hasPicture_) picturedSize_ = std::pair(size.width, size.height);
  pictureAge_ = 0;
}

// After each step: hits that are among the best are kept at once.
void WindowGame::noteDeliveries() {
  const std::vector<game::Delivery>& all = simulation_->world().deliveries();
  if (all.empty() || all.back().step <= deliveryStep_) return;
  for (const game::Delivery& delivery : all) {
    if (delivery.step <= deliveryStep_) continue;
    deliveryStep_ = delivery.step;
    if (!delivery.hit || simulation_->pilot() != Pilot::player) continue;
    const std::size_t place = best_.add(
        {delivery.points, delivery.distanceM, delivery.seconds, run_->setup.scene.file.stem().string()});
    if (place > 0) notices_.add(text("Number %zu of your best deliveries", place));
    try {
      if (const auto line = best_.save()) tell(part::kChoices, *line);
    } catch (const std::exception& refusal) {
      tell(part::kChoices, refusal.what());
    }
  }
}

std::optional<ui::HudPanel> WindowGame::panel() const {
  if (briefing_) return briefingPanel();
  if (deliveriesOpen_) return deliveriesPanel();
  return std::nullopt;
}

// The keys are those of the player's table.
ui::HudPanel WindowGame::briefingPanel() const {
  const auto key = [this](std::initializer_list<Action> actions) { return controls_.keyOf(actions); };
  ui::HudPanel panel;
  panel.title = "Drop a package into the circle";
  panel.rows = {
      {"Where", "below the beam of light: the blue dot and the arrow point there"},
      {key({Action::rollLeft, Action::rollRight}), "turn left, right"},
      {key({Action::noseUp, Action::noseDown}), "climb, sink"},
      {key({Action::thrust, Action::brake}), "faster, slower"},
      {key({Action::drop}), "drops a package: while DROP is shown it lands inside"},
      {key({Action::ride}), "rides down with it"},
      {key({Action::help}) + "  " + key({Action::menu}), "all keys; settings"},
  };
  panel.footer = "Near the centre and soon earns most. Any key begins.";
  return panel;
}

ui::HudPanel WindowGame::deliveriesPanel() const {
  ui::HudPanel panel;
  const std::vector<game::Delivery>& all = simulation_->world().deliveries();
  panel.title = text("Deliveries: %lld points", static_cast<long long>(simulation_->world().now().points));
  for (std::size_t i = 0; i < std::min(all.size(), kShownDeliveries); ++i) {
    const game::Delivery& d = all[all.size() - 1 - i];
    panel.rows.push_back({text("%u", d.package), d.hit ? "hit" : "missed", text("%.0f m", d.distanceM),
                          text("%.0f s", d.seconds),
                          d.hit ? text("%lld points", static_cast<long long>(d.points))
                                : std::string(game::reasonText(d.reason))});
  }
  if (all.empty()) panel.rows.push_back({"None yet"});
  for (std::size_t i = 0; i < std::min(best_.all().size(), kShownBest); ++i) {
    const BestResult& r = best_.all()[i];
    panel.rows.push_back({text("Best %zu", i + 1), r.scene, text("%.0f m", r.distanceM),
                          text("%.0f s", r.seconds), text("%lld points", static_cast<long long>(r.points))});
  }
  panel.footer = controls_.keyOf({Action::deliveries}) + " closes";
  return panel;
}

}  // namespace skydrop::app
