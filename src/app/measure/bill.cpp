#include "app/measure/bill.h"

#include <algorithm>

namespace skydrop::app {

core::EffectStatistics& billRow(core::FrameStatistics& statistics, std::string_view name) {
  const auto found = std::ranges::find(statistics.bill, name, &core::EffectStatistics::name);
  if (found != statistics.bill.end()) return *found;
  core::EffectStatistics row;
  row.name = name;
  statistics.bill.push_back(row);
  return statistics.bill.back();
}

double paidMs(const core::FrameStatistics& statistics) {
  constexpr double kFramesPerSecond = 60;
  double ms = 0;
  for (const core::EffectStatistics& row : statistics.bill)
    ms += row.ms + row.updateMs + row.simulationMs / kFramesPerSecond;
  return ms;
}

}  // namespace skydrop::app
