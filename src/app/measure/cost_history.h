// What each part of a frame took over the last frames, for the panel of costs: kept only while that is open.
// A value; one thread.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "skydrop/ui/cost_panel.h"

namespace skydrop::app {

class CostHistory {
 public:
  // Frames that are kept: about four seconds at 60 Hz.
  static constexpr std::size_t kKept = 240;
  // Medians, quantiles and shares are renewed every so many frames; graphs with each.
  static constexpr int kFramesToRenew = 30;

  // Of the frame that endFrame() closes, ms. A part that is not named in a frame took nothing in it.
  void add(ui::CostKind kind, std::string_view name, double ms);
  // The same of a meter that only counts up (ms since some start): what it has gained since the last frame.
  void addTotal(ui::CostKind kind, std::string_view name, double totalMs);
  void endFrame();

  // In the order in which they were first named, parts that never took anything left out. Valid until the
  // next call that is not const.
  std::span<const ui::CostRow> rows() const { return rows_; }

 private:
  struct Part {
    ui::CostKind kind;
    std::string name;
    std::vector<float> ms;  // a ring of kKept
    float now = 0;
    double totalMs = -1;  // -1: not seen yet
  };
  Part& part(ui::CostKind kind, std::string_view name);
  void renew();
  void spread();  // the rings into rows_, oldest first

  std::vector<Part> parts_;
  std::vector<ui::CostRow> rows_;
  std::vector<double> sorted_;  // to reuse its memory
  std::size_t frames_ = 0;      // that were closed
};

}  // namespace skydrop::app
