#pragma once

namespace skydrop::core {

// For threads that work beside the one that draws, called on such a thread: a busy queue must not take the
// processor from the picture. Best effort; threads that it starts from now on inherit it.
void lowerThreadPriority();

}  // namespace skydrop::core
