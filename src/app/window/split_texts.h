// What is said of the split view: on the picture, and in a line of the headless program.
#pragma once

#include <string>

#include "app/session/split_view.h"
#include "skydrop/ui/split_labels.h"

namespace skydrop::app {

ui::SplitLabels splitLabels(const SplitView& split, const SplitSettings& settings);

// "split clouds=reference: RMSE 0.0123 (4.5 % of the mean), mean FLIP 0.021"
std::string splitLine(const core::SplitStatistics& split);

}  // namespace skydrop::app
