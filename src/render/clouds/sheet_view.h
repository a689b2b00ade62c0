// Which rays of a picture meet a sheet of clouds.
#pragma once

#include "skydrop/render/frame/view.h"

namespace skydrop::render {

// The largest sine of the elevation of a ray of the picture: 1 where the zenith is in view.
double steepestUp(const View& view);
// Likewise downwards: 1 where the nadir is in view.
double steepestDown(const View& view);
// Whether no ray of the picture meets the level plane of a height within a radius around the eye (m).
bool missesLevelPlane(const View& view, double heightM, double radiusM);

}  // namespace skydrop::render
