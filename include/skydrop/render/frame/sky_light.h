// The light of a frame: that of the atmosphere (skydrop/sky/atmosphere.h) at the eye's height, and the
// exposure that follows from it. Pure functions of the settings, the height and the simulated time. Light is
// in kilolux and kilocandela per square metre (linear sRGB primaries) before exposure.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <optional>

#include "skydrop/render/frame/overcast.h"
#include "skydrop/render/frame/render_settings.h"
#include "skydrop/sky/atmosphere.h"

namespace skydrop::render {

using sky::kSunRadiusRad;

class MoonOfFrame;

// Where the tables of a sky are seen from and under which lights, if it is not the frame's own place: while
// those are being made (NextSky).
struct SkyPlaces {
  sky::SkyViews::Place sun{};
  std::optional<sky::SkyViews::Place> moon{};  // after sunset, where the clock has one; else there is no moon

  bool operator==(const SkyPlaces&) const = default;
};

// What the moon adds to the light of the sky.
struct MoonSky {
  glm::dvec3 toMoon{0, 1, 0};                // unit, world: as it appears
  std::shared_ptr<const sky::SkyView> view;  // from this height, under this moon; null with the closed form
  glm::dvec3 outside{0};                     // illuminance of the moon above the atmosphere
  glm::dvec3 illuminance{0};                 // on a horizontal surface, from the sky
};

// The light of the sun and its sky, and what else there is. `sky` and `ground` are of all of it.
struct SkyLight : sky::SkyLight {
  // What casts shadows: the sun, or the moon where the clock has one up that is brighter. Of its members
  // `toSun`, `sunOutside` and `sun` are its own (sky::sunIlluminance() of it is that of this light); nothing
  // else is used.
  sky::SkyLight direct{};
  double directRadiusRad = kSunRadiusRad;
  std::optional<MoonSky> moon{};  // after sunset, with the moon above the horizon
  // Shares of what the air scatters of the sun's and of the moon's light that come from where they come from;
  // the rest is the same towards all azimuths. One of the two is 0, for the tables hold one direction: that
  // of the light of which the sky has more, and while one overtakes the other none.
  double sunGlow = 1, moonGlow = 0;
  // Where that is: around it the sky is bright.
  const glm::dvec3& toGlow() const { return moonGlow > 0 ? moon->toMoon : toSun; }
  Overcast overcast{};  // that the day is darkened by
  // What exposure follows: illuminance of level ground and of the horizon together below the clouds, klx, no
  // less than what the eye adapts to at most.
  double level = 0;
  double adaptation = 1;  // the exposure that follows from the light alone
  double exposure = 1;    // with the stops of the settings: what all light is multiplied by before it meets a
                          // half-float target
};

// The one place that decides where the sun stands: the two angles of the settings, or, with SunSource::clock,
// where the almanac has it at their place and time (its apparent place: refraction raises it near the
// horizon).
glm::dvec3 directionToSun(const SunSettings& sun, double simulatedSeconds = 0);
sky::Atmosphere atmosphereOf(const AtmosphereSettings& settings);
// eyeHeight in m above the sea, any finite value. adaptedLevel: what the eye is adapted to (EyeAdaptation),
// as SkyLight::level; without it, or where it is no number above 0, that of this light. overcast: the clouds
// above the eye, which darken the day and are adapted to like an hour of it. tables: null for those of this
// place and light. moon: for others who ask in the same frame; may be null.
SkyLight skyLight(const RenderSettings& settings, double eyeHeight, double simulatedSeconds = 0,
                  std::optional<double> adaptedLevel = std::nullopt, const Overcast& overcast = {},
                  const SkyPlaces* tables = nullptr, MoonOfFrame* moon = nullptr);
// As FrameInput::lightOverNight.
double lightOverNight(const SkyLight& light);
// Where the tables belong that skyLight() looks up without `tables`.
SkyPlaces skyPlaces(const RenderSettings& settings, double eyeHeight, double simulatedSeconds,
                    MoonOfFrame* moon = nullptr);

}  // namespace skydrop::render
