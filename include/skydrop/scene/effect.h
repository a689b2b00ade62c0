// The effects that a scene can call for. What is not in a scene's set is not constructed: no memory, no
// thread, no shader, no dispatch.
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <string>
#include <string_view>

namespace skydrop::scene {

enum class Effect {
  sky,             // sky gradient, sun, light of both
  terrain,         // endless land and sea
  clouds,          // a layer of volumetric clouds that drifts with the wind
  haze,            // extinction and in-scattering between eye and surface
  aircraft,        // the airplane: its flight, its model, its camera
  targets,         // targets, packages, score
  sound,           // engine and events
  hud,             // instruments, navigation bar, messages
  cloudPlanes,     // up to three flat layers of clouds that follow the eye
  cloudDome,       // clouds on a hemisphere behind everything
  groundFog,       // fog on the ground, by height
  moon,            // the moon's disc, by place and time
  stars,           // stars to magnitude 6, by place and time
  landShadows,     // shadows of mountains on land, sea and what flies
  halo,            // halos and sun dogs of ice around sun or moon
  rainbow,         // rainbows in rain opposite sun or moon
  weather,         // the air that one flies in: wind by height, turbulence, draughts, density, ice
  lightShafts,     // the shade that clouds and land throw into the air
  aircraftLights,  // position and anti-collision lights of the aircraft
  landingLight,    // the aircraft's lamp that lights the land ahead
  iceClouds,       // high clouds of ice: cirrus, cirrostratus, cirrocumulus
  precipitation,   // rain, snow and hail around the eye, its shafts, and what it leaves on the land
  lightning,       // flashes of the weather, their light and their thunder
  groundHandling,  // the gear bears: taxi, take-off, landing, ditching
  vegetation,      // trees that stand on the land and in the way
  groundDetail,    // the ground from a few metres: its materials and layers of rock
  waterDetail,     // water close by: waves of the wind, foam, the ground below, mirrored land
  places,          // villages: houses, fields, roads, lit windows at night
  dustAndSpray,    // what flies up where something touches land or water, and wakes
  groundCover,     // grass, flowers, reeds, stones that stand near the eye
  count_           // how many there are; no effect itself, and always the last
};

// As scene files write them; kEffectNames[i] belongs to static_cast<Effect>(i).
inline constexpr auto kEffectNames = std::to_array<std::string_view>(
    {"sky",          "terrain",       "clouds",      "haze",           "aircraft",
     "targets",      "sound",         "hud",         "cloudPlanes",    "cloudDome",
     "groundFog",    "moon",          "stars",       "landShadows",    "halo",
     "rainbow",      "weather",       "lightShafts", "aircraftLights", "landingLight",
     "iceClouds",    "precipitation", "lightning",   "groundHandling", "vegetation",
     "groundDetail", "waterDetail",   "places",      "dustAndSpray",   "groundCover"});
static_assert(kEffectNames.size() == static_cast<std::size_t>(Effect::count_), "one name for each effect");

class EffectSet {
 public:
  constexpr EffectSet() = default;

  bool contains(Effect effect) const { return bits_[static_cast<std::size_t>(effect)]; }
  void insert(Effect effect) { bits_.set(static_cast<std::size_t>(effect)); }
  void erase(Effect effect) { bits_.reset(static_cast<std::size_t>(effect)); }
  bool operator==(const EffectSet&) const = default;

 private:
  std::bitset<kEffectNames.size()> bits_;
};

// The effects that one rests on: the table of all such needs.
struct EffectNeed {
  Effect effect;
  Effect needs;
};
inline constexpr std::array kEffectNeeds = {
    EffectNeed{Effect::targets, Effect::aircraft},         // that drops the packages
    EffectNeed{Effect::targets, Effect::terrain},          // that they land on
    EffectNeed{Effect::weather, Effect::aircraft},         // that meets the air
    EffectNeed{Effect::precipitation, Effect::weather},    // that it falls in
    EffectNeed{Effect::groundHandling, Effect::aircraft},  // that stands on it
    EffectNeed{Effect::vegetation, Effect::terrain},       // that it grows on
    EffectNeed{Effect::groundDetail, Effect::terrain},     // that it is the look of
    EffectNeed{Effect::waterDetail, Effect::terrain},      // that has the sea
    EffectNeed{Effect::places, Effect::terrain},           // that they lie in
    EffectNeed{Effect::groundCover, Effect::terrain},      // that it stands on
};

inline constexpr std::string_view nameOf(Effect effect) {
  return kEffectNames[static_cast<std::size_t>(effect)];
}

// These effects and all that they rest on.
EffectSet withNeeds(EffectSet effects);

// What is missing, in words: "targets needs aircraft, which is off"; empty where nothing is.
std::string unmetNeed(const EffectSet& effects);

// Those that there is anything to do for: haze needs something that it could veil, landShadows land,
// lightShafts haze and something that shades it, lamps an aircraft, lightning weather, dustAndSpray an
// aircraft and terrain.
EffectSet effective(EffectSet effects);

}  // namespace skydrop::scene
