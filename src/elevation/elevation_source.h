// makeElevationHeightSource with kernels of the caller's choice.
#pragma once

#include "elevation/surface_kernels.h"
#include "skydrop/elevation/elevation_height_source.h"

namespace skydrop::elevation {

std::shared_ptr<const ElevationHeightSource> makeElevationHeightSource(
    const std::vector<std::shared_ptr<const Raster>>& rasters, const ElevationSettings& settings,
    std::shared_ptr<const terrain::HeightSource> beyond, const SurfaceKernels& kernels);

}  // namespace skydrop::elevation
