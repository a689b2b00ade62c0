#include "accuracy/report_text.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace skydrop::accuracy {
namespace {

std::string inText(const char* format, double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

}  // namespace

std::string shownNumber(double value) { return inText("%.3g", value); }
std::string exactNumber(double value) { return inText("%.17g", value); }

std::string shownError(const CaseResult& result, std::size_t metric, const PointResult& point) {
  const std::optional<double> bound = boundOf(result, metric, point);
  return bound ? "\u2264 " + shownNumber(*bound) : shownNumber(point.errors[metric]);
}

std::string titled(const MetricColumn& metric) {
  return metric.unit.empty() || metric.unit == "1" ? metric.title : metric.title + ", " + metric.unit;
}

std::vector<std::string> remarksOf(const CaseResult& result) {
  std::vector<std::string> lines;
  if (!result.failure.empty()) lines.push_back("Failed: " + result.failure);
  for (const Doubt& doubt : doubts(result))
    lines.push_back("Not justified: " + doubtText(result, doubt) + ".");
  for (const ObservedOrder& order : observedOrders(result, 0)) {
    const std::string of = order.series.empty() ? "" : " of " + order.series;
    lines.push_back("Observed order" + of + " in steps of " + result.order + ": " + shownNumber(order.order) +
                    ".");
  }
  return lines;
}

bool isOnFront(const CaseResult& result, std::size_t metric, std::size_t point) {
  const std::vector<std::size_t> front = paretoFront(result, metric);
  return std::ranges::find(front, point) != front.end();
}

}  // namespace skydrop::accuracy
