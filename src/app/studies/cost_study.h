// What effects cost: the study `cost`.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "app/studies/cost_table.h"
#include "app/studies/measured_game.h"

namespace skydrop::app {

extern const ReportHeading kCostHeading;

struct CostOptions {
  std::vector<std::string> scenes = {};  // to measure; none: all of assets/scenes
  bool quick = false;                    // fewer repetitions
};
// Told before each game that is measured: how many are, of how many.
using CostProgress = std::function<void(std::size_t done, std::size_t all)>;

// A table a scene, and last what the sky costs in its kinds, in the form of Tarantilis (2004), Table 1.
// Throws core::DataError, core::GraphicsUnavailable.
std::vector<CostTable> costStudy(const CostOptions& options, const CostProgress& progress);

// How much is measured.
struct CostEffort {
  Size size;
  int frames;  // of the bill
  int rounds;  // of each comparison
};

// The table of a scene: a row for each effect of the program, one for what belongs to none ("frame"), and one
// for the whole. The effects that are off have zeros. `done` is called after each game that was measured.
CostTable costOfScene(const std::string& scene, const CostEffort& effort,
                      const std::function<void()>& done = nullptr);

// A kind of sky that is added to land under an empty one.
struct SkyKind {
  std::string label;
  std::vector<std::string> effects;  // that are on beside sky and land; a kind of unknown ones is left out
  std::vector<std::string> set = {};
  double sourceFps = 0, sourceDrop = 0;  // frames per second, percent; 0: the source has no such row
};
// Those that this program has, the empty sky first.
std::vector<SkyKind> skyKinds();

CostTable costOfSkies(const std::vector<SkyKind>& kinds, const CostEffort& effort,
                      const std::function<void()>& done = nullptr);

}  // namespace skydrop::app
