// The fronts of error over time that a frame budget chooses from: those measured on this machine, which
// `skydrop accuracy calibrate` keeps in the cache folder, or else the shipped ones. Any thread.
#pragma once

#include <filesystem>
#include <string>

#include "app/settings/governed_rows.h"
#include "app/types/size.h"
#include "skydrop/accuracy/result.h"
#include "skydrop/scene/scene.h"

namespace skydrop::app {

// What fronts are measured for.
struct BudgetFrontKey {
  std::string scene, sceneText;  // its name and content
  std::string renderer;          // as OpenGL names it
  Size size;                     // pixels

  static BudgetFrontKey of(const scene::Scene& scene, const std::string& renderer, Size size);
  std::string machine() const;  // as CaseResult::machine has it
  // In the folder `budget` of the cache: the name has scene and size, and a hash of all and of the version.
  std::filesystem::path file(const std::filesystem::path& cacheFolder) const;
};

struct BudgetFronts {
  accuracy::Results results;
  std::string file;       // that they come from
  bool measured = false;  // on this machine; else shipped
  std::string source;     // "measured on this machine", or that they are shipped, and how to measure them
  std::string warning;    // why measured ones cannot be used; else empty
};

constexpr std::size_t kMostFrontBytes = std::size_t{1} << 20;

// Results that a budget can choose from, judged: every point sets rows that a budget may turn. Throws
// core::DataError.
accuracy::Results parseBudgetFronts(std::string_view text, std::string_view file);

// Measured ones where there are some for the key; a damaged file is reported in `warning`. Throws
// core::DataError where the shipped ones cannot be read.
BudgetFronts findBudgetFronts(const BudgetFrontKey& key, const std::filesystem::path& cacheFolder);

// Keeps them for the key, atomically; the file. Throws core::DataError.
std::filesystem::path keepBudgetFronts(const accuracy::Results& results, const BudgetFrontKey& key,
                                       const std::filesystem::path& cacheFolder);

}  // namespace skydrop::app
