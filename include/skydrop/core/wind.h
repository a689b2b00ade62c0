// The wind: the same everywhere and at any time, for the drift of the clouds and for what flies. A value; any
// thread. Deterministic: the same bits on every machine.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "skydrop/core/settings.h"

namespace skydrop::core {

struct WindSettings {
  double speed = 8;            // m/s, [0, 60]
  double direction = 250;      // degrees by compass where it comes from, as in a weather report, [0, 360]
  bool movesAircraft = false;  // off: aircraft and packages move through still air
};

void describe(SettingsVisitor& visitor, WindSettings& settings);

// How far the wind carries what drifts with it, metres in x (east) and z (south), after so many seconds.
glm::dvec2 windDrift(const WindSettings& settings, double seconds);

// The velocity (m/s, world axes) of the air that aircraft and packages move through; 0 unless it moves them.
glm::dvec3 flownWind(const WindSettings& settings);

}  // namespace skydrop::core
