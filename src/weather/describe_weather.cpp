// The description of the weather's settings, a row each.
#include "skydrop/weather/weather_settings.h"

namespace skydrop::weather {

void describe(core::SettingsVisitor& v, WindLevelSettings& s) {
  v.number("height", s.height,
           {.unit = "m",
            .min = 100,
            .max = 20000,
            .help = "Height of this level above the sea; each is above the one before.",
            .slider = core::Range{1100, 15000},
            .aliases = "altitude, level"});
  v.number("speed", s.speed,
           {.unit = "m/s",
            .min = 0,
            .max = 120,
            .help = "Speed of the wind at this level.",
            .slider = core::Range{0, 60},
            .aliases = "jet stream, shear"});
  v.number("direction", s.direction,
           {.unit = "deg",
            .min = 0,
            .max = 360,
            .help = "Compass direction from which the wind blows at this level.",
            .aliases = "shear, heading",
            .note = core::noteWhile([&s] { return !(s.speed > 0); }, "Does nothing without wind.")});
}

void describe(core::SettingsVisitor& v, WeatherLayerSettings& s) {
  const core::FieldNote none =
      core::noteWhile([&s] { return !(s.cover > 0); }, "Does nothing without cover.");
  v.choice("genus", s.genus, kGenusNames,
           {.help = "The genus of the clouds: decides draughts, turbulence and look.",
            .aliases = "cloud type, species",
            .note = none});
  v.number("base", s.base,
           {.unit = "m",
            .min = 0,
            .max = 15000,
            .help = "Height of the layer's base above the sea.",
            .slider = core::Range{0, 12000},
            .aliases = "ceiling, altitude",
            .note = none});
  v.number("top", s.top,
           {.unit = "m",
            .min = 50,
            .max = 18000,
            .help = "Height of the layer's top above the sea; above the base.",
            .slider = core::Range{1600, 15000},
            .aliases = "thickness, altitude",
            .note = none});
  v.number("cover", s.cover,
           {.unit = "1",
            .min = 0,
            .max = 1,
            .help = "Share of the sky that the layer covers; 0 for none.",
            .aliases = "coverage, octas, amount"});
  v.number("density", s.density,
           {.unit = "1",
            .min = 0,
            .max = 4,
            .help = "Of the genus's usual density: more is darker and rougher to fly in.",
            .aliases = "thickness, water content",
            .note = none});
}

void describe(core::SettingsVisitor& v, SiteSettings& s) {
  v.number("eastM", s.eastM,
           {.unit = "m",
            .min = -1e7,
            .max = 1e7,
            .help = "Where the site lies, towards east.",
            .slider = core::Range{-100000, 100000},
            .aliases = "position, x"});
  v.number("northM", s.northM,
           {.unit = "m",
            .min = -1e7,
            .max = 1e7,
            .help = "Where the site lies, towards north.",
            .slider = core::Range{-100000, 100000},
            .aliases = "position, z"});
  v.number("windSpeed", s.windSpeed,
           {.unit = "m/s",
            .min = 0,
            .max = 50,
            .help = "Mean speed of the wind 10 m above the ground.",
            .slider = core::Range{0, 25},
            .aliases = "breeze, gale"});
  v.number("windDirection", s.windDirection,
           {.unit = "deg",
            .min = 0,
            .max = 360,
            .help = "Compass direction from which the wind near the ground blows.",
            .aliases = "heading, crosswind",
            .note = core::noteWhile([&s] { return !(s.windSpeed > 0); }, "Does nothing without wind.")});
  v.number("gust", s.gust,
           {.unit = "m/s",
            .min = 0,
            .max = 40,
            .help = "By how much the strongest gusts near the ground exceed the mean wind.",
            .slider = core::Range{0, 20},
            .aliases = "turbulence, bumps"});
  v.number("roughness", s.roughness,
           {.unit = "m",
            .min = 1e-4,
            .max = 2,
            .help = "Roughness length of the ground: 0.0002 open sea, 0.03 grass, 1 forest. More slows the "
                    "wind below, against the wind above.",
            .logarithmic = true,
            .aliases = "terrain class, boundary layer"});
  v.number("gradientHeight", s.gradientHeight,
           {.unit = "m",
            .min = 100,
            .max = 1000,
            .help = "Height above the ground from which on it no longer slows the wind.",
            .aliases = "boundary layer"});
  v.group("levels", s.levels, "Wind of the free air, from below to above.");
  v.group("layers", s.layers, "A layer of clouds.");
  v.number("fog", s.fog,
           {.unit = "1/m",
            .min = 0,
            .max = 0.2,
            .help = "Extinction of fog on the ground: 3.9 over the sight in it.",
            .aliases = "mist, visibility"});
  v.number("fogTop", s.fogTop,
           {.unit = "m",
            .min = -500,
            .max = 5000,
            .help = "Height of the fog's top above the sea.",
            .slider = core::Range{0, 1000},
            .aliases = "mist",
            .note = core::noteWhile([&s] { return !(s.fog > 0); }, "Does nothing without fog.")});
  v.number("rain", s.rain,
           {.unit = "mm/h",
            .min = 0,
            .max = 150,
            .help = "Rain on the ground: 1 light, 8 heavy, 50 a cloudburst.",
            .slider = core::Range{0, 50},
            .aliases = "precipitation, shower, drizzle"});
  v.number("snow", s.snow,
           {.unit = "mm/h",
            .min = 0,
            .max = 20,
            .help = "Snow on the ground, as water.",
            .aliases = "precipitation, winter"});
  v.number("sleet", s.sleet,
           {.unit = "mm/h",
            .min = 0,
            .max = 50,
            .help = "Rain and snow together, as water.",
            .aliases = "precipitation, wintry mix"});
  v.number("hail", s.hail,
           {.unit = "mm/h",
            .min = 0,
            .max = 100,
            .help = "Hail on the ground, as water.",
            .aliases = "precipitation, thunderstorm"});
  v.number("visibility", s.visibility,
           {.unit = "m",
            .min = 50,
            .max = 200000,
            .help = "How far one sees through the air without fog.",
            .logarithmic = true,
            .aliases = "haze, sight"});
  v.number("temperature", s.temperature,
           {.unit = "degC",
            .min = -50,
            .max = 50,
            .help = "Temperature of the air at the sea's level; warmer air is thinner, colder ices.",
            .aliases = "heat, freezing level"});
  v.number("pressure", s.pressure,
           {.unit = "hPa",
            .min = 900,
            .max = 1080,
            .help = "Pressure of the air at the sea's level: more is denser.",
            .aliases = "QNH, barometer"});
  v.number("lightning", s.lightning,
           {.unit = "1/min",
            .min = 0,
            .max = 30,
            .help = "Flashes a minute within sight.",
            .aliases = "thunder, thunderstorm"});
  v.number("severity", s.severity,
           {.unit = "1",
            .min = 0,
            .max = 6,
            .help = "Turbulence above 600 m: 0 none, 2 light, 3 moderate, 5 severe; the exponent of the "
                    "probability that it is exceeded.",
            .aliases = "clear air turbulence, bumps, gusts"});
}

void describe(core::SettingsVisitor& v, WeatherSettings& s) {
  v.choice("sky", s.sky, kSkyChoiceNames,
           {.help = "Sets the weather of both sites, the wind and the low clouds together; rows that are set "
                    "after it stay as they are.",
            .aliases = "preset, front, storm, weather"});
  v.flag("standardAtmosphere", s.standardAtmosphere,
         {.help = "Air thins with height by the standard atmosphere of 1976; off, it is as dense as at the "
                  "sea everywhere.",
          .aliases = "ISA, density, IAS, TAS"});
  v.number("turbulence", s.turbulence,
           {.unit = "1",
            .min = 0,
            .max = 2,
            .help = "Strength of the turbulence, of Dryden's model; 0 for smooth air.",
            .aliases = "gusts, bumps, Dryden"});
  v.number("draughts", s.draughts,
           {.unit = "1",
            .min = 0,
            .max = 2,
            .help = "Strength of up- and downdraughts under and in clouds.",
            .aliases = "thermals, lift, sink"});
  v.number("slopeWind", s.slopeWind,
           {.unit = "1",
            .min = 0,
            .max = 2,
            .help = "Strength of the air's rising before ridges and sinking behind them.",
            .aliases = "lee, ridge lift, orographic"});
  v.number("icing", s.icing,
           {.unit = "1",
            .min = 0,
            .max = 4,
            .help = "How fast ice grows in cold clouds and freezing rain; 0 for never.",
            .aliases = "ice, frost"});
  v.number(
      "packageGusts", s.packageGusts,
      {.unit = "1",
       .min = 0,
       .max = 1,
       .help = "How much of gusts and draughts packages feel; at 0 the mean wind alone carries them, which "
               "is what the prediction of their landing knows.",
       .aliases = "drop, accuracy, turbulence"});
  v.number("variability", s.variability,
           {.unit = "1",
            .min = 0,
            .max = 1,
            .help = "How far wind, cover and precipitation wander about their means as time goes on.",
            .aliases = "change, random"});
  v.number(
      "wanderSeconds", s.wanderSeconds,
      {.unit = "s",
       .min = 60,
       .max = 86400,
       .help = "Time in which they wander from one value to the next.",
       .logarithmic = true,
       .slider = core::Range{60, 7200},
       .aliases = "change, speed",
       .note = core::noteWhile([&s] { return !(s.variability > 0); }, "Does nothing without variability.")});
  v.flag("secondSite", s.secondSite,
         {.help = "The weather changes on the way to a second site; off, the first site's is everywhere.",
          .aliases = "front, destination, interpolation"});
  v.number("approachSeconds", s.approachSeconds,
           {.unit = "s",
            .min = 0,
            .max = 86400,
            .help = "Time after which the second site's weather has come to the first; 0 keeps it there.",
            .slider = core::Range{0, 7200},
            .aliases = "front, passage",
            .note = core::noteWhile([&s] { return !s.secondSite; }, "Does nothing without a second site.")});
  v.group("sites", s.sites, "What the air does at this site.");
}

}  // namespace skydrop::weather
