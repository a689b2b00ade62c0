// How finely the shadows of mountains are worked out. A value; any thread.
#pragma once

#include <array>
#include <string_view>

#include "skydrop/core/settings.h"
#include "skydrop/terrain/land_shade.h"

namespace skydrop::render {

enum class LandShadowDetail { coarse, medium, fine };
inline constexpr std::array<std::string_view, 3> kLandShadowDetailNames = {"coarse", "medium", "fine"};

struct LandShadowSettings {
  LandShadowDetail detail = LandShadowDetail::medium;  // texels near the eye: 32 m, 16 m, 8 m

  bool operator==(const LandShadowSettings&) const = default;
};

// All reach as far: 3.6 km with the finest level, 57 km with the coarsest.
terrain::ShadeLayout shadeLayout(const LandShadowSettings& settings);

void describe(core::SettingsVisitor& visitor, LandShadowSettings& settings);

}  // namespace skydrop::render
