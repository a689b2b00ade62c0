// The effects of a flight as settings, one switch each: a scene sets them, --effect, --no-effect, --set and
// the menu change them. They belong to the flight: the player's file does not keep them.
#pragma once

#include <array>

#include "skydrop/core/settings.h"
#include "skydrop/scene/effect.h"

namespace skydrop::app {

struct EffectSwitches {
  std::array<bool, scene::kEffectNames.size()> on{};  // by scene::Effect

  // As they are switched; scene::effective() leaves those out that have nothing to do.
  scene::EffectSet set() const;
  bool operator==(const EffectSwitches&) const = default;
};

EffectSwitches switchesOf(const scene::EffectSet& effects);

void describe(core::SettingsVisitor& visitor, EffectSwitches& switches);

// Throws core::RangeError, in one line, where one is on that rests on another that is off.
void requireUsable(const EffectSwitches& switches);

}  // namespace skydrop::app
