// How many pixels of the picture share one evaluation of a cloud sheet's light: cloud planes and the cloud
// dome.
#pragma once

#include <array>
#include <string_view>

#include "skydrop/core/settings.h"

namespace skydrop::clouds {

// One for each pixel, for each 2 x 2 or for each 4 x 4; what lies between is mixed.
enum class SheetResolution { full, half, quarter };
inline constexpr std::array<std::string_view, 3> kSheetResolutionNames = {"full", "half", "quarter"};

// Pixels along a side: 1, 2 or 4.
constexpr int pixelsAlong(SheetResolution resolution) { return 1 << static_cast<int>(resolution); }

// The row "resolution".
void describeResolution(core::SettingsVisitor& visitor, SheetResolution& resolution);

}  // namespace skydrop::clouds
