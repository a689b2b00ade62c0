// How dust and spray are drawn. A value; any thread.
#pragma once

#include <cstdint>

#include "skydrop/core/settings.h"

namespace skydrop::render {

struct DustAndSpraySettings {
  double amount = 1;             // factor on what flies up, [0, 3]; 0: nothing, rings and wakes neither
  std::int64_t particles = 512;  // of a full burst, [16, 4096]; fewer are larger or denser
  double reachM = 2500;          // how far away bursts are drawn, m, [0, 10000]

  bool operator==(const DustAndSpraySettings&) const = default;
};

void describe(core::SettingsVisitor& visitor, DustAndSpraySettings& settings);

}  // namespace skydrop::render
