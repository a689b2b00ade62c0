#include "app/session/budget_fronts.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "app/measure/system_info.h"
#include "app/types/version.h"
#include "skydrop/accuracy/budget_ladder.h"
#include "skydrop/accuracy/result_file.h"
#include "skydrop/core/assets.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/hash.h"

namespace skydrop::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kShipped = "budget/fronts.jsonl";

}  // namespace

BudgetFrontKey BudgetFrontKey::of(const scene::Scene& scene, const std::string& renderer, Size size) {
  return {scene.name, scene.text, renderer, size};
}

std::string BudgetFrontKey::machine() const {
  return machineName() + ", " + renderer + ", " + std::to_string(size.width) + " x " +
         std::to_string(size.height);
}

fs::path BudgetFrontKey::file(const fs::path& cacheFolder) const {
  core::StateHasher hash;
  for (const std::string& part : {scene, sceneText, machine(), programName()}) {
    hash.add(std::uint64_t{part.size()});
    for (const char c : part) hash.add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
  }
  std::string name = scene.substr(0, 40);  // whatever a scene is called, the name is a plain one
  for (char& c : name) {
    const bool isPlain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (!isPlain) c = '-';
  }
  std::array<char, 64> rest{};
  std::snprintf(rest.data(), rest.size(), "-%dx%d-%016llx.jsonl", size.width, size.height,
                static_cast<unsigned long long>(hash.value()));
  return cacheFolder / "budget" / (name + rest.data());
}

accuracy::Results parseBudgetFronts(std::string_view text, std::string_view file) {
  bool cutOff = false;
  accuracy::Results results = accuracy::parseResults(text, file, &cutOff);
  if (cutOff) throw core::DataError(file, "", "is cut off");
  if (results.cases.size() > accuracy::kMostCases) throw core::DataError(file, "", "has too many cases");
  for (const accuracy::CaseResult& of : results.cases) {
    if (of.points.size() > accuracy::kMostPoints) throw core::DataError(file, of.id(), "has too many points");
    if (!of.failure.empty()) throw core::DataError(file, of.id(), "failed: " + of.failure);
    for (const accuracy::PointResult& point : of.points) governedRows(point.set, file);
  }
  if (accuracy::budgetLadder(results).empty())
    throw core::DataError(file, "", "has no point that was measured");
  return results;
}

BudgetFronts findBudgetFronts(const BudgetFrontKey& key, const fs::path& cacheFolder) {
  BudgetFronts fronts;
  std::error_code ignored;
  const fs::path file = cacheFolder.empty() ? fs::path() : key.file(cacheFolder);
  if (!file.empty() && fs::exists(file, ignored)) {
    try {
      fronts.results = parseBudgetFronts(core::readTextFile(file, kMostFrontBytes), file.string());
      const bool isOfKey = fronts.results.program == programName() &&
                           std::ranges::all_of(fronts.results.cases, [&](const accuracy::CaseResult& of) {
                             return of.machine == key.machine();
                           });
      if (!isOfKey) throw core::DataError(file.string(), "", "is of another machine or version");
      fronts.file = file.string();
      fronts.measured = true;
      fronts.source = "as measured on this machine";
      return fronts;
    } catch (const core::DataError& broken) {
      fronts.warning = std::string(broken.what()) + "; the shipped fronts are used";
    }
  }
  const fs::path shipped = core::assetPath(kShipped);
  fronts.results = parseBudgetFronts(core::readTextFile(shipped, kMostFrontBytes), shipped.string());
  fronts.file = shipped.string();
  fronts.source = "by shipped fronts; to measure this machine: skydrop accuracy calibrate --scene " +
                  key.scene + " --size " + std::to_string(key.size.width) + "x" +
                  std::to_string(key.size.height);
  return fronts;
}

fs::path keepBudgetFronts(const accuracy::Results& results, const BudgetFrontKey& key,
                          const fs::path& cacheFolder) {
  const fs::path file = key.file(cacheFolder);
  core::makeFolder(file.parent_path());
  core::writeFileAtomically(file, accuracy::resultText(results));
  return file;
}

}  // namespace skydrop::app
