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

std::vector<weather::Clap> ThunderSchedule::due(const game::Snapshot& now) {
  std::vector<weather::Clap> claps;
  if (!now.weather || !now.aircraft.present) {
    last_.reset();
    return claps;
  }
  const Heard here{now.weather.seconds, now.aircraft.position};
  const std::optional<Heard> before = std::exchange(last_, here);
  const double step = before ? here.seconds - before->seconds : 0;
  if (!(step > 0 && step <= kLongestStepS)) return claps;
  if (glm::length(here.place - before->place) > kFastestMps * step) return claps;
  const glm::dvec2 level(here.place.x, here.place.z);
  const double temperatureC = now.weather.at(level).temperatureC;
  for (const weather::Flash& flash :
       weather::flashesBetween(now.weather, settings_, here.seconds - kLongestDelayS, here.seconds, level)) {
    const weather::Channel channel =
        weather::channelOf(flash, flash.toGround ? now.aircraft.groundHeight : -1e9);
    const weather::Claps then = weather::clapsOf(flash, channel, before->place, temperatureC);
    const weather::Claps current = weather::clapsOf(flash, channel, here.place, temperatureC);
    for (std::size_t i = 0; i < current.size(); ++i) {
      const bool wasHeard = before->seconds >= flash.seconds + then[i].delayS;
      const bool isHeard = here.seconds >= flash.seconds + current[i].delayS;
      if (isHeard && !wasHeard && current[i].gain > 0) claps.push_back(current[i]);
    }
  }
  return claps;
}

std::size_t thunderSound(const weather::Clap& clap) {
  return clap.dullness < 0.3 ? 0 : clap.dullness < 0.75 ? 1 : 2;
}

}  // namespace skydrop::audio
