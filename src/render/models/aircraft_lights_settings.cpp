#include "skydrop/render/models/aircraft_lights_settings.h"

namespace skydrop::render {

using core::Range;

void describe(core::SettingsVisitor& visitor, AircraftLightsSettings& s) {
  visitor.number("brightness", s.brightness,
                 {.unit = "1",
                  .min = 0,
                  .max = 4,
                  .help = "Times the intensity that position and anti-collision lights must have; 0 is off.",
                  .aliases = "navigation lights, nav lights, intensity"});
  visitor.number("flashesPerMinute", s.flashesPerMinute,
                 {.unit = "1/min",
                  .min = 40,
                  .max = 100,
                  .help = "How often beacon and strobes flash.",
                  .aliases = "strobe, beacon, anti-collision, rate"});
  visitor.flag("strobes", s.strobes,
               {.help = "White flashes at the wing tips, beside the red beacon on the fin.",
                .aliases = "strobe, anti-collision"});
  visitor.number("cabinBrightness", s.cabinBrightness,
                 {.unit = "1",
                  .min = 0,
                  .max = 4,
                  .help = "Times the light over the instruments, which is seen from the cockpit; 0 is off.",
                  .aliases = "instrument light, panel light, cockpit"});
}

void describe(core::SettingsVisitor& visitor, LandingLightSettings& s) {
  const core::FieldNote unlessOn = core::noteWhile([&s] { return !s.on; }, "Does nothing while it is off.");
  visitor.flag("on", s.on,
               {.help = "Lights the land ahead; a key switches it too.", .aliases = "headlight, spotlight"});
  visitor.number("intensity", s.intensity,
                 {.unit = "cd",
                  .min = 1e3,
                  .max = 1e6,
                  .help = "On the axis of the beam; twice of it lights the same 1.4 times as far away.",
                  .logarithmic = true,
                  .slider = Range{1e4, 1e6},
                  .aliases = "candela, brightness, power",
                  .note = unlessOn});
  visitor.number("beamDegrees", s.beamDegrees,
                 {.unit = "deg",
                  .min = 3,
                  .max = 40,
                  .help = "Width of the beam to half the intensity.",
                  .aliases = "cone, spot, angle",
                  .note = unlessOn});
  visitor.number("tiltDegrees", s.tiltDegrees,
                 {.unit = "deg",
                  .min = 0,
                  .max = 30,
                  .help = "How far below the nose it points; more lights land that is nearer.",
                  .aliases = "angle, aim, pitch",
                  .note = unlessOn});
}

}  // namespace skydrop::render
