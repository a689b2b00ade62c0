#include "app/menu_desk.h"

#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "app/pose_text.h"
#include "skydrop/core/error.h"
#include "skydrop/core/settings_file.h"

namespace skydrop::app {
namespace {

std::filesystem::path stateFile(const std::filesystem::path& userFolder) { return userFolder / "menu.json"; }

ui::MenuState readState(const std::filesystem::path& file) {
  const nlohmann::json json = core::readSettingsFile(file);
  ui::MenuState state;
  try {
    if (json.contains("place")) {
      const auto sides = json["place"].get<std::array<float, 4>>();
      for (const float side : sides) {
        if (!(side >= 0 && side <= 1))
          throw core::DataError(file.string(), "place", "is not within the window");
      }
      state.place = ui::ScreenRect{sides[0], sides[1], sides[2], sides[3]};
    }
    state.open = json.value("open", std::map<std::string, bool>());
  } catch (const nlohmann::json::exception& error) {
    throw core::DataError(file.string(), "menu", error.what());
  }
  return state;
}

}  // namespace

MenuDesk::MenuDesk(std::optional<std::filesystem::path> userFolder) : userFolder_(std::move(userFolder)) {
  if (userFolder_) shelf_.emplace(presetFolder(*userFolder_));
}

ui::MenuTools MenuDesk::tools(const core::SettingsTable& base, const render::View& view,
                              std::span<const double> frameMs) {
  // From the scene, and from the program's defaults: whatever stands between them on another machine.
  bases_[0] = &base;
  bases_[1] = &defaultTable_;
  pose_ = poseText(poseOf(view));
  ui::MenuTools tools{frameMs, bases_, pose_, std::nullopt};
  if (shelf_) {
    if (!presets_) presets_ = shelf_->list();
    tools.presets = *presets_;
  }
  return tools;
}

MenuDesk::Served MenuDesk::serve(const ui::PresetRequest& request, const core::SettingsTable& table,
                                 ui::ConfigurationMenu& menu) {
  if (!shelf_) return {};
  presets_.reset();
  switch (request.kind) {
    case ui::PresetRequest::Kind::save:
      shelf_->save(request.name, table, request.group);
      return {{}, "Saved preset " + request.name};
    case ui::PresetRequest::Kind::load:
      return {menu.change(table, shelf_->load(request.name)), "Loaded preset " + request.name};
    case ui::PresetRequest::Kind::remove:
      shelf_->remove(request.name);
      return {{}, "Deleted preset " + request.name};
  }
  return {};
}

std::optional<std::string> MenuDesk::load(ui::ConfigurationMenu& menu) const {
  if (!userFolder_) return std::nullopt;
  const std::filesystem::path file = stateFile(*userFolder_);
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return std::nullopt;
  try {
    menu.setState(readState(file));
    return std::nullopt;
  } catch (const core::DataError& refusal) {
    std::filesystem::rename(file, file.string() + ".bad", error);
    return refusal.what();
  }
}

void MenuDesk::save(const ui::ConfigurationMenu& menu) const {
  if (!userFolder_) return;
  const ui::MenuState& state = menu.state();
  if (!state.place && state.open.empty()) return;
  nlohmann::json json = {{"open", state.open}};
  if (state.place)
    json["place"] = {state.place->left, state.place->top, state.place->right, state.place->bottom};
  core::writeSettingsFile(stateFile(*userFolder_), json);
}

}  // namespace skydrop::app
