// The tuned numbers of the game's rules. Plain values; describe() states and enforces the ranges
// at every entry (files, --set, the menu).
#pragma once

#include "skydrop/core/settings.h"

namespace skydrop::game {

struct GameSettings {
  double targetRadius = 100;        // m, 5 .. 1000
  double targetNearest = 2000;      // m from the aircraft, 200 .. 20000
  double targetFarthest = 6000;     // m from the aircraft, 300 .. 40000
  double targetSlopeDeg = 20;       // degrees, 1 .. 80, of the steepest ground for a target
  double dropCooldown = 2;          // s from one drop to the next, 0 .. 60
  double landedPackageSeconds = 8;  // s until it is removed, 0 .. 600
  double crashSeconds = 2.5;        // s from crash to respawn, 0.1 .. 30
  double contactHeight = 1.5;       // m, 0 .. 20, of the aircraft's middle above what its belly touches
  double safeHeight = 60;           // m above ground that a safe place needs, 5 .. 1000
  double respawnBackSeconds = 4;    // s before the crash, at least; 0 .. 30
  double messageSeconds = 3;        // s that a message shows, 0.5 .. 30
};

void describe(core::SettingsVisitor& visitor, GameSettings& settings);

}  // namespace skydrop::game
