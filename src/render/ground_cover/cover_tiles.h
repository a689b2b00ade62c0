// The squares of the land in which grass, stones and reeds may be seen.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "skydrop/core/shared_ground_cover.h"
#include "skydrop/render/frame/view.h"
#include "skydrop/terrain/height_source.h"

namespace skydrop::render {

inline constexpr int kCoverTileCells = 8;  // along a side, as in shaders/ground_cover/place.comp
inline constexpr std::size_t kCoverLevels = core::shared::f64::kCoverLevels;

using CoverReaches = std::array<double, kCoverLevels>;  // of the lattices, m

// By the settings reachM (m) and density.
CoverReaches coverReaches(double reachM, double density);

// Their north-west cells, counted from the base, and their lattice (z): those that may show something, from
// wherever it is no farther than its lattice reaches; the nearest first in each lattice. base: as
// LandGround::base(). None is missing where the land within a square is nowhere steeper than 60 degrees in
// the mean from its middle. At most mostCoverTiles.
std::vector<glm::ivec4> coverTiles(const View& view, const glm::dvec2& base,
                                   const terrain::HeightSource& ground, const CoverReaches& reaches);

// More than coverTiles() returns from anywhere.
std::size_t mostCoverTiles(const CoverReaches& reaches);

}  // namespace skydrop::render
