// What the GPU knows of villages and roads around the eye, packed for shaders/terrain/places.glsl.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "skydrop/terrain/places.h"

namespace skydrop::render {

inline constexpr int kPlaceCells = 5;       // along a side of the map
inline constexpr int kPlaceGridSide = 300;  // in squares of 32 m
inline constexpr double kPlaceGridM = 32;
inline constexpr int kPlaceRow = 256, kPlaceRows = 256;  // texels of the data
inline constexpr std::size_t kVillageTexels = 6, kMostVillages = 80;
static_assert(kPlaceGridSide * kPlaceGridM == kPlaceCells * terrain::kPlaceCellM);

// A building as the GPU draws it, positions from the map's corner.
struct PlacedPart {
  float x = 0, z = 0, footM = 0, skirtM = 0;        // footM: above the sea, on the exact land
  float width = 0, length = 0, wall = 0, roof = 0;  // m
  float alongX = 1, alongZ = 0, ridge = 1,
        landM = 0;  // landM: exact height of the land at the middle; -1e9: its own
  std::uint32_t bits = 0, use = 0, spare0 = 0, spare1 = 0;
};

struct PlaceMapData {
  glm::dvec2 corner{0};
  std::vector<std::array<std::uint32_t, 2>> grid;  // kPlaceGridSide squared
  std::vector<std::array<std::uint32_t, 4>> data;  // kPlaceRow x kPlaceRows
  std::vector<PlacedPart> parts;
  std::vector<glm::dvec2> villages;  // their middles, world; the first of the data, kVillageTexels each
};

// The map whose middle cell is the one of the place.
PlaceMapData placeMapData(const terrain::Places& places, std::int64_t cellX, std::int64_t cellZ);

}  // namespace skydrop::render
