// The statistics section of the menu: what each pass of the frame costs.
#pragma once

#include <span>

#include "skydrop/core/frame_statistics.h"
#include "skydrop/core/settings_table.h"

namespace skydrop::ui {

// frameMs: of the last frames, the newest last. The table tells the budgets that memory is compared with.
void drawStatistics(const core::FrameStatistics& statistics, std::span<const double> frameMs,
                    const core::SettingsTable& table);

}  // namespace skydrop::ui
