// Which guards fired since somebody looked last: what a debug view shows of each frame. One thread; other
// watches and resetGuardCounts() do not disturb it, but for what fired between a reset and the next look.
#pragma once

#include <vector>

#include "skydrop/core/guards.h"

namespace skydrop::core {

struct FiredGuard {
  Guard guard;
  std::uint64_t now = 0;  // times since the last look
  std::uint64_t all = 0;  // since the program started

  bool operator==(const FiredGuard&) const = default;
};

class GuardWatch {
 public:
  // Those that have ever fired, in the order of Guard. The first look takes all counts as new.
  std::vector<FiredGuard> look();

 private:
  GuardCounts before_{};
};

}  // namespace skydrop::core
