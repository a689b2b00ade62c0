// The weather made by hand: one or two sites with what the air does there, and how one changes into the
// other. Plain values; describe() states and enforces the ranges, requireUsable() what holds between fields.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <string_view>

#include "skydrop/core/settings.h"
#include "skydrop/weather/state.h"

namespace skydrop::weather {

inline constexpr std::size_t kSites = 2;

struct WindLevelSettings {
  double height = 0;       // m above the sea, 100 .. 20000
  double speed = 0;        // m/s, 0 .. 120
  double direction = 260;  // degrees by compass where it comes from, 0 .. 360
};

struct WeatherLayerSettings {
  Genus genus = Genus::cumulus;
  double base = 1555;  // m above the sea, 0 .. 15000
  double top = 3355;   // m above the sea, 50 .. 18000
  double cover = 0;    // 0 .. 1
  double density = 1;  // 0 .. 4
};

struct SiteSettings {
  double eastM = 0, northM = 0;  // m, -1e7 .. 1e7: where the site lies
  double windSpeed = 5;          // m/s, 0 .. 50, 10 m above the ground
  double windDirection = 250;    // degrees by compass where it comes from, 0 .. 360
  double gust = 2;               // m/s, 0 .. 40
  double roughness = 0.05;       // m, 1e-4 .. 2
  double gradientHeight = 300;   // m, 100 .. 1000
  std::array<WindLevelSettings, kWindLevels> levels{{{1500, 10, 260}, {5500, 18, 270}, {10000, 30, 275}}};
  std::array<WeatherLayerSettings, kLayers> layers{};
  double fog = 0;             // 1/m, 0 .. 0.2
  double fogTop = 60;         // m above the sea, -500 .. 5000
  double rain = 0;            // mm/h, 0 .. 150
  double snow = 0;            // mm/h of water, 0 .. 20
  double sleet = 0;           // mm/h, 0 .. 50
  double hail = 0;            // mm/h, 0 .. 100
  double visibility = 30000;  // m, 50 .. 200000
  double temperature = 15;    // degrees Celsius at the sea, -50 .. 50
  double pressure = 1013.25;  // hPa at the sea, 900 .. 1080
  double lightning = 0;       // flashes a minute, 0 .. 30
  double severity = 2;        // 0 .. 6 (State::turbulenceSeverity)
};

// A whole sky at once: sets the rows of sites, wind and clouds (app/settings/weather_sky.h).
enum class SkyChoice { none, fair, beforeWarmFront, frontPassing, thunderstorm, afterRain };
inline constexpr std::array<std::string_view, 6> kSkyChoiceNames = {
    "none", "fair", "beforeWarmFront", "frontPassing", "thunderstorm", "afterRain"};

struct WeatherSettings {
  SkyChoice sky = SkyChoice::none;
  bool standardAtmosphere = true;  // off: the density of the sea's level at all heights
  double turbulence = 1;           // 0 .. 2, of Dryden's
  double draughts = 1;             // 0 .. 2, of those of clouds
  double slopeWind = 1;            // 0 .. 2, of that of ridges
  double icing = 1;                // 0 .. 4, of the usual rate
  // 0 .. 1: share of gusts and draughts that packages feel. What they feel the prediction of their landing
  // does not know: at .3 more than nine of ten still hit, in thunderstorms too.
  double packageGusts = 0.3;
  double variability = 0.2;    // 0 .. 1: how far wind and clouds wander about their means
  double wanderSeconds = 900;  // s, 60 .. 86400: from one wander to the next
  bool secondSite = false;     // off: the first site's weather is everywhere
  double approachSeconds = 0;  // s, 0 .. 86400: until the second site's weather has reached the first
  std::array<SiteSettings, kSites> sites{{{}, {.eastM = 30000}}};
};

void describe(core::SettingsVisitor& visitor, WindLevelSettings& settings);
void describe(core::SettingsVisitor& visitor, WeatherLayerSettings& settings);
void describe(core::SettingsVisitor& visitor, SiteSettings& settings);
void describe(core::SettingsVisitor& visitor, WeatherSettings& settings);

// Throws core::RangeError with place ("weather.sites.0.layers.1: ...") and reason where fields contradict
// each other: a layer's top that is not above its base, levels of the wind that do not ascend.
void requireUsable(const WeatherSettings& settings);

// The weather of a site, without its wander.
State stateOf(const SiteSettings& site);

// How far from the first site's weather to the second's, [0, 1], smooth in place and time: by the way between
// them, moved on as the second approaches. 0 with one site; two sites at one place change in time alone.
double siteShare(const WeatherSettings& settings, double seconds, const glm::dvec2& xz);

// The weather at a place (x east, z south, m) and time (simulated seconds): the sites, mixed, and their
// wander, which follows from the seed. Pure; what requireUsable() accepts gives a usable state.
State stateAt(const WeatherSettings& settings, std::uint64_t seed, double seconds, const glm::dvec2& xz);

// Whether some place or moment may have clouds.
bool hasClouds(const WeatherSettings& settings);

}  // namespace skydrop::weather
