// How finely shade in the air is marched. A value; any thread.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "skydrop/core/settings.h"

namespace skydrop::render {

enum class LightShaftResolution { full, half, quarter };
inline constexpr std::array<std::string_view, 3> kLightShaftResolutionNames = {"full", "half", "quarter"};

struct LightShaftSettings {
  LightShaftResolution resolution = LightShaftResolution::quarter;  // of the picture's width and height
  std::int64_t steps = 16;                                          // along a ray, [2, 1024]
  double distanceM = 24'000;  // on the level from the eye, up to which shade counts, m, [1000, 60000]

  bool operator==(const LightShaftSettings&) const = default;
};

// Pixels between two rays: 1, 2, 4.
int spacingOf(const LightShaftSettings& settings);

void describe(core::SettingsVisitor& visitor, LightShaftSettings& settings);

}  // namespace skydrop::render
