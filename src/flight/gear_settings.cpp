#include "skydrop/flight/gear_settings.h"

namespace skydrop::flight {

void describe(core::SettingsVisitor& v, GearSettings& s) {
  v.number("stiffness", s.stiffness,
           {.unit = "N/m",
            .min = 20000,
            .max = 400000,
            .help = "Of the spring of a main wheel; the tail wheel has half of it: more is harder.",
            .aliases = "suspension, oleo"});
  v.number("damping", s.damping,
           {.unit = "s/m",
            .min = 0,
            .max = 3,
            .help = "How much of a bounce the legs take: 0 springs back for ever.",
            .aliases = "suspension, shock absorber, bounce"});
  v.number("friction", s.friction,
           {.unit = "1",
            .min = 0.1,
            .max = 1.5,
            .help = "Of a tyre on dry ground: less slides.",
            .aliases = "grip, tyre, tire, skid"});
  v.number("rollingResistance", s.rollingResistance,
           {.unit = "1",
            .min = 0,
            .max = 5,
            .help = "Factor on what rolling takes: more stops sooner and takes off later.",
            .aliases = "drag, grass, sand"});
  v.number("brakeFriction", s.brakeFriction,
           {.unit = "1",
            .min = 0,
            .max = 1,
            .help = "Share of a wheel's load that its brake holds: too much puts the aircraft on its nose.",
            .aliases = "brakes"});
  v.number("steeringDeg", s.steeringDeg,
           {.unit = "deg",
            .min = 0,
            .max = 60,
            .help = "How far the tail wheel turns with the yaw keys.",
            .aliases = "taxi, nose wheel"});
  v.number("steeringSpeed", s.steeringSpeed,
           {.unit = "m/s",
            .min = 1,
            .max = 60,
            .help = "At this speed half of the steering is left.",
            .aliases = "taxi"});
  v.number("groundRoughness", s.groundRoughness,
           {.unit = "1",
            .min = 0,
            .max = 5,
            .help = "Factor on the bumps of meadow, sand and scree.",
            .aliases = "bumps"});
  v.number("mostSinkRate", s.mostSinkRate,
           {.unit = "m/s",
            .min = 0.5,
            .max = 20,
            .help = "The legs break where a wheel meets the ground faster than that.",
            .slider = core::Range{0.5, 11},
            .aliases = "hard landing, damage"});
  v.number("mostSideLoad", s.mostSideLoad,
           {.unit = "1",
            .min = 0.1,
            .max = 10,
            .help = "The legs break under more than so many weights across the wheels.",
            .slider = core::Range{0.1, 1.6},
            .aliases = "ground loop, damage"});
  v.number("mostSlopeDeg", s.mostSlopeDeg,
           {.unit = "deg",
            .min = 1,
            .max = 60,
            .help = "The legs break on steeper ground, met at more than walking pace.",
            .slider = core::Range{1, 45},
            .aliases = "terrain, damage"});
  v.number("mostStrikeSpeed", s.mostStrikeSpeed,
           {.unit = "m/s",
            .min = 0,
            .max = 60,
            .help = "Wings, nose and tail break where they touch the ground faster than that.",
            .slider = core::Range{0, 40},
            .aliases = "wing strike, propeller strike, damage"});
  v.number("mostWaterSink", s.mostWaterSink,
           {.unit = "m/s",
            .min = 0.5,
            .max = 20,
            .help = "The hull breaks on water that it meets faster than that.",
            .slider = core::Range{0.5, 11},
            .aliases = "ditching, damage"});
  v.number("mostWaterSpeed", s.mostWaterSpeed,
           {.unit = "m/s",
            .min = 5,
            .max = 120,
            .help = "The hull breaks on water at more than that speed along it.",
            .slider = core::Range{5, 90},
            .aliases = "ditching, damage"});
  v.number("floatSeconds", s.floatSeconds,
           {.unit = "s",
            .min = 0.5,
            .max = 60,
            .help = "How long a ditched aircraft floats before the flight ends.",
            .slider = core::Range{0.5, 20},
            .aliases = "ditching, water"});
}

}  // namespace skydrop::flight
