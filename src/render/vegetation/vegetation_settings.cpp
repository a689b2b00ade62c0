#include "skydrop/render/vegetation/vegetation_settings.h"

namespace skydrop::render {

using core::Range;

void describe(core::SettingsVisitor& visitor, VegetationSettings& s) {
  visitor.number("meshM", s.meshM,
                 {.unit = "m",
                  .min = 0,
                  .max = 400,
                  .help = "How far away trees are shapes in space; beyond, they are pictures.",
                  .slider = Range{20, 300},
                  .aliases = "trees, LOD, mesh, distance"});
  visitor.number("farM", s.farM,
                 {.unit = "m",
                  .min = 0,
                  .max = 4000,
                  .help = "How far away trees stand at all; beyond, woods are painted on the land.",
                  .slider = Range{100, 2500},
                  .aliases = "trees, impostors, billboards, view distance"});
  visitor.integer("atlasTexels", s.atlasTexels,
                  {.unit = "1",
                   .min = 16,
                   .max = 128,
                   .help = "Side of each picture of a tree, in texels.",
                   .takesEffect = core::TakesEffect::rebuild,
                   .aliases = "trees, impostors, resolution"});
  visitor.integer("atlasViews", s.atlasViews,
                  {.unit = "1",
                   .min = 4,
                   .max = 12,
                   .help = "From so many sides squared is each kind of tree pictured.",
                   .takesEffect = core::TakesEffect::rebuild,
                   .aliases = "trees, impostors, octahedral"});
  visitor.number("sway", s.sway,
                 {.unit = "1",
                  .min = 0,
                  .max = 3,
                  .help = "How much trees bend and sway in the wind.",
                  .aliases = "trees, wind, bend"});
  visitor.number("shadow", s.shadow,
                 {.unit = "1",
                  .min = 0,
                  .max = 1,
                  .help = "How dark the shadows of trees are.",
                  .aliases = "trees, shade"});
  visitor.number(
      "shadowM", s.shadowM,
      {.unit = "m",
       .min = 0,
       .max = 1000,
       .help =
           "How far away trees have shadows of their own; beyond, the ground of woods is dark in the mean.",
       .slider = Range{50, 500},
       .aliases = "trees, shade, distance"});
}

}  // namespace skydrop::render
