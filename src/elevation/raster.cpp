#include "skydrop/elevation/raster.h"

#include <cmath>

#include "skydrop/core/error.h"

namespace skydrop::elevation {

using core::DataError;

Raster::Raster(std::string name, std::string form, int width, int height, Georeference georeference)
    : name_(std::move(name)),
      form_(std::move(form)),
      width_(width),
      height_(height),
      georeference_(std::move(georeference)) {
  if (width < 1 || height < 1 || width > kMostSide || height > kMostSide ||
      static_cast<std::size_t>(width) * static_cast<std::size_t>(height) > kMostCells)
    throw DataError(name_, "size",
                    std::to_string(width) + " x " + std::to_string(height) + " cells: must be 1 to " +
                        std::to_string(kMostSide) + " a side and at most 2^30");
  const glm::dvec2 first = georeference_.first, cell = georeference_.cell;
  const auto isUsable = [](double value) { return std::isfinite(value) && std::abs(value) < 1e9; };
  if (!isUsable(first.x) || !isUsable(first.y) || !isUsable(cell.x) || !isUsable(cell.y) || cell.x < 1e-9 ||
      cell.y < 1e-9)
    throw DataError(name_, "georeference", "the cells lie nowhere on the earth or have no size");
}

}  // namespace skydrop::elevation
