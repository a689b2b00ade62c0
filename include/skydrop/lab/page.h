// The pages of the laboratory: each shows one technique that clouds are made of, with its knobs, its cost and
// its error. Pages are data; what they show is computed by shaders/shared/lab, drawn by render::LabView and
// measured here, on the processor, from the same text.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "skydrop/core/settings_table.h"

namespace skydrop::lab {

// The knobs of an open page: its described settings. Must not move, as the table refers to it.
class Knobs {
 public:
  virtual ~Knobs() = default;
  virtual const core::SettingsTable& table() const = 0;
};

template <class Settings>
class KnobsOf final : public Knobs {
 public:
  explicit KnobsOf(const Settings& defaults = {}) : settings(defaults) {
    Settings own = defaults;
    table_.takeDefaults(core::SettingsTable(own));
  }
  KnobsOf(const KnobsOf&) = delete;
  KnobsOf& operator=(const KnobsOf&) = delete;
  const core::SettingsTable& table() const override { return table_; }

  Settings settings;

 private:
  core::SettingsTable table_{settings};
};

// Cost and error as measured: a table, and the one sentence that sums it up.
struct Figures {
  std::vector<std::string> columns;
  std::vector<std::string> labels;  // of the rows, below the first column; may be empty
  std::vector<std::vector<double>> rows;
  std::string summary;
};

// Curves that a page's picture plots, each of kPlotPlaces values in [0, 1] from left to right, 0 below.
inline constexpr std::size_t kPlotPlaces = 24;
using Curve = std::array<float, kPlotPlaces>;
inline constexpr std::size_t kMostCurves = 4;

// A cube of pairs of values that a page's picture samples, x the fastest; repeats in each direction.
struct Volume {
  int side = 0;
  std::vector<float> pairs;  // 2 side^3
};

struct Page {
  std::string_view name;          // of --page: "sphere-tracing"
  std::string_view title;         // "Sphere tracing"
  std::string_view chapter;       // that its shader is named by: "march"
  std::string_view variant;       // what the shader is compiled with: "PAGE_SPHERE_TRACING"
  std::string_view text;          // a paragraph: what is seen where, and what to try
  bool everySecondPixel = false;  // drawn at half the size, for what takes long
  std::function<std::unique_ptr<Knobs>()> makeKnobs = {};
  // Take the knobs that this page made. A fraction of a second; any thread.
  std::function<Figures(const Knobs&)> measure = {};
  std::function<std::vector<Curve>(const Knobs&)> plot = {};  // may be empty: nothing to plot
  std::function<Volume(const Knobs&)> volume = {};            // may be empty: no volume to sample
};

// All pages, in the order of the list.
std::span<const Page> pages();

// Throws core::RangeError with the nearest names.
const Page& pageNamed(std::string_view name);

// The table of figures as text: Markdown, or plain columns.
std::string figuresText(const Figures& figures, bool asMarkdown);

}  // namespace skydrop::lab
