#pragma once

#include <array>

#include "skydrop/render/frame/pixel_box.h"
#include "skydrop/render/frame/view.h"

namespace skydrop::render {

// Whether a ball may be seen: not behind the eye, not beside the picture, and not smaller than a third of a
// pixel. Conservative: true for everything that covers a pixel's centre.
bool isPotentiallyVisible(const View& view, const glm::dvec3& middle, double radiusM);

// Whether a convex body with these corners, relative to the eye, may be seen: false where all of them lie
// behind the near plane, or beyond one side of the picture. A body beyond a corner may pass.
bool isPotentiallyVisible(const View& view, const std::array<glm::dvec3, 8>& corners);

// The least rise of a ray of the picture, a metre, where all rays rise; else not above 0. (Directions that
// rise by more than that are a convex cone, so the corners of the picture bound all that is between them.)
double leastRise(const View& view);

// The pixels that a box of a body may touch; all of them if a corner is not before the eye. toEye: body to
// eye-relative world axes.
PixelBox pixelsOf(const View& view, const glm::mat4& toEye, const glm::dvec3& low, const glm::dvec3& high);

}  // namespace skydrop::render
