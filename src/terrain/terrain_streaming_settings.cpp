#include "skydrop/terrain/terrain_streaming_settings.h"

namespace skydrop::terrain {

void describe(core::SettingsVisitor& visitor, TerrainStreamingSettings& settings) {
  using core::TakesEffect;
  visitor.number(
      "viewDistanceM", settings.viewDistanceM,
      {"m", 1000, 100000,
       "Land up to this distance is drawn at full accuracy; beyond it the tolerances grow with the "
       "square root of the distance.",
       TakesEffect::live, true});
  visitor.number("farDistanceM", settings.farDistanceM,
                 {"m", 5000, 100000, "Land ends here, faded into the haze.", TakesEffect::live, true});
  visitor.number(
      "pixelError", settings.pixelError,
      {"pixel", 0.1, 20,
       "Height error of the mesh that is allowed on the picture, reached at 5 % of the land; larger is "
       "coarser and faster.",
       TakesEffect::live, true});
  visitor.number("cellPixels", settings.cellPixels,
                 {"pixel", 1, 200, "Largest width of a mesh cell on the picture, however smooth the land is.",
                  TakesEffect::live, true});
  visitor.number(
      "texelPixels", settings.texelPixels,
      {"pixel", 0.5, 16,
       "Largest width of a sample on the picture (height and normal); smaller asks for more chunks.",
       TakesEffect::live, true});
  visitor.number(
      "seaFloorDepthM", settings.seaFloorDepthM,
      {"m", 0, 2000, "Sea floor below this depth is not drawn: the water hides it.", TakesEffect::live});
  visitor.number("cacheMiB", settings.cacheMiB,
                 {"MiB", 8, 4096, "Memory for chunks on the processor's side.", TakesEffect::live, true});
  visitor.number("gpuMiB", settings.gpuMiB,
                 {"MiB", 8, 128, "Memory for chunks on the GPU.", TakesEffect::rebuild, true});
  visitor.number(
      "uploadMiBPerFrame", settings.uploadMiBPerFrame,
      {"MiB", 0.25, 128, "Chunk data that one frame may send to the GPU.", TakesEffect::live, true});
  visitor.integer("queueLimit", settings.queueLimit,
                  {"1", 1, 1024, "Chunks that may wait for a worker.", TakesEffect::rebuild, true});
}

}  // namespace skydrop::terrain
