// How far anvils spread from the towers of a weather map: its coverage, carried on from each place and losing
// an even part of it on the way (a dilation by a cone). An anvil with this in place of the coverage hangs
// together with a tower that is high enough for it, whatever the cover: a lower maximum beside has no anvil
// of its own.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

namespace skydrop::clouds {

// Of the map's coverage that a texel's way takes: with a weather map of 100 km an anvil reaches some 5 km.
inline constexpr float kAnvilLossATexel = 0.008f;

// A square map of a side, a power of two, that repeats: at each texel the largest coverage anywhere less the
// loss on the way there, within 3 % of the way (chamfer distances over 16 neighbours; Borgefors 1986). No
// less than the coverage itself. Values are finite. 40 ms for 512 texels.
std::vector<float> anvilReach(const std::vector<glm::vec3>& map, int side);

}  // namespace skydrop::clouds
