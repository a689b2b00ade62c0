#include "skydrop/terrain/terrain_streaming_settings.h"

#include <optional>
#include <utility>

namespace skydrop::terrain {

void describe(core::SettingsVisitor& visitor, TerrainStreamingSettings& s) {
  using core::TakesEffect;
  const auto number = [&](std::string_view name, double& value, std::string_view unit, double min, double max,
                          std::string_view help, std::string_view aliases, core::FieldNote note = {},
                          std::optional<core::Range> slider = std::nullopt) {
    visitor.number(name, value,
                   {.unit = unit,
                    .min = min,
                    .max = max,
                    .help = help,
                    .logarithmic = true,
                    .slider = slider,
                    .aliases = aliases,
                    .note = std::move(note)});
  };
  number("viewDistanceM", s.viewDistanceM, "m", 1000, 100000,
         "Land up to this distance is drawn at full accuracy; beyond it the tolerances grow with the square "
         "root of the distance.",
         "LOD, level of detail, draw distance",
         core::noteWhile([&s] { return s.viewDistanceM > s.farDistanceM; },
                         "Land ends before that: at farDistanceM."),
         core::Range{1000, 60000});
  number("farDistanceM", s.farDistanceM, "m", 5000, 100000, "Land ends here, faded into the haze.",
         "draw distance, far plane, horizon");
  number("pixelError", s.pixelError, "pixel", 0.1, 20,
         "Height error of the mesh that is allowed on the picture, reached at 5 % of the land; larger is "
         "coarser and faster, within what cellPixels and texelPixels leave open.",
         "LOD, level of detail, screen space error");
  number("cellPixels", s.cellPixels, "pixel", 1, 200,
         "Largest width of a mesh cell on the picture, however smooth the land is; smaller draws more "
         "triangles.",
         "LOD, level of detail, tessellation", {}, core::Range{1, 120});
  number("texelPixels", s.texelPixels, "pixel", 0.5, 16,
         "Largest width of a sample on the picture (height and normal); smaller asks for more chunks.",
         "LOD, level of detail, resolution");
  visitor.number("seaFloorDepthM", s.seaFloorDepthM,
                 {.unit = "m",
                  .min = 0,
                  .max = 2000,
                  .help = "Sea floor below this depth is not drawn: the water hides it.",
                  .slider = core::Range{0, 150},
                  .aliases = "underwater, culling"});
  number("cacheMiB", s.cacheMiB, "MiB", 8, 4096,
         "Memory for chunks on the processor's side; what does not fit is made again, or drawn coarser.",
         "RAM, budget");
  visitor.number("gpuMiB", s.gpuMiB,
                 {.unit = "MiB",
                  .min = 8,
                  .max = 128,
                  .help = "Memory for chunks on the GPU; what does not fit is drawn coarser.",
                  .takesEffect = TakesEffect::rebuild,
                  .logarithmic = true,
                  .aliases = "VRAM, budget"});
  number("uploadMiBPerFrame", s.uploadMiBPerFrame, "MiB", 0.25, 128,
         "Chunk data that one frame may send to the GPU, one chunk at least; less makes frames steadier and "
         "land sharp later.",
         "bandwidth, budget, stutter", {}, core::Range{0.5, 128});
  visitor.integer("queueLimit", s.queueLimit,
                  {.unit = "1",
                   .min = 1,
                   .max = 1024,
                   .help = "Chunks that may wait for a worker; more keeps many workers busy.",
                   .takesEffect = TakesEffect::rebuild,
                   .logarithmic = true,
                   .aliases = "jobs, threads"});
}

}  // namespace skydrop::terrain
