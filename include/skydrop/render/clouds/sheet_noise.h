// The noise of cloud sheets as it goes to the GPU: made from settings on any thread, without OpenGL.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include "skydrop/clouds/cloud_dome_settings.h"
#include "skydrop/clouds/cloud_planes_settings.h"

namespace skydrop::render {

// Noise in [0, 1] as floats (filtered exactly by software renderers too; one channel), with all its mip
// levels: level 0 first, x fastest, each texel of a level the mean of those below it.
struct SheetNoise {
  int side = 0;
  bool isVolume = false;
  std::vector<std::vector<float>> levels;
  double mean = 0;    // of level 0
  double spread = 0;  // standard deviation of level 0
  // Standard deviation of level 0 within a texel of level i: what filtering takes away.
  std::vector<double> lost;
};

// 2D; empty (no levels) when it was stopped before. Throws core::RangeError for settings outside their
// ranges.
SheetNoise makeSheetNoise(const clouds::CloudPlaneSettings& settings, std::stop_token stop = {});
// A volume, level 0 alone. progress: 0 .. 1, called on this thread.
SheetNoise makeSheetNoise(const clouds::CloudDomeSettings& settings, std::stop_token stop = {},
                          std::function<void(double)> progress = {});

// What is prepared before the first frame (app's effect table), with the settings that it was made of. A
// layer that is not drawn has none.
struct PreparedPlaneNoise {
  std::array<clouds::CloudPlaneSettings, clouds::kCloudPlanes> settings;
  std::array<std::shared_ptr<const SheetNoise>, clouds::kCloudPlanes> layers;
};
struct PreparedDomeNoise {
  clouds::CloudDomeSettings settings;
  std::shared_ptr<const SheetNoise> volume;
};

}  // namespace skydrop::render
