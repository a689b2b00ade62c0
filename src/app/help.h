#pragma once

#include <vector>

#include "skydrop/ui/hud.h"

namespace skydrop::app {

// The rows of the help overlay, from the key map.
std::vector<ui::HelpRow> helpRows();

}  // namespace skydrop::app
