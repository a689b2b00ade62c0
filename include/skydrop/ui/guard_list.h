// The guards of the processor (core/guards.h) that fired, in a corner of the picture: bright those of this
// frame, faint those of earlier ones. What the picture itself marks is the shading's (render::ToneMapPass).
// Drawn between Interface::beginFrame and endFrame, over everything, and takes no input. Main thread.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "skydrop/core/guard_watch.h"
#include "skydrop/ui/imgui_context.h"

namespace skydrop::ui {

struct GuardLine {
  std::string text;  // "stiffStep 3, 412 in all"
  bool isNow = false;
};

// A title, what the colours mean, and a line a guard. Pure.
std::vector<GuardLine> guardLines(std::span<const core::FiredGuard> fired);

void drawGuardList(const Interface& context, std::span<const GuardLine> lines);

}  // namespace skydrop::ui
