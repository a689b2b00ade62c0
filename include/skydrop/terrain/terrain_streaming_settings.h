// Streaming: how fine the drawn land is, how far it reaches, and what it may cost. Lengths on the picture are
// in pixels of the frame that is drawn. Plain values; describe() states and enforces the ranges.
// EndlessTerrain::apply takes a change over for its next update; a change of gpuMiB empties the GPU's chunks,
// which are sent again from the cache.
#pragma once

#include <cstdint>

#include "skydrop/core/settings.h"

namespace skydrop::terrain {

struct TerrainStreamingSettings {
  double viewDistanceM =
      10000;  // m, 1e3 .. 1e5: full accuracy up to here, beyond it tolerances grow with its root
  double farDistanceM = 60000;  // m, 5e3 .. 1e5: land ends here
  double pixelError = 2;   // .1 .. 20: height error of the mesh on the picture (Lindstrom and others, 1996)
  double cellPixels = 24;  // 1 .. 200: widest mesh cell, however smooth the land is
  double texelPixels = 2;  // .5 .. 16: widest sample of height and normal
  double seaFloorDepthM = 40;    // m, 0 .. 2000: deeper floor is not drawn
  double cacheMiB = 128;         // 8 .. 4096: of the processor's chunks; what is in view is never evicted
  double gpuMiB = 64;            // 8 .. 128: of the texture arrays, allocated at once
  double uploadMiBPerFrame = 2;  // .25 .. 128; one chunk a frame at least
  std::int64_t queueLimit = 64;  // chunks, 1 .. 1024, that may wait for a worker
};

void describe(core::SettingsVisitor& visitor, TerrainStreamingSettings& settings);

}  // namespace skydrop::terrain
