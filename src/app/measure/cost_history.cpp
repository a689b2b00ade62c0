#include "app/measure/cost_history.h"

#include <algorithm>
#include <utility>

#include "skydrop/core/quantile.h"

namespace skydrop::app {

CostHistory::Part& CostHistory::part(ui::CostKind kind, std::string_view name) {
  const auto found =
      std::ranges::find_if(parts_, [&](const Part& part) { return part.kind == kind && part.name == name; });
  if (found != parts_.end()) return *found;
  parts_.push_back({kind, std::string(name), std::vector<float>(kKept, 0.0f)});
  return parts_.back();
}

void CostHistory::add(ui::CostKind kind, std::string_view name, double ms) {
  part(kind, name).now += static_cast<float>(ms);
}

void CostHistory::addTotal(ui::CostKind kind, std::string_view name, double totalMs) {
  Part& of = part(kind, name);
  if (of.totalMs >= 0) of.now += static_cast<float>(std::max(0.0, totalMs - of.totalMs));
  of.totalMs = totalMs;
}

void CostHistory::endFrame() {
  for (Part& part : parts_) part.ms[frames_ % kKept] = std::exchange(part.now, 0.0f);
  ++frames_;
  if (frames_ % kFramesToRenew == 0 || frames_ == 1) renew();
  spread();
}

void CostHistory::renew() {
  std::vector<ui::CostRow> rows;
  const std::size_t count = std::min(frames_, kKept);
  double sum = 0;
  for (const Part& part : parts_) {
    sorted_.assign(part.ms.begin(), part.ms.begin() + static_cast<std::ptrdiff_t>(count));
    std::ranges::sort(sorted_);
    if (sorted_.back() <= 0) continue;
    ui::CostRow row;
    row.kind = part.kind;
    row.name = part.name;
    row.medianMs = sorted_[core::quantileRank(count, 0.5)];
    row.p99Ms = sorted_[core::quantileRank(count, 0.99)];
    for (const double ms : sorted_) row.share += ms;
    sum += row.share;
    rows.push_back(std::move(row));
  }
  for (ui::CostRow& row : rows) row.share /= sum;
  rows_ = std::move(rows);
}

void CostHistory::spread() {
  const std::size_t count = std::min(frames_, kKept), oldest = frames_ > kKept ? frames_ % kKept : 0;
  for (ui::CostRow& row : rows_) {
    const auto part = std::ranges::find_if(
        parts_, [&](const Part& of) { return of.kind == row.kind && of.name == row.name; });
    const auto split = part->ms.begin() + static_cast<std::ptrdiff_t>(oldest);
    row.ms.assign(split, part->ms.begin() + static_cast<std::ptrdiff_t>(count));
    row.ms.insert(row.ms.end(), part->ms.begin(), split);
  }
}

}  // namespace skydrop::app
