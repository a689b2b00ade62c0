// The land as a function of position: what chunks are made of, and what collision, target placing and the
// autopilot ask without any cache. Sea level is height 0; a height below it is sea floor.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <stop_token>
#include <vector>

#include "skydrop/terrain/chunk_key.h"
#include "skydrop/terrain/height_range.h"

namespace skydrop::terrain {

struct ChunkData;
class Strips;

struct HeightSample {
  double height = 0;              // metres above sea level
  glm::dvec2 gradient{0.0, 0.0};  // dh/dx (east), dh/dz (south), metres a metre
};

// Unit normal of a surface with this gradient: (-dh/dx, 1, -dh/dz) normalised.
glm::dvec3 normalOf(const HeightSample& sample);

struct HeightBounds {
  double lowest = 0, highest = 0;  // metres
};

// Immutable once built, so every function may be called from any thread. Positions are world metres as
// (x, z); beyond kWorldLimitMetres, and for what is not finite, the answer is that of the nearest position
// inside (0 for NaN): callers check what matters to them.
class HeightSource {
 public:
  virtual ~HeightSource() = default;

  // Height and analytic gradient at a point.
  virtual HeightSample sample(glm::dvec2 xz) const = 0;
  double height(glm::dvec2 xz) const { return sample(xz).height; }

  // Conservative bounds of the height over the rectangle lo..hi (lo <= hi): every sample lies inside, but the
  // bounds need not be reached. Made for culling before a chunk exists.
  virtual HeightBounds bounds(glm::dvec2 lo, glm::dvec2 hi) const = 0;

  // Bounds of the whole world.
  virtual HeightBounds range() const = 0;

  // What its chunks store: the same at every call, and wide enough for range(), or heights are cut off there.
  // A wider one has coarser steps.
  virtual HeightRange storedRange() const { return {}; }

  // Fills heights (coded over out.heightRange, which is storedRange()) and normals of the chunk
  // (chunk_data.h), which have their full size already. Returns false, with part of the samples undefined, if
  // a stop was requested meanwhile. The default asks sample() for each of the 58 081 positions and those
  // around them; a source that knows better overrides it. A position has the same normal in every chunk of a
  // level that holds it, or a border would show. A level above 0 may smooth its normals, as its samples carry
  // less detail, but not its heights: a position that two levels share has the same code in both, or their
  // meshes would not meet.
  virtual bool fillChunk(const ChunkKey& key, std::stop_token stop, ChunkData& out) const;

  // The same, and codes of the heights as far as normals reach: rows of kChunkSamples + 2 normalReach(level)
  // from -normalReach(level) on. For lands that are made of others. The default asks sample() for those
  // beyond the chunk.
  virtual bool fillWideChunk(const ChunkKey& key, std::stop_token stop, ChunkData& out,
                             std::vector<std::uint16_t>& wideHeights) const;

  // The grass strips of this land (strips.h), which live as long as it; null where it has none.
  virtual const Strips* strips() const { return nullptr; }
};

}  // namespace skydrop::terrain
