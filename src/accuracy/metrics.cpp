#include "skydrop/accuracy/metrics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "skydrop/accuracy/flip.h"
#include "skydrop/core/error.h"
#include "skydrop/core/quantile.h"

namespace skydrop::accuracy {
namespace {

using Values = std::vector<double>;

double meanMagnitude(const Values& values) {
  double sum = 0;
  for (const double value : values) sum += std::abs(value);
  const double mean = sum / static_cast<double>(values.size());
  return mean > 0 ? mean : 1;
}

double bias(const Observation& a, const Observation& r) {
  double sum = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i) sum += a.values[i] - r.values[i];
  return sum / static_cast<double>(a.values.size()) / meanMagnitude(r.values);
}

double rootMeanSquare(const Observation& a, const Observation& r) {
  double sum = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    const double difference = a.values[i] - r.values[i];
    sum += difference * difference;
  }
  return std::sqrt(sum / static_cast<double>(a.values.size()));
}

double quantileOfDifference(const Observation& a, const Observation& r, double quantile) {
  Values differences(a.values.size());
  for (std::size_t i = 0; i < differences.size(); ++i) differences[i] = std::abs(a.values[i] - r.values[i]);
  return core::quantileOf(differences, quantile);
}

double largestDistance(const Observation& a, const Observation& r) {
  double largest = 0;
  for (std::size_t i = 0; i < a.positions.size(); ++i)
    largest = std::max(largest, glm::length(a.positions[i] - r.positions[i]));
  return largest;
}

// By the sine of half the angle, which resolves small ones (acos would not).
double largestAngle(const Observation& a, const Observation& r) {
  double largest = 0;
  for (std::size_t i = 0; i < a.attitudes.size(); ++i) {
    const glm::dquat d = glm::conjugate(a.attitudes[i]) * r.attitudes[i];
    const double sine = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
    largest = std::max(largest, 2 * std::atan2(sine, std::abs(d.w)));
  }
  return largest * 180 / std::numbers::pi;
}

double meanAngle(const Observation& a, const Observation& r) {
  double sum = 0;
  for (std::size_t i = 0; i < a.directions.size(); ++i) {
    const double angle = std::atan2(glm::length(glm::cross(a.directions[i], r.directions[i])),
                                    glm::dot(a.directions[i], r.directions[i]));
    sum += angle * angle;
  }
  return std::sqrt(sum / static_cast<double>(a.directions.size())) * 180 / std::numbers::pi;
}

double largestEnergyError(const Observation& a, const Observation& r) {
  double largest = 0;
  for (std::size_t i = 0; i < a.energies.size(); ++i) {
    const double scale = std::abs(r.energies[i]);
    largest = std::max(largest, std::abs(a.energies[i] - r.energies[i]) / (scale > 0 ? scale : 1));
  }
  return largest;
}

std::size_t sizeOf(const Observation& o, std::string_view part) {
  if (part == "values") return o.values.size();
  if (part == "picture") return o.seen.size();
  if (part == "positions") return o.positions.size();
  if (part == "directions") return o.directions.size();
  if (part == "attitudes") return o.attitudes.size();
  return o.energies.size();
}

}  // namespace

const std::vector<Metric>& metrics() {
  static const std::vector<Metric> all = {
      {"relativeRmse", "relative RMSE", "1", "values",
       [](const Observation& a, const Observation& r) {
         return rootMeanSquare(a, r) / meanMagnitude(r.values);
       }},
      {"bias", "bias", "1", "values", bias},
      {"p99", "99th percentile", "1", "values",
       [](const Observation& a, const Observation& r) {
         return quantileOfDifference(a, r, 0.99) / meanMagnitude(r.values);
       }},
      {"largest", "largest error", "1", "values",
       [](const Observation& a, const Observation& r) {
         return quantileOfDifference(a, r, 1) / meanMagnitude(r.values);
       }},
      {"rmse", "RMSE", "", "values", rootMeanSquare},
      {"worst", "largest error", "", "values",
       [](const Observation& a, const Observation& r) { return quantileOfDifference(a, r, 1); }},
      {"flip", "FLIP", "1", "picture",
       [](const Observation& a, const Observation& r) {
         return flip({a.width, a.height, a.seen}, {r.width, r.height, r.seen});
       }},
      {"metres", "distance", "m", "positions", largestDistance},
      {"degrees", "angle", "degrees", "attitudes", largestAngle},
      {"directionDegrees", "angle, RMS", "degrees", "directions", meanAngle},
      {"relativeEnergy", "relative energy", "1", "energies", largestEnergyError},
  };
  return all;
}

const Metric* findMetric(std::string_view name) {
  const auto found = std::ranges::find(metrics(), name, &Metric::name);
  return found == metrics().end() ? nullptr : &*found;
}

std::string unitOf(const Metric& metric, const Observation& observation) {
  return metric.unit.empty() ? observation.unit : std::string(metric.unit);
}

void requireMeasurable(const Metric& metric, const Observation& a, const Observation& r) {
  const std::size_t size = sizeOf(a, metric.needs);
  if (size == 0) {
    throw core::RangeError("the metric " + std::string(metric.name) + " needs " + std::string(metric.needs) +
                           ", which this subject does not give");
  }
  if (size != sizeOf(r, metric.needs) || a.width != r.width || a.height != r.height) {
    throw core::RangeError("the metric " + std::string(metric.name) +
                           " compares what has not the reference's shape");
  }
}

}  // namespace skydrop::accuracy
