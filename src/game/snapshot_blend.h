// A moment between two steps, for pictures that are drawn between them.
#pragma once

#include "skydrop/game/snapshot.h"

namespace skydrop::game {

// share 0 is `before`, 1 is `now`, clamped (not finite: 1). What was placed again between the two is at
// `now`.
Snapshot blended(const Snapshot& before, const Snapshot& now, double share);

}  // namespace skydrop::game
