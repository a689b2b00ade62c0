// Where the next target lies. A pure function of the ground, a point and a random stream.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "skydrop/core/hash.h"
#include "skydrop/game/game_settings.h"
#include "skydrop/terrain/height_source.h"

namespace skydrop::game {

// A point on land, its slope under targetSlopeDeg and its disc dry, targetNearest to targetFarthest from
// `around` (m, horizontal; even over the area). Where the draws find none the ring grows outward
// (Guard::targetWidened); empty when there is no land within 38 times the farthest distance.
std::optional<glm::dvec3> drawTarget(const terrain::HeightSource& ground, const glm::dvec3& around,
                                     const GameSettings& settings, core::RandomStream& random);

}  // namespace skydrop::game
