// What is heard: the sound device, and from where the flight is listened to.
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <memory>
#include <optional>

#include "app/console/message.h"
#include "app/session/ground.h"
#include "app/session/lightning_effect.h"
#include "app/window/window_game.h"
#include "skydrop/render/frame/sky_light.h"

namespace skydrop::app {
namespace {

using Clock = std::chrono::steady_clock;

// A device that goes away sooner than this after another did is not asked for again.
constexpr auto kSoundLasts = std::chrono::seconds(2);

}  // namespace

void WindowGame::openSound() {
  if (audio_) return;
  audio_ = std::make_unique<audio::AudioManager>(run_->settings.audio);
  if (audio_->isSilent()) warn(audio_->status());
}

// As headphones do: through the device that there is now, or silently.
void WindowGame::renewLostSound() {
  if (!audio_ || audio_->isConnected()) return;
  const bool wasRenewed = soundRenewed_ && Clock::now() < *soundRenewed_ + kSoundLasts;
  soundRenewed_ = Clock::now();
  const bool isHeard = sound_ != nullptr;
  sound_.reset();
  audio_.reset();
  using Output = audio::AudioManager::Output;
  audio_ =
      std::make_unique<audio::AudioManager>(run_->settings.audio, wasRenewed ? Output::none : Output::device);
  if (isHeard) {
    sound_ = std::make_unique<audio::SoundScene>(*audio_, run_->settings.audio);
    sound_->setLightning(lightningOf(simulation_->effects(), run_->settings));
  }
  announce("the sound device is gone: " +
               (audio_->isSilent() ? audio_->status() : "sound goes on through " + audio_->status()),
           "The sound device is gone");
}

// From where the picture is seen: aboard the aircraft, beside a package that falls, or anywhere else, where
// one stands still as far as Doppler's effect is concerned.
audio::Listener WindowGame::listener(const game::Snapshot& snapshot, Size size) const {
  const bool rides = ride_.rides();
  const render::View view = sceneRenderer_->view(snapshot, size);
  audio::Listener listener{.position = view.position, .right = view.right()};
  listener.aboard =
      snapshot.aircraft.present && !rides && sceneRenderer_->camera().mode() != render::CameraMode::free;
  if (const game::PackageSnapshot* package = newestPackage(snapshot); rides && package && !package->landed)
    listener.velocity = package->velocity;
  return listener;
}

void WindowGame::hear(const game::Snapshot& snapshot, Size size) {
  audio_->setPaused(isPaused() || isFrozen());
  const audio::Listener ear = listener(snapshot, size);
  audio::Surroundings around;
  if (const auto& ground = simulation_->ground(); ground && run_->settings.audio.natureVolume > 0) {
    const double sunDegrees = glm::degrees(
        std::asin(render::directionToSun(run_->settings.render.sun, snapshot.simulatedSeconds).y));
    around = surroundings_.at(*ground, hasAlpineBelts(*ground), ear.position, sunDegrees,
                              glm::length(snapshot.wind), snapshot.simulatedSeconds);
  }
  sound_->update(snapshot, events_, ear, around);
}

}  // namespace skydrop::app
