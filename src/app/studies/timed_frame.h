// A frame of a sceneRenderer with what it took, for studies that compare pictures.
#pragma once

#include <string>

#include "app/session/scene_renderer.h"
#include "skydrop/core/image.h"

namespace skydrop::app {

struct TimedFrame {
  core::Image image;
  double ms = 0;
};

// Drawn with all its land there, then drawn `times` more: the median counts.
TimedFrame drawTimed(SceneRenderer& sceneRenderer, const game::Snapshot& snapshot, Size size, int times);
std::string clockOfTimedFrames(int times);  // for StudyCost::clock

// Root mean square of the difference over red, green and blue, in 8-bit steps.
double rootMeanSquare(const core::Image& a, const core::Image& b);

}  // namespace skydrop::app
