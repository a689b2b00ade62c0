// Where a cloud layer can hold cloud at all: a coarse, conservative picture of the whole field, which repeats
// with the weather map. Rays leap over what is empty; where nothing is occupied nothing is drawn. Immutable;
// any thread.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "skydrop/clouds/cloud_field.h"

namespace skydrop::clouds {

class Occupancy {
 public:
  static constexpr int kSide = 256;     // cells of a weather period, east and south
  static constexpr int kRows = 16;      // from the base of the layer to its top
  static constexpr int kFarthest = 15;  // distances are counted up to this

  // Of one of the settings' layers, below kCloudLayers (std::out_of_range). Takes 20 ms for the default
  // settings, 16 to 24 ms for others that have cloud (time of the thread, median of 41, -O2, one core of a
  // shared AMD EPYC). Conservative for lookups in 32 bits and for filters that know 1/256 of a texel.
  Occupancy(const PackedCloudNoise& noise, const CloudSettings& settings, std::size_t layer = 0);
  // Conservative too for every layer of less cover whose base and top are no more than so many metres from
  // those of the medium: rows are then counted between the base and the top that it has.
  Occupancy(const PackedCloudNoise& noise, const LayerMedium& medium, double heightSlackM = 0);

  bool isEmpty() const { return occupied_ == 0; }
  double occupiedShare() const { return static_cast<double>(occupied_) / (kSide * kSide * kRows); }

  // How many cells, along the axis that needs most, lie between a cell and the nearest occupied one: 0 is
  // occupied itself; with d all cells nearer than d in every axis are empty. East and south wrap around;
  // there is nothing below the lowest row and above the highest. Order: x fastest, then row, then z.
  std::span<const std::uint8_t> distances() const { return distances_; }
  // The cell's column wraps; its row has to be in [0, kRows).
  int distance(const glm::ivec3& cell) const;  // x, row, z

  // The cell of a place in the field (drift taken off), the row unclamped: outside [0, kRows) there is no
  // cloud.
  glm::ivec3 cellOf(const glm::dvec3& place) const;

 private:
  double baseM_, thicknessM_, periodM_;  // of the layer and of its weather map
  std::vector<std::uint8_t> distances_;
  std::int64_t occupied_ = 0;
};

}  // namespace skydrop::clouds
