// What effects cost: the study `cost`.
#pragma once

#include <string>
#include <vector>

#include "app/studies/measured_game.h"
#include "app/studies/study.h"

namespace skydrop::app {

extern const ReportHeading kCostHeading;

// A table a scene, and last what the sky costs in its kinds, in the form of Tarantilis (2004), Table 1.
// Throws core::DataError, core::GraphicsUnavailable.
std::vector<StudyResult> costStudy(const StudyOptions& options, const StudyProgress& progress);

// How much is measured.
struct CostEffort {
  Size size;
  int frames;  // of the bill
  int rounds;  // of each comparison
};

// The table of a scene: a row for each effect of the program, one for what belongs to none ("frame"), and one
// for the whole. The effects that are off have zeros. `done` is called after each game that was measured.
StudyResult costOfScene(const std::string& scene, const CostEffort& effort,
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

StudyResult costOfSkies(const std::vector<SkyKind>& kinds, const CostEffort& effort,
                        const std::function<void()>& done = nullptr);

}  // namespace skydrop::app
