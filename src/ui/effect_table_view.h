// The section of the effects: a switch for each, whether it is on, idle or off, and what it costs.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "skydrop/core/frame_statistics.h"
#include "skydrop/core/settings_table.h"
#include "skydrop/ui/menu.h"

namespace skydrop::ui {

// The settings group whose rows are the switches of the effects.
inline constexpr std::string_view kEffectsGroup = "effects";

// A row for each of the fields, which are flags; the bill names them by the last part of their paths. Puts
// the places of the switches into `places`. The field that was switched in this frame, if any; sets nothing.
const core::Field* drawEffectTable(std::span<const core::Field* const> fields,
                                   const core::FrameStatistics* statistics,
                                   std::map<std::string, MenuRowPlace>& places);

}  // namespace skydrop::ui
