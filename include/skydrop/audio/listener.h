// Who hears a flight, and how a sound reaches who is not aboard: later, quieter, higher or lower, from a
// side.
#pragma once

#include <glm/vec3.hpp>

namespace skydrop::audio {

struct Listener {
  // Rides the aircraft, in the cabin or close behind it: its engine is heard as it is.
  bool aboard = true;
  glm::dvec3 position{0};     // world, m
  glm::dvec3 velocity{0};     // m/s; 0 for one who stands or looks about
  glm::dvec3 right{1, 0, 0};  // unit, where the right ear is
};

// How a sound arrives.
struct Arrival {
  double seconds = 0;  // ago that it left, >= 0
  double gain = 1;     // [0, 1]: 1 within kFullGainM, then inverse to the distance, less what the air takes
  double pitch = 1;    // [0.5, 2], Doppler
  double pan = 0;      // from which side: -1 left .. 1 right
};

inline constexpr double kFullGainM = 12;
inline constexpr double kSoundMps = 340.3;  // at 15 degrees Celsius (ICAO 1993)

// From a source that flies straight on, m and m/s. It is heard where it was when the sound left: that place,
// and the pitch by both speeds along the way from there (Doppler 1842; retarded time by the closed form of a
// quadratic). Speeds above .95 of that of sound count as that. What is more than 30 km away, and a place or
// speed that is not finite, is not heard (gain 0).
Arrival arrivalFrom(const glm::dvec3& source, const glm::dvec3& velocity, const Listener& listener);

}  // namespace skydrop::audio
