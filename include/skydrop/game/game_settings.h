// The tuned numbers of the game's rules.
#pragma once

#include "skydrop/core/settings.h"

namespace skydrop::game {

struct GameSettings {
  double targetRadius = 100;        // m
  double targetNearest = 2000;      // m from the aircraft
  double targetFarthest = 6000;     // m
  double targetSlopeDeg = 20;       // degrees, steepest
  double dropCooldown = 2;          // s
  double landedPackageSeconds = 8;  // s until it is removed
  double crashSeconds = 2.5;        // s from crash to respawn
  double contactHeight = 1.5;       // m, of the aircraft's middle above what its belly touches
  double safeHeight = 60;           // m above ground that a safe place needs
  double respawnBackSeconds = 4;    // s before the crash, at least
  double messageSeconds = 3;        // s that a message shows
};

void describe(core::SettingsVisitor& visitor, GameSettings& settings);

}  // namespace skydrop::game
