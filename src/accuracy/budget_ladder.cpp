#include "skydrop/accuracy/budget_ladder.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace skydrop::accuracy {
namespace {

std::string_view pathOf(std::string_view assignment) { return assignment.substr(0, assignment.find('=')); }

// The part of the assignments that is of the knob, or that is not.
Assignments part(const Assignments& of, std::string_view knob, bool inside) {
  Assignments all;
  for (const std::string& one : of) {
    if ((knobOf(pathOf(one)) == knob) == inside) all.push_back(one);
  }
  return all;
}

// What is left to turn: "scale 0.5".
std::string labelOf(const Assignments& set) {
  std::string label;
  for (const std::string& one : set) {
    const std::string_view path = pathOf(one);
    label += (label.empty() ? "" : ", ") + std::string(path.substr(path.rfind('.') + 1)) + " " +
             one.substr(std::min(path.size() + 1, one.size()));
  }
  return label;
}

// A point over all cases; nothing where it was not measured in one of them.
std::optional<PointResult> overCases(const Results& results, const PointResult& first) {
  PointResult point = first;
  double squares = 0, ms = 0;
  for (const CaseResult& of : results.cases) {
    const auto same = std::ranges::find(of.points, first.label, &PointResult::label);
    if (same == of.points.end() || !same->isMeasured()) return std::nullopt;
    const double error = same->errors.front(), time = same->medianMs();
    if (!std::isfinite(error) || !std::isfinite(time) || time <= 0) return std::nullopt;
    squares += error * error;
    ms += time;
  }
  if (!std::isfinite(squares) || !std::isfinite(ms)) return std::nullopt;
  const auto count = static_cast<double>(results.cases.size());
  point.errors = {std::sqrt(squares / count)};
  point.ms = {ms / count};
  return point;
}

// Takes the knob out of the points: see budgetLadder().
void hold(std::vector<PointResult>& points, std::string_view knob, const Assignments& held) {
  if (points.empty()) return;
  const auto sorted = [&](const Assignments& of) {
    Assignments all = part(of, knob, true);
    std::ranges::sort(all);
    return all;
  };
  const Assignments wanted = sorted(held), last = sorted(points.back().set);
  const auto has = [&](const Assignments& value) {
    return [&](const PointResult& point) { return sorted(point.set) == value; };
  };
  const Assignments& value = std::ranges::any_of(points, has(wanted)) ? wanted : last;
  std::erase_if(points, [&](const PointResult& point) { return !has(value)(point); });
  for (PointResult& point : points) {
    point.set = part(point.set, knob, false);
    if (!point.set.empty()) point.label = labelOf(point.set);
  }
}

}  // namespace

std::string_view knobOf(std::string_view path) { return path.substr(0, path.find('.')); }

std::vector<BudgetRung> budgetLadder(const Results& results, const Assignments& held) {
  if (results.cases.empty()) return {};
  CaseResult all;
  for (const PointResult& first : results.cases.front().points) {
    if (auto point = overCases(results, first)) all.points.push_back(std::move(*point));
  }
  for (const std::string& one : held) hold(all.points, knobOf(pathOf(one)), held);
  std::vector<BudgetRung> ladder;
  for (const std::size_t i : paretoFront(all, 0)) {
    const PointResult& point = all.points[i];
    BudgetRung rung{point.label, point.ms.front(), point.errors.front(), point.set};
    if (!ladder.empty() && rung.error >= ladder.back().error) continue;  // the same in every respect
    if (!ladder.empty() && rung.ms < kLeastStep * ladder.back().ms) {
      ladder.back() = std::move(rung);
    } else {
      ladder.push_back(std::move(rung));
    }
  }
  return ladder;
}

}  // namespace skydrop::accuracy
