// What a burst throws up, as clouds of hashed particles: the numbers that decide the looks of
// docs/spray.md. Pure functions.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "skydrop/game/surface_burst.h"
#include "skydrop/render/spray/dust_and_spray_settings.h"

namespace skydrop::render {

// SI units. See shaders/spray/particle.glsl.
struct BurstCloud {
  enum class Look { dust, drops };

  Look look = Look::dust;
  glm::dvec3 place{0};  // world
  glm::dvec3 up{0, 1, 0};
  std::uint32_t seed = 0;
  double age = 0;          // s since the first left
  double emitSeconds = 0;  // over which they leave
  double lifeSeconds = 1;  // of each
  double drag = 1, fall = 0;
  double outMps = 0, upMps = 0, randomMps = 0;
  double sourceM = 0;     // radius of where they leave
  glm::dvec3 carried{0};  // velocity that all have
  double sideways = 0;    // how much of what is thrown outwards goes to the sides of that, [0, 1]
  glm::dvec3 wind{0};
  double fromM = 0.1, toM = 0.1;  // radius of a particle at first and at its end
  double opacity = 1;
  double stretch = 1;  // drops: most of the length over the width
  glm::dvec3 albedo{0.8};
  double share = 1;    // of the settings' particles
  bool sinks = false;  // gone below the surface
  double reachM = 10;  // of any particle from the place, at this age; 0.. finite
};

// Those of a burst at a time that are not over. Empty for what is not finite (a place, velocity, normal or
// time that is no number) and before it happened.
std::vector<BurstCloud> cloudsOf(const game::SurfaceBurst& burst, double seconds, double amount);

// Rings and foam of a burst on water.
struct BurstWake {
  glm::dvec3 place{0};
  double age = 0;
  double radiusM = 1;  // of the body: waves are as long as its circumference and more
  double slope = 0;
  double foamM = 1, foam = 0;  // radius and cover
  double reachM = 10;          // of its waves by now
};
// None of one on land, of one that is over or before it happened, and of what is not finite.
std::optional<BurstWake> wakeOf(const game::SurfaceBurst& burst, double seconds, double amount);

}  // namespace skydrop::render
