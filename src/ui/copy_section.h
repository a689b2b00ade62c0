// The section of the menu that hands settings and view to a command line.
#pragma once

#include <string>
#include <string_view>

#include "ui/menu_item.h"

namespace skydrop::ui {

// Each text in a field to copy from, where no clipboard exists, and a button that copies it.
void drawCopySection(const std::string& flags, std::string_view pose, ItemPlaces& places);

}  // namespace skydrop::ui
