// Land from elevation files, and beyond them another land.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "skydrop/elevation/elevation_settings.h"
#include "skydrop/elevation/projection.h"
#include "skydrop/elevation/raster.h"
#include "skydrop/terrain/height_source.h"

namespace skydrop::elevation {

// What the files add up to.
struct ElevationFacts {
  std::size_t tiles = 0;
  std::size_t cells = 0, voids = 0;
  double lowest = 0, highest = 0;  // m, of the heights in the files
  double raisedM = 0;              // by which the land around is lifted to them
};

class ElevationHeightSource : public terrain::HeightSource {
 public:
  virtual ElevationFacts facts() const = 0;
  // Whether the height at a position of the world is that of the data alone.
  virtual bool hasData(glm::dvec2 xz) const = 0;
  // Bytes of cells that it keeps in memory; and how often a file could not be read since the start.
  virtual std::size_t keptBytes() const = 0;
  virtual std::uint64_t faults() const = 0;
};

// A bicubic surface (Catmull and Rom, C1) through the cells, in the order of the files: the first that has a
// height at a place has the say, a finer raster before a coarser one. Voids are filled (survey.h). Beyond the
// data it turns into `beyond`, lifted by whole metres to the mean of the data's edges where that lies above.
// At least one raster. Reads each raster once. The settings' place counts, whatever atCentre says. Throws
// core::DataError, core::RangeError.
std::shared_ptr<const ElevationHeightSource> makeElevationHeightSource(
    const std::vector<std::shared_ptr<const Raster>>& rasters, const ElevationSettings& settings,
    std::shared_ptr<const terrain::HeightSource> beyond);

}  // namespace skydrop::elevation
