// The panel of costs: what each part of a frame takes, over the last frames, and where settings stand between
// error and time, as it was measured. Drawn between Interface::beginFrame and endFrame. Main thread.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "skydrop/ui/imgui_context.h"

namespace skydrop::ui {

// By whom a part's time was taken: passes by the renderer's clock, the others by CPU time of the main thread.
enum class CostKind { pass, simulation, update };

struct CostRow {
  CostKind kind = CostKind::pass;
  std::string name;
  std::vector<float> ms;           // of the last frames, oldest first
  double medianMs = 0, p99Ms = 0;  // over those
  double share = 0;                // of the time of all rows, 0 .. 1
};

// A setting that was measured: points of error and time, and where the present value is.
struct KnobStand {
  struct Point {
    double ms = 0, error = 0;  // > 0
    bool onFront = false;      // no other point is both cheaper and better
  };
  std::string title;  // "clouds.tier"
  std::string text;   // one line: what the present value costs, and the next better one
  std::vector<Point> points;
  int present = -1;  // of the points; -1: the value was not among them
};

struct CostPanelContent {
  std::span<const CostRow> rows;
  std::span<const double> frameMs;  // of the last frames, oldest first
  std::string_view clock;           // that timed the passes
  std::span<const KnobStand> knobs;
  std::string_view note;         // in place of the knobs, or about them; empty: none
  std::string_view budget = {};  // a line about the frame budget that is held; empty: there is none
};

// Returns false when the player has closed it in this frame.
bool drawCostPanel(const Interface& context, const CostPanelContent& content);

}  // namespace skydrop::ui
