#include "skydrop/render/frame/render_settings.h"

#include <array>
#include <string_view>

#include "skydrop/sky/instant.h"

namespace skydrop::render {

void describe(core::SettingsVisitor& visitor, CameraSettings& s) {
  const auto number = [&](std::string_view name, double& value, std::string_view unit, double min, double max,
                          std::string_view help, std::string_view aliases) {
    visitor.number(name, value, {.unit = unit, .min = min, .max = max, .help = help, .aliases = aliases});
  };
  number("fovDegrees", s.fovDegrees, "deg", 20, 120, "Vertical field of view; more shows more, smaller.",
         "FOV, zoom, angle of view");
  number("nearM", s.nearM, "m", 0.02, 5,
         "Near plane: of aircraft, packages and land, what is nearer to the eye is cut away.",
         "near clip, clipping plane");
  number("chaseDistance", s.chaseDistance, "m", 4, 60, "How far behind the aircraft the chase camera flies.",
         "third person, follow camera");
  number("chaseHeight", s.chaseHeight, "m", 0, 20, "How far above the aircraft the chase camera flies.",
         "third person, follow camera");
  number("chaseSoftness", s.chaseSoftness, "1", 0, 1,
         "How far the chase camera hangs back in turns; 0 is bolted to the aircraft.",
         "camera lag, smoothing, third person");
  number("groundClearance", s.groundClearance, "m", 0.5, 50,
         "The chase camera stays this far above land and sea.", "camera collision, third person");
  number("buffetDegrees", s.buffetDegrees, "deg", 0, 2,
         "How much a stall, and less what announces it, shakes the picture of chase camera and cockpit; 0 "
         "keeps it still.",
         "camera shake");
  number("cockpitForward", s.cockpitForward, "m", -2, 5,
         "In the cockpit: the pilot's eye ahead of the aircraft's centre.", "first person, eye position");
  number("cockpitHeight", s.cockpitHeight, "m", -1, 3,
         "In the cockpit: the pilot's eye above the aircraft's centre.", "first person, eye position");
}

void describe(core::SettingsVisitor& visitor, SunSettings& s) {
  const core::FieldNote unlessManual = core::noteWhile([&s] { return s.source != SunSource::manual; },
                                                       "Does nothing while the clock moves the sun.");
  const core::FieldNote unlessClock = core::noteWhile([&s] { return s.source != SunSource::clock; },
                                                      "Does nothing unless the clock moves the sun.");
  visitor.number(
      "elevationDegrees", s.elevationDegrees,
      {.unit = "deg",
       .min = -30,
       .max = 90,
       .help = "Height of the sun above the horizon; below 0 it has set, and from -15 on it is night.",
       .slider = core::Range{-15, 90},
       .aliases = "altitude, height, time of day, night",
       .note = unlessManual});
  visitor.number("azimuthDegrees", s.azimuthDegrees,
                 {.unit = "deg",
                  .min = 0,
                  .max = 360,
                  .help = "Compass direction of the sun: 90 is east, 180 south.",
                  .aliases = "heading, direction, bearing, time of day",
                  .note = unlessManual});
  visitor.choice("source", s.source, kSunSourceNames,
                 {.help = "Manual takes the two angles; clock moves the sun as it moves at a place and time.",
                  .aliases = "almanac, time of day, real sun"});
  visitor.integer("utc", s.utcMs,
                  {.unit = "1",
                   .min = static_cast<double>(sky::kFirstInstant.utcMs),
                   .max = static_cast<double>(sky::kLastInstant.utcMs),
                   .help = "Date and time (UTC, ISO 8601) that the flight begins at.",
                   .slider = core::Range{-631152000000, 2556143999000},  // 1950 to 2050
                   .aliases = "date, clock, time of day, season, year",
                   .note =
                       [&s, unlessClock] {
                         if (std::string idle = unlessClock(); !idle.empty()) return idle;
                         return std::string(sky::isAccurate({s.utcMs})
                                                ? ""
                                                : "Sun and moon are exact from 1950 to 2050 only.");
                       },
                   .written = &sky::kInstantForm});
  const auto ofClock = [&](std::string_view name, double& value, std::string_view unit, double most,
                           std::string_view help, std::string_view aliases,
                           std::optional<core::Range> slider) {
    visitor.number(name, value,
                   {.unit = unit,
                    .min = -most,
                    .max = most,
                    .help = help,
                    .slider = slider,
                    .aliases = aliases,
                    .note = unlessClock});
  };
  ofClock("shiftDays", s.shiftDays, "d", 366, "Days added to the clock: goes through the seasons.",
          "date, season, scrub", core::Range{-183, 183});
  ofClock("shiftHours", s.shiftHours, "h", 24, "Hours added to the clock: goes through the day.",
          "time of day, scrub", core::Range{-12, 12});
  visitor.number(
      "timeScale", s.timeScale,
      {.unit = "1",
       .min = 0,
       .max = 3600,
       .help = "How fast the clock runs; 0 holds it, 3600 passes an hour in each second of flight.",
       .aliases = "speed of time, time lapse",
       .note = unlessClock});
  ofClock("offsetSeconds", s.offsetSeconds, "s", 1e9,
          "Seconds that the clock keeps when its speed changes in flight, so that it does not jump; set by "
          "the program.",
          "time, speed, base", core::Range{-86400, 86400});
  ofClock("latitudeDegrees", s.latitudeDegrees, "deg", 90, "Place on the earth, north of the equator.",
          "place, position, north", std::nullopt);
  ofClock("longitudeDegrees", s.longitudeDegrees, "deg", 360, "Place on the earth, east of Greenwich.",
          "place, position, east", core::Range{-180, 180});
}

void describe(core::SettingsVisitor& visitor, AtmosphereSettings& s) {
  visitor.number("visibilityM", s.visibilityM,
                 {.unit = "m",
                  .min = 1000,
                  .max = 250000,
                  .help = "Distance at sea level at which a dark hill is just seen against the sky; less is "
                          "hazier.",
                  .logarithmic = true,
                  .aliases = "fog, haze, turbidity, view distance"});
  visitor.number("hazeHeightM", s.hazeHeightM,
                 {.unit = "m",
                  .min = 100,
                  .max = 4000,
                  .help = "Height over which the haze thins to 37 %; more reaches higher.",
                  .aliases = "fog, aerosol, scale height"});
  visitor.number("hazeAnisotropy", s.hazeAnisotropy,
                 {.unit = "1",
                  .min = 0,
                  .max = 0.95,
                  .help = "How strongly haze scatters forward; more makes a brighter glow around the sun.",
                  .aliases = "g, Mie, fog, phase function"});
}

void describe(core::SettingsVisitor& visitor, SkySettings& s) {
  visitor.choice(
      "model", s.model, sky::kSkyModelNames,
      {.help = "The shell scatters light many times in air around a round earth, with ozone and the "
               "earth's shadow; the closed form is cheap, and wrong in twilight.",
       .takesEffect = core::TakesEffect::variant,
       .aliases = "atmosphere, scattering, twilight, quality"});
}

void describe(core::SettingsVisitor& visitor, RenderSettings& s) {
  visitor.group("camera", s.camera, "Where the frame is seen from.");
  visitor.group("sun", s.sun, "Where the sun stands.");
  visitor.group("atmosphere", s.atmosphere, "Air and haze between the eye and the land.");
  visitor.group("sky", s.sky, "How the light of the air is worked out.");
  visitor.enterGroup("picture", "From light to the screen.");
  visitor.number("exposureStops", s.exposureStops,
                 {.unit = "EV",
                  .min = -6,
                  .max = 6,
                  .help = "Brightness on top of the automatic exposure; each step doubles it.",
                  .aliases = "brightness, gamma, exposure compensation"});
  visitor.number("scale", s.scale,
                 {.unit = "1",
                  .min = 0.25,
                  .max = 4,
                  .help = "In which share of the picture's width and height the scene is drawn; less is "
                          "faster and blurred, more means several pixels for each and takes their square in "
                          "time and memory. The interface stays sharp.",
                  .slider = core::Range{0.25, 2},
                  .aliases = "resolution, render scale, upscaling, supersampling, SSAA, pixels"});
  visitor.number("interfaceAtNight", s.interfaceAtNight,
                 {.unit = "1",
                  .min = 0.2,
                  .max = 1,
                  .help = "How bright instruments and menus are at night; by day they are at 1.",
                  .aliases = "HUD, dim, brightness, glare"});
  visitor.flag("smoothModels", s.smoothModels,
               {.help = "Draws the edges of aircraft and packages with four samples a pixel; off, they are "
                        "jagged.",
                .aliases = "AA, antialiasing, MSAA, multisampling"});
  visitor.flag("smoothEdges", s.smoothEdges,
               {.help = "Blends the pixels beside edges of land, trees and houses by the share that the "
                        "other side has of them; off, edges are stair steps.",
                .takesEffect = core::TakesEffect::variant,
                .aliases = "AA, antialiasing, SMAA, MLAA, FXAA, jagged, horizon"});
  visitor.number(
      "leastEdge", s.leastEdge,
      {.unit = "1",
       .min = 0.002,
       .max = 0.9,
       .help = "Which edges are smoothed: those at which the distance changes by this share or "
               "more; less smooths trees before trees too, and takes longer.",
       .logarithmic = true,
       .slider = core::Range{0.01, 0.5},
       .aliases = "AA, antialiasing, edges, quality",
       .note = core::noteWhile([&s] { return !s.smoothEdges; }, "Does nothing: no edges are smoothed.")});
  visitor.flag(
      "guardMarks", s.guardMarks,
      {.help = "Darkens the picture and marks pixels whose light was cut (yellow), negative (cyan) or "
               "no number (magenta), and lists the numerical guards that fired in each frame.",
       .takesEffect = core::TakesEffect::variant,
       .aliases = "debug, NaN, clamp, guards, stability"});
  visitor.leaveGroup();
  visitor.enterGroup("land", "The land's surface, and ways to look at its mesh.");
  static constexpr std::array<std::string_view, 2> kDetails = {"plain", "rich"};
  visitor.choice("detail", s.landDetail, kDetails,
                 {.help = "Rich land has single trees, layers of rock and rough ground, and takes half again "
                          "the time of plain.",
                  .takesEffect = core::TakesEffect::variant,
                  .aliases = "quality, material, texture, trees"});
  visitor.flag("wireframe", s.wireframe, {.help = "Draws the land as lines.", .aliases = "mesh, polygons"});
  visitor.flag(
      "terrainNormals", s.terrainNormals,
      {.help = "Draws a stroke along the normal of each vertex of the land.", .aliases = "normals, debug"});
  visitor.leaveGroup();
}

}  // namespace skydrop::render
