#include "app/session/picture_texts.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "app/session/pose_text.h"
#include "app/types/version.h"
#include "skydrop/core/settings_file.h"
#include "skydrop/core/settings_table.h"

namespace skydrop::app {
namespace {

std::string settingsText(const RunConfig& run) {
  Settings settings = run.settings;
  const core::SettingsTable table(settings);
  nlohmann::json values = core::toJson(table, /*onlyChanged=*/true);
  values.merge_patch(core::toJson(run.table, /*onlyChanged=*/true));
  values.erase("input");
  values.erase("quality");  // what it sets is among the others
  nlohmann::json groups = nlohmann::json::array();
  for (const auto& [name, value] : values.items()) groups.push_back(name);
  const nlohmann::json preset = {{"schema", core::kSettingsSchema}, {"groups", groups}, {"settings", values}};
  return preset.dump(-1, ' ', /*ensure_ascii=*/true);
}

std::string secondsText(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g s", seconds);
  return text;
}

}  // namespace

std::vector<core::PictureText> pictureTexts(const RunConfig& run, const game::Snapshot& drawn,
                                            const render::View& view) {
  std::vector<core::PictureText> texts = {{"Software", programName()}};
  if (!run.setup.scene.name.empty()) texts.push_back({"Scene", run.setup.scene.name});
  texts.push_back({"Seed", std::to_string(run.setup.seed)});
  texts.push_back({"Time", secondsText(drawn.simulatedSeconds)});
  texts.push_back({"Pose", poseText(poseOf(view))});
  texts.push_back({"Settings", settingsText(run)});
  return texts;
}

}  // namespace skydrop::app
