#pragma once

#include "skydrop/render/view.h"

namespace skydrop::render {

// Whether a ball may be seen: not behind the eye, not beside the picture, and not smaller than a third of a
// pixel. Conservative: true for everything that covers a pixel's centre.
bool maySee(const View& view, const glm::dvec3& middle, double radiusM);

}  // namespace skydrop::render
