// The interface of the noise tool: rows of its settings at the left, the texture beside them. Says what the
// user wants; a changed row is set in the table, all else is the caller's business. Drawn between
// Interface::beginFrame and endFrame. Main thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "skydrop/core/settings_table.h"
#include "skydrop/ui/imgui_context.h"

namespace skydrop::ui {

// A picture to be shown: the name of a GL texture, 0 for none, square, first row at the top.
struct ToolPicture {
  std::uint32_t texture = 0;
  bool tiled = false;    // 2 x 2; the texture repeats
  bool overSky = false;  // its transparent parts show sky
  bool upsideDown = false;
};

struct NoiseToolContent {
  const core::SettingsTable& table;
  // Paths of the rows that are shown, by headings.
  struct Section {
    std::string_view title;
    std::vector<std::string_view> rows;
  };
  std::span<const Section> sections;
  std::span<const ToolPicture> pictures = {};  // one or two
  std::span<const float> histogram = {};
  std::string_view status = {};                   // size and time of what is shown
  std::optional<double> progress = std::nullopt;  // of what is being made
  std::string_view message = {};                  // of the last file that was saved or opened
  bool canSave = true;
  bool canUseInSky = false;  // shows the button "Use in the sky"
};

struct NoiseToolResult {
  bool changed = false;                   // a row was set
  bool held = false;                      // the mouse holds its slider: more may follow
  std::optional<std::string> save, open;  // a file's path
  bool useInSky = false;
  std::optional<std::string> refusal;  // why a typed value was not set
};

class NoiseToolView {
 public:
  NoiseToolView();
  ~NoiseToolView();

  NoiseToolResult draw(const Interface& context, const NoiseToolContent& content);

  // Where the last frame drew a row's widget (by path) or a button (by its label), for tests.
  std::optional<ScreenRect> placeOf(std::string_view name) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace skydrop::ui
