// What happened in a step, for sounds and tests: taken once with World::takeEvents.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace skydrop::game {

enum class GameEventKind {
  drop,             // a package left the aircraft
  parachuteOpened,  // its canopy began to fill
  packageLanded,    // it touched land or water (one of scored and missed follows where there was a target)
  scored,
  missed,
  packageRemoved,
  targetDrawn,
  crashed,  // the aircraft touched ground or water
  respawned,
  reset,
  touchedDown,  // wheels met the ground after a flight
  tookOff,      // and left it
  ditched,      // the aircraft swims; respawned follows
};

struct GameEvent {
  GameEventKind kind{};
  std::uint64_t step = 0;   // of the world when it had happened (World::stepCount), 1/120 s each
  glm::dvec3 position{0};   // world, m: of the package, target or aircraft
  std::uint32_t id = 0;     // of the package or target, 0 for the aircraft
  double missDistance = 0;  // scored, missed: horizontal, from the target's centre, m
  bool onWater = false;     // packageLanded, crashed
  double sinkRate = 0;      // touchedDown, ditched: into the ground or the water, m/s
};

}  // namespace skydrop::game
