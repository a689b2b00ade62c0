// How trees are drawn; where they stand is the land's (terrain/woods.h). A value; any thread.
#pragma once

#include <cstdint>

#include "skydrop/core/settings.h"

namespace skydrop::render {

struct VegetationSettings {
  double meshM = 130;  // up to this distance trees have meshes, m, [0, 400]
  double farM = 1200;  // and up to this one impostors, m, [0, 4000]; beyond, woods are painted on the land
  std::int64_t atlasTexels = 64;  // side of an impostor's view, texels, whole, [16, 128]
  std::int64_t atlasViews = 8;    // views along a side of the atlas, whole, [4, 12]
  double sway = 1;                // how much trees give way to the wind, [0, 3]
  double shadow = 1;              // how dark the ground is in their shadow, [0, 1]
  double shadowM =
      250;  // how far away single shadows are seen, m, [0, 1000]; beyond, woods are as dark in the mean

  bool operator==(const VegetationSettings&) const = default;
};

void describe(core::SettingsVisitor& visitor, VegetationSettings& settings);

}  // namespace skydrop::render
