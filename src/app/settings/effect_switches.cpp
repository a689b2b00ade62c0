#include "app/settings/effect_switches.h"

#include <string>

#include "skydrop/core/error.h"

namespace skydrop::app {
namespace {

using scene::Effect;

std::string_view helpOf(Effect effect) {
  switch (effect) {
    case Effect::sky:
      return "The sky with its sun, and the light of both.";
    case Effect::terrain:
      return "Endless land and sea, which also decide where a flight ends.";
    case Effect::clouds:
      return "Volumetric clouds that drift with the wind, and their shadows on the land.";
    case Effect::haze:
      return "Air between the eye and what it sees: distant things fade into the sky.";
    case Effect::aircraft:
      return "The airplane: its flight, its model, its shadow. Without it the camera is free.";
    case Effect::targets:
      return "Targets, packages and score. Needs aircraft and terrain.";
    case Effect::sound:
      return "The sounds of engine and events.";
    case Effect::hud:
      return "Instruments, navigation bar and messages over the picture.";
    case Effect::cloudPlanes:
      return "One to three flat layers of clouds that drift with the wind: cheap, and best from below.";
    case Effect::cloudDome:
      return "Clouds on a dome around the viewer, infinitely far away: the cheapest full sky.";
    case Effect::groundFog:
      return "Fog on the ground, denser the lower: it fills valleys and leaves hills free.";
    case Effect::moon:
      return "The moon with its phase, where place and time put it.";
    case Effect::stars:
      return "The stars that the eye sees at night, turned by place and time.";
    case Effect::landShadows:
      return "Mountains cast shadows on land, sea and aircraft while the sun is low.";
    case Effect::halo:
      return "Halos and sun dogs around sun or moon, where ice lies before them.";
    case Effect::rainbow:
      return "Two rainbows opposite sun or moon, where rain stands there.";
    case Effect::weather:
      return "The air that one flies in: wind by height, turbulence, draughts, density and ice.";
    case Effect::lightShafts:
      return "Clouds and mountains throw shade into the haze: rays of light between them.";
    case Effect::aircraftLights:
      return "Position lights, beacon and strobes of the aircraft, and light over its instruments.";
    case Effect::landingLight:
      return "A lamp in the aircraft's nose that lights the land ahead, on a key.";
    case Effect::iceClouds:
      return "High clouds of ice: strands of cirrus, a veil of cirrostratus, grains of cirrocumulus.";
    case Effect::precipitation:
      return "Rain, snow and hail where the weather has them: around the eye, below distant clouds, on the "
             "land.";
    case Effect::lightning:
      return "Lightning of the weather's storms, the light that it throws, and its thunder.";
    case Effect::places:
      return "Villages: houses that stand in the way, fields with hedges, roads that follow the land, "
             "jetties, "
             "lit windows at night.";
    case Effect::groundCover:
      return "What stands on the ground near by: grass and flowers in patches, reeds at shores, stones and "
             "boulders.";
    case Effect::dustAndSpray:
      return "Dust and smoke on land, drops, rings and wakes on water, where packages, wheels, hull or wreck "
             "touch it.";
    case Effect::vegetation:
      return "Trees that stand: spruces, broadleaves and dwarf pines where the land has woods, bent by the "
             "wind, and in the way of the aircraft.";
    case Effect::groundDetail:
      return "The ground from a few metres: grass, litter, stones, ripples, snow, and rock in layers.";
    case Effect::waterDetail:
      return "Water close by: waves of the wind, whitecaps and surf, the ground below it, and what it "
             "mirrors.";
    case Effect::groundHandling:
      return "The gear bears: taxi, take off and land, ditch; only what is too hard breaks the aircraft. "
             "Without it every touch of the ground is a crash.";
    case Effect::count_:
      break;
  }
  return "";
}

}  // namespace

EffectSwitches switchesOf(const scene::EffectSet& effects) {
  EffectSwitches switches;
  for (std::size_t i = 0; i < switches.on.size(); ++i)
    switches.on[i] = effects.contains(static_cast<Effect>(i));
  return switches;
}

scene::EffectSet EffectSwitches::set() const {
  scene::EffectSet effects;
  for (std::size_t i = 0; i < on.size(); ++i) {
    if (on[i]) effects.insert(static_cast<Effect>(i));
  }
  return effects;
}

void describe(core::SettingsVisitor& visitor, EffectSwitches& switches) {
  for (std::size_t i = 0; i < switches.on.size(); ++i) {
    visitor.flag(scene::kEffectNames[i], switches.on[i],
                 {.help = helpOf(static_cast<Effect>(i)), .takesEffect = core::TakesEffect::rebuild});
  }
}

void requireUsable(const EffectSwitches& switches) {
  if (const std::string missing = scene::unmetNeed(switches.set()); !missing.empty())
    throw core::RangeError("effects: " + missing);
}

}  // namespace skydrop::app
