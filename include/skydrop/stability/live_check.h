// Checks of hard cases that need neither a picture nor a file, so that the program can measure itself where
// it runs. The tests of the same rows call them (tests/stability); each takes less than half a second.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "skydrop/stability/limit.h"

namespace skydrop::stability {

struct LiveCheck {
  const char* id;    // of the row
  const char* what;  // is measured: "opacity of a step, in floats"
  const char* unit;
  Limit limit;
  double (*measure)();  // the worst figure of all inputs. Pure; any thread
};

std::span<const LiveCheck> liveChecks();
std::vector<LiveCheck> liveChecksOf(std::string_view id);

}  // namespace skydrop::stability
