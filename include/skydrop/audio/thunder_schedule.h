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
  // is due once, however the aircraft moves below the speed of sound. None at the first call, after a jump of
  // more than kLongestStepS or back in time, while time is held, and without weather or aircraft.
  std::vector<weather::Clap> due(const game::Snapshot& now);

  static constexpr double kLongestStepS = 2;

 private:
  struct Heard {
    double seconds = 0;
    glm::dvec3 place{0};
  };
  weather::LightningSettings settings_;
  std::optional<Heard> last_;
};

// Which of the three sounds of thunder a clap is: 0 a crack near by, 1, 2 far off.
std::size_t thunderSound(const weather::Clap& clap);

}  // namespace skydrop::audio
