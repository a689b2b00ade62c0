// What is heard of a flash: claps from the parts of its channel, one after the other as far as they are away.
// Pure; any thread.
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "skydrop/weather/lightning.h"

namespace skydrop::weather {

// Speed of sound in dry air, m/s (ICAO 1993: sqrt(1.4 R T)): 340.3 at 15 degrees.
double speedOfSound(double temperatureC);

struct Clap {
  double delayS = 0;     // after the flash began
  double distanceM = 0;  // of that part of the channel
  double gain = 0;       // amplitude, [0, 1]: 1 at the channel, far off as 1 / distance
  double dullness = 0;   // [0, 1]: 0 a crack, 1 only the lowest frequencies are left
};
using Claps = std::array<Clap, Channel::kLights>;

// At a listener, under a temperature at the sea's level: the way is as warm as the standard atmosphere has it
// in its middle. In the order of the channel, not of time. Sound beyond about 20 km is bent upwards and not
// heard (Fleagle 1949): gain 0.
Claps clapsOf(const Flash& flash, const Channel& channel, const glm::dvec3& listener, double temperatureC);

}  // namespace skydrop::weather
