#include "app/settings/governed_rows.h"

#include <algorithm>

#include "app/settings/cloud_tier.h"
#include "app/settings/settings.h"
#include "skydrop/core/error.h"

namespace skydrop::app {
namespace {

constexpr std::string_view kScaleRow = "render.picture.scale";

std::string pathOf(const std::string& assignment) { return assignment.substr(0, assignment.find('=')); }

}  // namespace

bool mayGovern(const core::Field& field) {
  const bool isStudied =
      field.path == kCloudTierRow || belongsToCloudTier(field.path) || field.path == kScaleRow;
  const bool isAtOnce =
      core::isWhileHeld(field.takesEffect) || field.takesEffect == core::TakesEffect::variant;
  return isStudied && isAtOnce && !decidesSimulation(field.path);
}

GovernedRows governedRows(const accuracy::Assignments& set, std::string_view file) {
  Settings settings;
  const core::SettingsTable table(settings);
  std::vector<std::string> paths;
  const auto add = [&](const std::string& path) {
    if (std::ranges::find(paths, path) == paths.end()) paths.push_back(path);
  };
  try {
    // A tier first, whatever the order: other rows of its knob are put over those of its file.
    accuracy::Assignments ordered = set;
    std::ranges::stable_partition(ordered,
                                  [&](const std::string& one) { return pathOf(one) == kCloudTierRow; });
    for (const std::string& one : ordered) {
      const core::Field& field = table.at(pathOf(one));
      if (!mayGovern(field)) throw core::DataError(file, field.path, "no frame budget may turn this");
      core::setField(table, one);
      add(field.path);
      if (field.path != kCloudTierRow) continue;
      if (settings.clouds.tier == clouds::CloudTier::off)
        throw core::DataError(file, field.path, "a frame budget switches no effect off");
      applyCloudTier(table, readCloudTier(cloudTierPath(settings.clouds.tier)));
      for (const core::Field& row : table.fields()) {
        if (belongsToCloudTier(row.path)) add(row.path);
      }
    }
  } catch (const core::RangeError& refusal) {
    throw core::DataError(file, "set", refusal.what());
  }
  GovernedRows rows;
  for (const std::string& path : paths) rows.emplace_back(path, table.at(path).get());
  return rows;
}

}  // namespace skydrop::app
