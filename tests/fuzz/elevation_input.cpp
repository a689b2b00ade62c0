#include "fuzz/elevation_input.h"

#include <cmath>

#include "skydrop/elevation/projection.h"
#include "skydrop/elevation/raster.h"
#include "skydrop/elevation/survey.h"

namespace skydrop::fuzz {

void readElevation(const std::string& name, const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kMostLookedAt = std::size_t{1} << 22;  // of a larger one a corner
  const std::filesystem::path file = inputFile(name, data, size);
  accepts(std::filesystem::path(name).stem().string(), [&] {
    const auto raster = elevation::openRaster(file);
    const auto width = static_cast<std::size_t>(raster->width());
    if (width * static_cast<std::size_t>(raster->height()) <= kMostLookedAt) {
      const elevation::Survey survey(*raster);
      require(std::isfinite(survey.mean()), "the mean is finite");
      require(survey.all().lowest >= elevation::kLowestHeight, "the lowest height is one of the earth");
      require(survey.all().highest <= elevation::kHighestHeight, "the highest height is one of the earth");
    } else {
      std::vector<float> row(width);
      raster->read(0, raster->height() - 1, raster->width(), 1, row.data());
    }
    const elevation::Projection projection(raster->georeference().crs, raster->name());
  });
}

}  // namespace skydrop::fuzz
