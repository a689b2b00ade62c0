// How finely the shadows of mountains are worked out. A value; any thread.
#pragma once

#include <array>
#include <string_view>

#include "skydrop/core/settings.h"
#include "skydrop/terrain/land_shade.h"

namespace skydrop::render {

enum class LandShadowDetail { coarse, medium, fine, finest };
inline constexpr std::array<std::string_view, 4> kLandShadowDetailNames = {"coarse", "medium", "fine",
                                                                           "finest"};

struct LandShadowSettings {
  LandShadowDetail detail = LandShadowDetail::medium;  // texels near the eye: 32, 16, 8, 4 m

  bool operator==(const LandShadowSettings&) const = default;
};

// All reach about as far: 3 to 4 km with the finest level, 49 to 64 km with the coarsest.
terrain::ShadeLayout shadeLayout(const LandShadowSettings& settings);

void describe(core::SettingsVisitor& visitor, LandShadowSettings& settings);

}  // namespace skydrop::render
