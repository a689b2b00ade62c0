// What the split view says of the two pictures beside each other, and the divider, which can be dragged.
// Drawn between Interface::beginFrame and endFrame. Main thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "skydrop/ui/imgui_context.h"

namespace skydrop::ui {

struct SplitLabels {
  std::string left, right;  // titles of the two sides
  std::string note;         // the error, or how far the reference is
  double divider = 0.5;     // of the width, [0, 1]
  // Colours of the scale from 0 to 1 that the right side is drawn in, 0xAABBGGRR; empty: none is shown.
  std::vector<std::uint32_t> scale;
};

// Returns where the player has dragged the divider in this frame, [0, 1]; nothing where it was left alone.
std::optional<double> drawSplitLabels(const Interface& context, const SplitLabels& labels);

}  // namespace skydrop::ui
