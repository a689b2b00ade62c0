#include "skydrop/audio/thunder_schedule.h"

#include <glm/geometric.hpp>
#include <utility>

namespace skydrop::audio {
namespace {

// The slowest sound over the longest way.
constexpr double kLongestDelayS = 80;
// An aircraft that moves farther between two calls has been placed elsewhere, or is as fast as sound.
constexpr double kFastestMps = 300;

}  // namespace

// Takes over the flashes between two moments.
void ThunderSchedule::follow(const game::Snapshot& now, double from, double to) {
  const glm::dvec3& place = now.aircraft.position;
  for (const weather::Flash& flash :
       weather::flashesBetween(now.weather, settings_, from, to, {place.x, place.z})) {
    weather::Channel channel = weather::channelOf(flash, flash.toGround ? now.aircraft.groundHeight : -1e9);
    channel.pieces.clear();
    underWay_.push_back({flash, std::move(channel)});
  }
}

std::vector<weather::Clap> ThunderSchedule::due(const game::Snapshot& now) {
  std::vector<weather::Clap> claps;
  if (!now.weather || !now.aircraft.present) {
    last_.reset();
    return claps;
  }
  const Moment here{now.weather.seconds, now.aircraft.position};
  if (last_ && here.seconds == last_->seconds) return claps;  // held
  const std::optional<Moment> before = std::exchange(last_, here);
  const double step = before ? here.seconds - before->seconds : 0;
  if (!(step > 0 && step <= kLongestStepS) || glm::length(here.place - before->place) > kFastestMps * step) {
    underWay_.clear();
    follow(now, here.seconds - kLongestDelayS, here.seconds);
    return claps;
  }
  follow(now, before->seconds, here.seconds);
  std::erase_if(underWay_,
                [&](const UnderWay& sound) { return sound.flash.seconds < here.seconds - kLongestDelayS; });
  const double temperatureC = now.weather.at({here.place.x, here.place.z}).temperatureC;
  for (const UnderWay& sound : underWay_) {
    const weather::Claps then = weather::clapsOf(sound.flash, sound.channel, before->place, temperatureC);
    const weather::Claps current = weather::clapsOf(sound.flash, sound.channel, here.place, temperatureC);
    for (std::size_t i = 0; i < current.size(); ++i) {
      const bool wasHeard = before->seconds >= sound.flash.seconds + then[i].delayS;
      const bool isHeard = here.seconds >= sound.flash.seconds + current[i].delayS;
      if (isHeard && !wasHeard && current[i].gain > 0) claps.push_back(current[i]);
    }
  }
  return claps;
}

std::size_t thunderSound(const weather::Clap& clap) {
  return clap.dullness < 0.3 ? 0 : clap.dullness < 0.75 ? 1 : 2;
}

}  // namespace skydrop::audio
