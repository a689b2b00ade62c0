// Keeps what was thrown up from land and water, after the rule of skydrop/game/surface_burst.h: found from
// the events of each step and the ways of wheels, hull and wreck. Reads the flight and decides nothing of it.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "game/flown_air.h"
#include "skydrop/game/events.h"
#include "skydrop/game/snapshot.h"
#include "skydrop/game/world.h"

namespace skydrop::game {

class SurfaceBursts {
 public:
  // Keeps both, which must outlive it; the setup may change between steps.
  SurfaceBursts(const WorldSetup& setup, const FlownAir& air) : setup_(&setup), air_(&air) {}

  // Once a step that ended at `seconds`: what happened in it, the state before it, and the aircraft after it
  // (none without). Nothing where the setup keeps no bursts.
  void step(double seconds, std::span<const GameEvent> events, const Snapshot& before,
            const AircraftSnapshot* aircraft);
  void clear();
  // Oldest first.
  const std::vector<SurfaceBurst>& all() const { return bursts_; }

 private:
  void record(BurstKind kind, const glm::dvec3& place, const glm::dvec3& velocity);
  void follow(const AircraftSnapshot& aircraft);

  const WorldSetup* setup_;
  const FlownAir* air_;
  double seconds_ = 0;
  std::uint32_t recorded_ = 0;
  std::vector<SurfaceBurst> bursts_;
  std::optional<glm::dvec3> lastOfWay_;  // where the way that is followed was last marked
};

}  // namespace skydrop::game
