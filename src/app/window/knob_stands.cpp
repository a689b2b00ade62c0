#include "app/window/knob_stands.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <optional>
#include <set>
#include <utility>

#include "app/session/noise_store.h"
#include "skydrop/accuracy/result_file.h"

namespace skydrop::app {
namespace {

namespace fs = std::filesystem;
using accuracy::CaseResult;
using accuracy::PointResult;

std::string text(const char* format, auto... values) {
  char buffer[160];
  std::snprintf(buffer, sizeof buffer, format, values...);
  return buffer;
}

// Whether all that the point turns has its value now; nothing where it turns what is no setting.
std::optional<bool> isPresent(const PointResult& point, const core::SettingsTable& table) {
  if (point.set.empty()) return std::nullopt;
  bool present = true;
  for (const std::string& assignment : point.set) {
    const std::size_t equals = assignment.find('=');
    const core::Field* field = table.find(assignment.substr(0, equals));
    if (!field || equals == std::string::npos) return std::nullopt;
    present = present && core::fieldText(*field) == assignment.substr(equals + 1);
  }
  return present;
}

std::string namesOf(const PointResult& point) {
  std::string names;
  for (const std::string& assignment : point.set)
    names += (names.empty() ? "" : ", ") + assignment.substr(0, assignment.find('='));
  return names;
}

double errorOf(const PointResult& point) { return std::abs(point.errors.front()); }

// "medium: relative RMSE 0.111 for 220 ms; the next better, high, costs 2.5 times"
std::string standOf(const CaseResult& of, const PointResult& present, const std::vector<std::size_t>& front) {
  std::string line = present.label + ": " + of.metrics.front().title +
                     text(" %.3g for %.3g ms", errorOf(present), present.medianMs());
  for (const std::size_t i : front) {
    const PointResult& other = of.points[i];
    if (errorOf(other) < errorOf(present) && other.medianMs() <= present.medianMs())
      return line + "; " + other.label + " is better and costs no more";
  }
  for (const std::size_t i : front) {
    const PointResult& other = of.points[i];
    if (errorOf(other) < errorOf(present))
      return line + "; the next better, " + other.label +
             text(", costs %.2g times", other.medianMs() / present.medianMs());
  }
  return line + "; the best that was measured";
}

std::optional<ui::KnobStand> standOf(const CaseResult& of, const core::SettingsTable& table) {
  if (of.metrics.empty()) return std::nullopt;
  ui::KnobStand stand;
  const std::vector<std::size_t> front = accuracy::paretoFront(of, 0);
  std::vector<std::size_t> byTime;
  for (std::size_t i = 0; i < of.points.size(); ++i) {
    const PointResult& point = of.points[i];
    if (!isPresent(point, table)) return std::nullopt;
    if (point.isMeasured() && errorOf(point) > 0 && point.medianMs() > 0) byTime.push_back(i);
  }
  if (byTime.empty()) return std::nullopt;
  std::ranges::stable_sort(byTime, {}, [&](std::size_t i) { return of.points[i].medianMs(); });
  for (const std::size_t i : byTime) {
    const PointResult& point = of.points[i];
    if (*isPresent(point, table)) stand.present = static_cast<int>(stand.points.size());
    stand.points.push_back({point.medianMs(), errorOf(point), std::ranges::find(front, i) != front.end()});
  }
  stand.title = namesOf(of.points[byTime.front()]) + " (" + of.name + ")";
  stand.text = stand.present < 0
                   ? "The present value is not among those that were measured."
                   : standOf(of, of.points[byTime[static_cast<std::size_t>(stand.present)]], front);
  return stand;
}

}  // namespace

std::vector<ui::KnobStand> knobStands(const accuracy::Results& results, const core::SettingsTable& table) {
  std::vector<ui::KnobStand> stands;
  std::set<std::string> studies;
  for (const CaseResult& of : results.cases) {
    if (studies.contains(of.study)) continue;
    std::optional<ui::KnobStand> stand = standOf(of, table);
    if (!stand) continue;
    studies.insert(of.study);
    stands.push_back(std::move(*stand));
  }
  return stands;
}

fs::path measuredFrontsFolder() {
  const fs::path cache = cacheFolder();
  return cache.empty() ? fs::path() : cache / "accuracy";
}

MeasuredFronts readMeasuredFronts(const fs::path& folder) {
  MeasuredFronts fronts;
  if (folder.empty()) {
    fronts.note = "Not measured here: there is no cache folder.";
    return fronts;
  }
  std::error_code ignored;
  if (!fs::exists(folder / accuracy::kResultFile, ignored)) {
    fronts.note = "Not measured here: run skydrop accuracy --quick --out " + folder.string();
    return fronts;
  }
  try {
    fronts.results = accuracy::readResults(folder);
  } catch (const std::exception& broken) {
    fronts.note = broken.what();
  }
  return fronts;
}

}  // namespace skydrop::app
