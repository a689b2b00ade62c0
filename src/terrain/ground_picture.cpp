#include "skydrop/terrain/ground_picture.h"

namespace skydrop::terrain {

using core::TakesEffect;

void describe(core::SettingsVisitor& visitor, GroundPictureSettings& settings) {
  visitor.number("share", settings.share,
                 {.unit = "1",
                  .min = 0,
                  .max = 1,
                  .help = "How much of the ground's colour is that of the aerial image, where there is one.",
                  .aliases = "ortho photo, satellite"});
  visitor.number("nearShare", settings.nearShare,
                 {.unit = "1",
                  .min = 0,
                  .max = 1,
                  .help = "How much of its share the aerial image has right before the eye, where its pixels "
                          "are coarse; the rest is made detail."});
  visitor.number("nearM", settings.nearM,
                 {.unit = "m",
                  .min = 1,
                  .max = 1e5,
                  .help = "From which distance on the aerial image has its whole share.",
                  .logarithmic = true,
                  .slider = core::Range{100, 10000}});
  visitor.number("gain", settings.gain,
                 {.unit = "1",
                  .min = 0.1,
                  .max = 4,
                  .help = "How light the ground is for the values of the aerial image.",
                  .logarithmic = true,
                  .slider = core::Range{0.25, 2},
                  .aliases = "brightness of the image"});
  visitor.number("edgeM", settings.edgeM,
                 {.unit = "m",
                  .min = 1,
                  .max = 1e5,
                  .help = "Over which distance within its edges the aerial image comes in.",
                  .takesEffect = TakesEffect::rebuild,
                  .logarithmic = true,
                  .slider = core::Range{50, 5000}});
  visitor.number(
      "megatexels", settings.megatexels,
      {.unit = "2^20",
       .min = 1.0 / 16,
       .max = 64,
       .help = "How many texels of aerial images are kept at most; each takes 5.3 bytes of graphics "
               "memory.",
       .takesEffect = TakesEffect::rebuild,
       .logarithmic = true,
       .slider = core::Range{0.25, 16},
       .aliases = "memory, resolution"});
}

}  // namespace skydrop::terrain
