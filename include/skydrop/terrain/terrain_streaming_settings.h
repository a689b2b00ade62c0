// The knobs of streaming: how fine the drawn land is, how far it reaches, and what it may cost.
#pragma once

#include <cstdint>

#include "skydrop/core/settings.h"

namespace skydrop::terrain {

struct TerrainStreamingSettings {
  double viewDistanceM = 10000;
  double farDistanceM = 60000;
  double pixelError = 2;
  double cellPixels = 24;
  double texelPixels = 2;
  double seaFloorDepthM = 40;
  double cacheMiB = 128;
  double gpuMiB = 64;
  double uploadMiBPerFrame = 2;
  std::int64_t queueLimit = 64;
};

void describe(core::SettingsVisitor& visitor, TerrainStreamingSettings& settings);

}  // namespace skydrop::terrain
