// What the aircraft and its packages throw up where they touch land or water: where, when, how hard, and of
// what ground. Derived from the flight for pictures alone: nothing of it decides the future of a flight, and
// none is part of its digest. Values; any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>

namespace skydrop::terrain {
class HeightSource;
}

namespace skydrop::game {

enum class BurstKind {
  package,    // a package that came down
  touchDown,  // wheels that met the ground after a flight
  rolling,    // a wheel on its way, once every few metres
  ditching,   // the hull as it met water
  swimming,   // the hull on its way through water, once every few metres
  crash,      // the end of a flight
  sliding,    // a wreck on its way
};

// How much of the ground flies up, and its colour.
struct LooseGround {
  double looseness = 0;        // [0, 1]: 0 rock that is swept clean .. 1 dry sand
  glm::dvec3 albedo{0, 0, 0};  // linear sRGB, [0, 1]
};

struct SurfaceBurst {
  std::uint32_t number = 0;  // counts the bursts of a flight from 1: the seed of what is thrown
  BurstKind kind{};
  double seconds = 0;          // simulated time at which it happened
  glm::dvec3 position{0};      // on the surface, world, m
  glm::dvec3 normal{0, 1, 0};  // of the surface, unit
  glm::dvec3 velocity{0};      // of what touched, just before, m/s
  glm::dvec3 wind{0};          // mean, near the surface, m/s
  bool onWater = false;
  LooseGround ground;  // on land
};

// The newest of a flight are kept, at most so many and so long (simulated seconds): the oldest go first.
inline constexpr std::size_t kMostBursts = 96;
inline constexpr double kBurstSeconds = 20;

// Of the land at a place, by what it is made of there (shaders/shared/land_material.glsl without noise finer
// than tens of metres): sand, meadow, litter of woods, scree, rock, snow; strips are turf, bare where wheels
// touch down. alpineBelts: as of terrain::forestShare. None beyond 1e12 m.
LooseGround looseGroundAt(const terrain::HeightSource& ground, const glm::dvec3& position, bool alpineBelts);

}  // namespace skydrop::game
