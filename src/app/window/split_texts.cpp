#include "app/window/split_texts.h"

#include <cstdio>
#include <vector>

#include "skydrop/accuracy/flip.h"

namespace skydrop::app {
namespace {

constexpr int kScaleColors = 32;

std::string errorText(double rmse, double relativeRmse) {
  char text[96];
  std::snprintf(text, sizeof text, "RMSE %.3g (%.3g %% of the mean)", rmse, 100 * relativeRmse);
  return text;
}

std::string flipText(double flip) {
  char text[48];
  std::snprintf(text, sizeof text, ", mean FLIP %.3g", flip);
  return text;
}

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.0f %%", 100 * share);
  return text;
}

std::vector<std::uint32_t> scaleColors() {
  std::vector<double> errors(kScaleColors);
  for (int i = 0; i < kScaleColors; ++i) errors[static_cast<std::size_t>(i)] = (i + 0.5) / kScaleColors;
  const core::Image image = accuracy::heatMap(errors, kScaleColors, 1);
  std::vector<std::uint32_t> colors;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    colors.push_back(image.rgba[i] | std::uint32_t{image.rgba[i + 1]} << 8 |
                     std::uint32_t{image.rgba[i + 2]} << 16 | 0xff000000u);
  return colors;
}

std::string noteOf(const SplitView& split) {
  const auto error = split.error();
  if (error && error->isComplete())
    return errorText(error->rmse, error->relativeRmse) + flipText(*error->flip) +
           (split.isCoarser() ? "; the land's budget is full" : "");
  const std::string refining = "Reference: " + percent(split.share());
  if (!error) return refining;
  return refining + ", " + errorText(error->rmse, error->relativeRmse) + " so far";
}

}  // namespace

ui::SplitLabels splitLabels(const SplitView& split, const SplitSettings& settings) {
  const SplitReference& reference = split.reference();
  const std::string what(kSplitSubjectNames[static_cast<std::size_t>(reference.subject)]);
  const auto error = split.error();
  ui::SplitLabels labels;
  labels.left = what + ": " + reference.present;
  labels.right = what + ": " + reference.name;
  labels.note = noteOf(split);
  labels.divider = settings.divider;
  if (settings.heat && error && error->isComplete()) {
    labels.right = "error (FLIP) of " + labels.left;
    labels.scale = scaleColors();
  }
  return labels;
}

std::string splitLine(const core::SplitStatistics& split) {
  return "split " + split.reference + ": " + errorText(split.rmse, split.relativeRmse) + flipText(split.flip);
}

}  // namespace skydrop::app
