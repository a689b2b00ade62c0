#include "app/window/menu_controller.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/session/pose_text.h"
#include "app/window/genus_buttons.h"

namespace skydrop::app {
namespace {

// What the file says, where it fits; the rest is complained of.
ui::MenuState readState(const nlohmann::json& content, std::vector<std::string>& complaints) {
  ui::MenuState state;
  const auto isShare = [](const nlohmann::json& side) {
    return side.is_number() && side.get<double>() >= 0 && side.get<double>() <= 1;
  };
  if (const auto place = content.find("place"); place != content.end()) {
    if (place->is_array() && place->size() == 4 && std::ranges::all_of(*place, isShare)) {
      const auto sides = place->get<std::array<float, 4>>();
      if (sides[0] < sides[2] && sides[1] < sides[3]) {
        state.place = ui::ScreenRect{sides[0], sides[1], sides[2], sides[3]};
      } else {
        complaints.emplace_back("place: has no size");
      }
    } else {
      complaints.emplace_back("place: is not four shares of the window");
    }
  }
  const nlohmann::json open = content.value("open", nlohmann::json::object());
  if (!open.is_object()) complaints.emplace_back("open: is not an object");
  for (const auto& [section, isOpen] : open.items()) {
    if (!open.is_object()) break;
    if (isOpen.is_boolean()) {
      state.open[section] = isOpen.get<bool>();
    } else {
      complaints.push_back("open." + section + ": is not true or false");
    }
  }
  return state;
}

bool isSamePlace(const std::optional<ui::ScreenRect>& a, const std::optional<ui::ScreenRect>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->left == b->left && a->top == b->top && a->right == b->right && a->bottom == b->bottom;
}

}  // namespace

MenuController::MenuController(std::optional<std::filesystem::path> userFolder) {
  if (!userFolder) return;
  file_ = KeptFile(*userFolder / "menu.json");
  presetStore_.emplace(presetFolder(*userFolder));
}

ui::MenuTools MenuController::tools(const core::SettingsTable& base, const render::View& view,
                                    std::span<const double> frameMs) {
  // From the scene, and from the program's defaults: whatever stands between them on another machine.
  bases_[0] = &base;
  bases_[1] = &defaultTable_;
  pose_ = poseText(poseOf(view));
  ui::MenuTools tools{frameMs, bases_, pose_, std::nullopt};
  if (genera_.empty()) genera_ = genusButtons();
  tools.genera = genera_;
  if (presetStore_) {
    if (!presets_) presets_ = presetStore_->list();
    tools.presets = *presets_;
  }
  return tools;
}

MenuController::Served MenuController::serve(const ui::PresetRequest& request,
                                             const core::SettingsTable& table, ui::ConfigurationMenu& menu) {
  if (!presetStore_) return {};
  presets_.reset();
  switch (request.kind) {
    case ui::PresetRequest::Kind::save: {
      const auto aside = presetStore_->save(request.name, table, request.groups);
      const std::string replaced =
          aside ? "; the old one, which is broken, is kept as " + aside->string() : "";
      return {{}, "Saved preset " + request.name + replaced};
    }
    case ui::PresetRequest::Kind::load:
      return {menu.change(table, presetStore_->load(request.name)), "Loaded preset " + request.name};
    case ui::PresetRequest::Kind::remove:
      presetStore_->remove(request.name);
      return {{}, "Deleted preset " + request.name};
  }
  return {};
}

std::optional<std::string> MenuController::load(ui::ConfigurationMenu& menu) {
  if (auto broken = file_.load()) return broken;
  std::vector<std::string> complaints;
  saved_ = readState(file_.content(), complaints);
  menu.setState(saved_);
  return file_.complaintLine(complaints);
}

std::optional<std::string> MenuController::save(const ui::ConfigurationMenu& menu) {
  const ui::MenuState& state = menu.state();
  std::optional<std::string> line = file_.save([&](nlohmann::json& content) {
    if (state.place && !isSamePlace(state.place, saved_.place)) {
      content["place"] = {state.place->left, state.place->top, state.place->right, state.place->bottom};
    }
    nlohmann::json changed = content.value("open", nlohmann::json::object());
    if (!changed.is_object()) changed = nlohmann::json::object();
    for (const auto& [section, isOpen] : state.open) {
      const auto before = saved_.open.find(section);
      if (before == saved_.open.end() || before->second != isOpen) changed[section] = isOpen;
    }
    if (!changed.empty()) content["open"] = changed;
  });
  saved_ = state;
  return line;
}

}  // namespace skydrop::app
