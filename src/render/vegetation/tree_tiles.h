// The squares of the land in which trees may be seen.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "skydrop/core/shared_woods.h"
#include "skydrop/render/frame/view.h"
#include "skydrop/terrain/height_source.h"

namespace skydrop::render {

inline constexpr int kTileCells = 8;  // along a side, as in shaders/vegetation/place.comp
inline constexpr double kTileM = kTileCells * core::shared::f64::kTreeCellM;

struct TreeTiles {
  std::vector<glm::ivec2> corners;  // their north-west cells, counted from the base; the nearest first
  std::size_t near = 0;             // how many of them may hold a mesh
};

// Those that may hold a tree in view, not farther than reachM; meshes are not farther than meshM. base: as
// LandGround::base(). No square that shows a tree is missing where the land between it and the eye's foot is
// nowhere steeper than 45 degrees in the mean.
TreeTiles treeTiles(const View& view, const glm::dvec2& base, const terrain::HeightSource& ground,
                    double meshM, double reachM);

}  // namespace skydrop::render
