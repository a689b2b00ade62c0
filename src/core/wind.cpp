#include "skydrop/core/wind.h"

#include "skydrop/core/deterministic_math.h"

namespace skydrop::core {
namespace {

// Unit, in x and z: where it blows to.
glm::dvec2 downwind(const WindSettings& settings) {
  const double from = settings.direction * dmath::kRadPerDeg;  // 0 = -z, 90 = +x
  return {-dmath::sin(from), dmath::cos(from)};
}

}  // namespace

void describe(SettingsVisitor& visitor, WindSettings& s) {
  visitor.number("speed", s.speed,
                 {.unit = "m/s",
                  .min = 0,
                  .max = 60,
                  .help = "How fast the air moves: clouds drift with it while time goes on.",
                  .aliases = "drift, breeze"});
  visitor.number("direction", s.direction,
                 {.unit = "deg",
                  .min = 0,
                  .max = 360,
                  .help = "Compass direction from which the wind blows.",
                  .aliases = "drift, heading",
                  .note = noteWhile([&s] { return !(s.speed > 0); }, "Does nothing without wind.")});
  visitor.flag("movesAircraft", s.movesAircraft,
               {.help = "Carries aircraft and packages along; off, they move through still air.",
                .aliases = "crosswind, headwind, tailwind",
                .note = noteWhile([&s] { return !(s.speed > 0); }, "Does nothing without wind.")});
}

glm::dvec2 windDrift(const WindSettings& settings, double seconds) {
  return downwind(settings) * (settings.speed * seconds);
}

glm::dvec3 flownWind(const WindSettings& settings) {
  if (!settings.movesAircraft) return glm::dvec3(0);
  const glm::dvec2 metres = windDrift(settings, 1);
  return {metres.x, 0, metres.y};
}

}  // namespace skydrop::core
