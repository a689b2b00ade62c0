// Villages of the land: houses, the fields around, streets, roads between neighbours, tracks, jetties,
// bridges.
//
// The world is cut into cells of kPlaceCellM; each has one village or none. Where it lies is hashed from the
// cell, in a few tries: of those whose ground is gentle the gentlest is taken. All else is laid out from
// there by hash and by the exact land: houses along streets, never on ground steeper than kMostHouseSlope, in
// the sea or beside a grass strip; blocks of fields where all of a block is gentle; a road to each neighbour,
// bent around what is steep, and none where the best way still is steeper than kMostGrade. Pure functions of
// the cell and the land. No libm function but sqrt: the same bits everywhere. Immutable: any thread; what has
// been found is remembered.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <mutex>
#include <optional>
#include <shared_mutex>
#include <span>
#include <unordered_map>
#include <vector>

#include "skydrop/core/shared_places.h"
#include "skydrop/terrain/height_source.h"
#include "skydrop/terrain/places_settings.h"
#include "skydrop/terrain/strips.h"

namespace skydrop::terrain {

inline constexpr double kPlaceCellM = 1920;
inline constexpr double kMostHouseSlope = 0.22;  // m a metre, below a house
inline constexpr double kMostFieldSlope = 0.24;  // anywhere in a block of fields, as far as it is looked at
inline constexpr double kMostGrade = 0.15;       // along a road
inline constexpr double kMostCrossfall = 0.40;   // across it
inline constexpr double kTallestHouseM = 26;     // over the land below: steeples
inline constexpr double kLongestBridgeM = 130;

enum class WayKind : std::int32_t { street, road, track };  // kStreet .. of shaders/shared/places.glsl

// A straight piece of a way, world (x, z), m.
struct WayPiece {
  glm::dvec2 from{0}, to{0};
  WayKind kind = WayKind::street;
};

// A building, or a part of one: walls around a rectangle, a roof over it.
struct HousePart {
  glm::dvec3 foot{0};      // of the middle, world, m: where its walls begin
  glm::dvec2 along{1, 0};  // unit: the ridge's way
  core::shared::f64::House shape{};
  double landM = 0;          // height of the land below the middle, m
  double skirtM = 0;         // how far walls go on below
  std::int32_t use = 0;      // kDwelling .. of shaders/shared/places.glsl
  std::uint32_t bits = 0;    // its own: colours, windows
  bool standsOnLand = true;  // false: at its height, whatever the land is (decks)
};

struct Village {
  glm::dvec2 middle{0};    // world, m
  glm::dvec2 along{1, 0};  // unit: its main street's way, which its fields follow
  std::uint32_t bits = 0;
  // Kinds of its blocks, two bits each: a row of columns (along) to a number, rows to the right.
  std::array<std::uint32_t, core::shared::f64::kFieldBlocks> blocks{};
  std::vector<WayPiece> ways;                  // streets and tracks
  std::vector<HousePart> parts;                // of buildings and jetties
  std::array<glm::dvec2, 2> ends{}, before{};  // of the main street, and a point of it before

  // Metres along and to the right of the middle.
  glm::dvec2 local(const glm::dvec2& xz) const {
    const glm::dvec2 d = xz - middle;
    return {d.x * along.x + d.y * along.y, d.y * along.x - d.x * along.y};
  }
  glm::dvec2 world(const glm::dvec2& local) const {
    return middle + along * local.x + glm::dvec2(-along.y, along.x) * local.y;
  }
  // kNoBlock .. of shaders/shared/places.glsl at a place in blocks (blocksOf).
  int blockAt(const glm::dvec2& inBlocks) const;
};

struct Road {
  std::vector<WayPiece> pieces;  // empty: none
  std::vector<HousePart> decks;  // of its bridges
};

// The villages and roads that may reach into a square.
struct PlacesAround {
  std::vector<std::shared_ptr<const Village>> villages;
  std::vector<std::shared_ptr<const Road>> roads;

  // No tree stands there: fields, gardens, ways and what is beside them.
  bool isSettled(const glm::dvec2& xz) const;
};

class Places {
 public:
  Places(std::shared_ptr<const HeightSource> ground, const PlacesSettings& settings);

  const HeightSource& ground() const { return *ground_; }
  const PlacesSettings& settings() const { return settings_; }

  // Null: the cell has none. Cells beyond the world have none. The first look costs about 1 ms.
  std::shared_ptr<const Village> village(std::int64_t cellX, std::int64_t cellZ) const;
  // From the village of a cell to that of the neighbour: 0 east, 1 south, 2 south-east, 3 south-west. Never
  // null.
  std::shared_ptr<const Road> road(std::int64_t cellX, std::int64_t cellZ, int direction) const;

  // What reaches into a square around a place, of half its side (m, at most 20 000); nothing beyond the world
  // or for what is not finite.
  PlacesAround around(const glm::dvec2& xz, double halfSideM) const;

  // The nearest village within so many cells (rings around the place's own), if there is one.
  std::shared_ptr<const Village> nearest(const glm::dvec2& xz, int rings) const;

  // A building within reachM (m) of one of the points, which are within 20 m of the first. Points higher than
  // kTallestHouseM over the land cost one height.
  std::optional<HousePart> touching(std::span<const glm::dvec3> points, double reachM) const;

 private:
  struct Key {
    std::int64_t x = 0, z = 0;
    int direction = 0;
    bool operator==(const Key&) const = default;
  };
  struct KeyHash {
    std::size_t operator()(const Key& key) const;
  };

  std::shared_ptr<const HeightSource> ground_;
  PlacesSettings settings_;
  mutable std::shared_mutex mutex_;
  mutable std::unordered_map<Key, std::shared_ptr<const Village>, KeyHash> villages_;
  mutable std::unordered_map<Key, std::shared_ptr<const Road>, KeyHash> roads_;
};

}  // namespace skydrop::terrain
