#include "skydrop/flight/package_settings.h"

namespace skydrop::flight {

void describe(core::SettingsVisitor& v, PackageSettings& s) {
  v.number("mass", s.mass,
           {.unit = "kg",
            .min = 1,
            .max = 2000,
            .help = "Mass of a package: more tumbles slower after the release. How fast it falls is set by "
                    "the two speeds.",
            .aliases = "weight"});
  v.number("size", s.size,
           {.unit = "m",
            .min = 0.1,
            .max = 5,
            .help = "Edge of the box that is pushed out: more tumbles slower after the release.",
            .aliases = "box"});
  v.number("freeFallSpeed", s.freeFallSpeed,
           {.unit = "m/s",
            .min = 10,
            .max = 300,
            .help = "Terminal speed before the parachute opens: more flies further and falls sooner.",
            .aliases = "terminal velocity"});
  v.number("parachuteSpeed", s.parachuteSpeed,
           {.unit = "m/s",
            .min = 1,
            .max = 60,
            .help = "Terminal speed under the parachute: more lands sooner and further on.",
            .aliases = "terminal velocity, chute"});
  v.number("parachuteDelay", s.parachuteDelay,
           {.unit = "s",
            .min = 0,
            .max = 30,
            .help = "From the release until the parachute begins to open: more falls faster for longer.",
            .aliases = "chute"});
  v.number("parachuteOpening", s.parachuteOpening,
           {.unit = "s",
            .min = 0,
            .max = 10,
            .help = "From closed to open: more brakes more gently.",
            .aliases = "chute"});
}

}  // namespace skydrop::flight
