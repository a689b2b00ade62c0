// What is shown until the first frame of the game: name, what is being done, a bar. Drawn between
// Interface::beginFrame and endFrame. Main thread.
#pragma once

#include <string>

#include "skydrop/ui/imgui_context.h"

namespace skydrop::ui {

struct LoadingProgress {
  std::string what;  // "Making the land: 12 of 40"
  double share = 0;  // done, 0 .. 1
};

void drawLoadingPicture(const Interface& context, const LoadingProgress& progress);

}  // namespace skydrop::ui
