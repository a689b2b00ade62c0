#include "skydrop/core/guard_watch.h"

namespace skydrop::core {

std::vector<FiredGuard> GuardWatch::look() {
  const GuardCounts counts = guardCounts();
  std::vector<FiredGuard> fired;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    // After a reset it counts from none.
    const std::uint64_t before = counts[i] < before_[i] ? 0 : before_[i];
    fired.push_back({static_cast<Guard>(i), counts[i] - before, counts[i]});
  }
  before_ = counts;
  return fired;
}

}  // namespace skydrop::core
