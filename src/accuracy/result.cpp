#include "skydrop/accuracy/result.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

#include "skydrop/core/quantile.h"

namespace skydrop::accuracy {

double PointResult::medianMs() const { return core::quantileOf(ms, 0.5); }
double PointResult::leastMs() const { return core::quantileOf(ms, 0); }
double PointResult::mostMs() const { return core::quantileOf(ms, 1); }

const CaseResult* Results::find(std::string_view id) const {
  const auto found = std::ranges::find_if(cases, [&](const CaseResult& c) { return c.id() == id; });
  return found == cases.end() ? nullptr : &*found;
}

CaseResult* Results::find(std::string_view id) {
  return const_cast<CaseResult*>(std::as_const(*this).find(id));
}

std::vector<std::size_t> paretoFront(const CaseResult& result, std::size_t metric) {
  struct Candidate {
    std::size_t index;
    double error, ms;
  };
  std::vector<Candidate> all;
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    const PointResult& point = result.points[i];
    if (point.isMeasured()) all.push_back({i, std::abs(point.errors[metric]), point.medianMs()});
  }
  const auto dominates = [](const Candidate& a, const Candidate& b) {
    return a.error <= b.error && a.ms <= b.ms && (a.error < b.error || a.ms < b.ms);
  };
  std::vector<Candidate> front;
  for (const Candidate& c : all) {
    if (std::ranges::none_of(all, [&](const Candidate& other) { return dominates(other, c); }))
      front.push_back(c);
  }
  std::ranges::stable_sort(front, {}, &Candidate::ms);
  std::vector<std::size_t> indices;
  for (const Candidate& c : front) indices.push_back(c.index);
  return indices;
}

std::optional<double> boundOf(const CaseResult& result, std::size_t metric, const PointResult& point) {
  constexpr double kShare = 0.1, kReferenceErrorOverChange = 2;
  const ReferenceResult& reference = result.references[point.reference];
  if (point.errors.empty() || reference.changes.empty()) return {};
  const double error = std::abs(point.errors[metric]), change = reference.changes[metric];
  if (error <= result.metrics[metric].floor || change < kShare * error) return {};
  return error + kReferenceErrorOverChange * change;
}

std::vector<Doubt> doubts(const CaseResult& result) {
  std::vector<Doubt> all;
  for (std::size_t m = 0; m < result.metrics.size(); ++m) {
    for (std::size_t r = 0; r < result.references.size(); ++r) {
      const ReferenceResult& reference = result.references[r];
      if (reference.changes.empty()) continue;
      std::optional<Doubt> largest;
      bool isResolved = false;
      for (std::size_t i = 0; i < result.points.size(); ++i) {
        const PointResult& point = result.points[i];
        if (point.reference != r || point.errors.empty()) continue;
        const double error = std::abs(point.errors[m]);
        if (error <= result.metrics[m].floor) continue;
        isResolved = isResolved || !boundOf(result, m, point);
        if (!largest || error > largest->error) largest = Doubt{m, r, i, reference.changes[m], error};
      }
      if (largest && !isResolved) all.push_back(*largest);
    }
  }
  return all;
}

std::string doubtText(const CaseResult& result, const Doubt& doubt) {
  std::array<char, 96> numbers{};
  std::snprintf(numbers.data(), numbers.size(), "by %.3g, more than a tenth of the largest error %.3g",
                doubt.change, doubt.error);
  return "doubling the reference changes " + result.metrics[doubt.metric].title + " " + numbers.data() +
         " of '" + result.points[doubt.point].label + "'";
}

std::vector<ObservedOrder> observedOrders(const CaseResult& result, std::size_t metric) {
  std::map<std::string, std::vector<std::pair<double, double>>> series;
  std::vector<std::string> names;
  for (const PointResult& point : result.points) {
    if (!point.step || *point.step <= 0 || point.errors.empty()) continue;
    const double error = std::abs(point.errors[metric]);
    if (error <= result.metrics[metric].floor) continue;
    if (!series.contains(point.series)) names.push_back(point.series);
    series[point.series].emplace_back(std::log(*point.step), std::log(error));
  }
  std::vector<ObservedOrder> orders;
  for (const std::string& name : names) {
    const auto& points = series[name];
    if (points.size() < 3) continue;
    double x = 0, y = 0, xx = 0, xy = 0;
    for (const auto& [step, error] : points) x += step, y += error, xx += step * step, xy += step * error;
    const auto n = static_cast<double>(points.size());
    const double spread = n * xx - x * x;
    if (spread > 0) orders.push_back({name, (n * xy - x * y) / spread});
  }
  return orders;
}

}  // namespace skydrop::accuracy
