// When thunder is heard: the claps of the weather's flashes, as their sound reaches the aircraft. Needs no
// sound device. A value; any thread.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "skydrop/game/snapshot.h"
#include "skydrop/weather/thunder.h"

namespace skydrop::audio {

class ThunderSchedule {
 public:
  explicit ThunderSchedule(const weather::LightningSettings& settings) : settings_(settings) {}

  void apply(const weather::LightningSettings& settings) { settings_ = settings; }

  // The claps whose sound has reached the aircraft since the last call, in the order of their flashes: each
  // is due once, however the aircraft moves below the speed of sound. A flash is heard where it was within
  // sight as it began. None at the first call, after a jump of more than kLongestStepS, back in time or to
  // another place, while time is held, and without weather or aircraft; after a jump the thunder that is
  // under way is that of the flashes around the new place.
  std::vector<weather::Clap> due(const game::Snapshot& now);

  static constexpr double kLongestStepS = 2;

 private:
  struct Moment {
    double seconds = 0;
    glm::dvec3 place{0};
  };
  struct UnderWay {
    weather::Flash flash;
    weather::Channel channel;  // without its pieces
  };
  void follow(const game::Snapshot& now, double from, double to);

  weather::LightningSettings settings_;
  std::optional<Moment> last_;
  std::vector<UnderWay> underWay_;  // flashes of the last kLongestDelayS
};

// Which of the three sounds of thunder a clap is: 0 a crack near by, 1, 2 far off.
std::size_t thunderSound(const weather::Clap& clap);

}  // namespace skydrop::audio
