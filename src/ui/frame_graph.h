// The times of the last frames as bars, with the marks that describe them.
#pragma once

#include <span>

namespace skydrop::ui {

// As wide as there is room: a bar a frame, a line at the median and one at the 99th of a hundred. Nothing
// without frames.
void drawFrameGraph(std::span<const double> frameMs);

}  // namespace skydrop::ui
