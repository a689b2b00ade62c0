#include "skydrop/scene/effect.h"

namespace skydrop::scene {

EffectSet withNeeds(EffectSet effects) {
  for (std::size_t round = 0; round < kEffectNeeds.size(); ++round) {  // needs of needs
    for (const EffectNeed& need : kEffectNeeds) {
      if (effects.contains(need.effect)) effects.insert(need.needs);
    }
  }
  return effects;
}

std::string unmetNeed(const EffectSet& effects) {
  for (const EffectNeed& need : kEffectNeeds) {
    if (!effects.contains(need.effect) || effects.contains(need.needs)) continue;
    return std::string(nameOf(need.effect)) + " needs " + std::string(nameOf(need.needs)) + ", which is off";
  }
  return "";
}

EffectSet effective(EffectSet effects) {
  const bool showsSomething = effects.contains(Effect::terrain) || effects.contains(Effect::clouds) ||
                              effects.contains(Effect::cloudPlanes) || effects.contains(Effect::cloudDome) ||
                              effects.contains(Effect::aircraft) || effects.contains(Effect::groundFog) ||
                              effects.contains(Effect::iceClouds);
  if (!showsSomething) effects.erase(Effect::haze);
  if (!effects.contains(Effect::terrain)) effects.erase(Effect::landShadows);
  if (!effects.contains(Effect::aircraft)) {
    effects.erase(Effect::aircraftLights);
    effects.erase(Effect::landingLight);
  }
  if (!effects.contains(Effect::aircraft) || !effects.contains(Effect::terrain))
    effects.erase(Effect::dustAndSpray);
  if (!effects.contains(Effect::weather)) effects.erase(Effect::lightning);
  const bool shades = effects.contains(Effect::landShadows) ||
                      (effects.contains(Effect::clouds) && effects.contains(Effect::terrain));
  if (!effects.contains(Effect::haze) || !shades) effects.erase(Effect::lightShafts);
  return effects;
}

}  // namespace skydrop::scene
