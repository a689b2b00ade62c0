#include "skydrop/clouds/sky_cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "skydrop/core/hash.h"

namespace skydrop::clouds {
namespace {

constexpr int kSide = SkyCover::kSide;
constexpr int kSamples = 8;           // of a column
constexpr int kReach = 8;             // cells to each side that a place sees
constexpr double kLowestBaseM = 200;  // of the layer above the place: nearer ones count as this near
constexpr double kAsymmetry = 0.85;   // mean cosine of what a droplet scatters

std::size_t wrapped(int x, int z) {
  const auto in = [](int i) { return static_cast<std::size_t>((i % kSide + kSide) % kSide); };
  return in(z) * static_cast<std::size_t>(kSide) + in(x);
}

// One column in each cell, somewhere in it.
std::vector<float> columnTransmittances(const CloudField& field, double periodM) {
  const CloudLayerSettings& layer = field.layer();
  const double cellM = periodM / kSide, stepM = layer.thickness / kSamples;
  core::RandomStream random{2, 0};
  std::vector<float> transmittances(static_cast<std::size_t>(kSide) * kSide);
  for (std::size_t i = 0; i < transmittances.size(); ++i) {
    const double x = (static_cast<double>(i % kSide) + random.nextUnit()) * cellM,
                 z = (static_cast<double>(i / kSide) + random.nextUnit()) * cellM;
    double density = 0;
    for (int k = 0; k < kSamples; ++k)
      density += static_cast<double>(field.densityInFloat({x, layer.cloudHeight + (k + 0.5) * stepM, z}));
    transmittances[i] = static_cast<float>(diffuseTransmittance(density * stepM * layer.extinction));
  }
  return transmittances;
}

}  // namespace

double diffuseTransmittance(double opticalDepth) { return 1 / (1 + 0.75 * (1 - kAsymmetry) * opticalDepth); }

SkyCover::SkyCover(std::shared_ptr<const PackedCloudNoise> noise, const CloudSettings& settings,
                   std::size_t layer)
    : SkyCover(std::move(noise), mediumOf(settings, layer)) {}

SkyCover::SkyCover(std::shared_ptr<const PackedCloudNoise> noise, const LayerMedium& medium)
    : periodM_(weatherPeriod(medium)) {
  const CloudField field(std::move(noise), medium);
  const std::vector<float> columns = columnTransmittances(field, periodM_);
  // A cell at a horizontal distance r seen under a base at h: solid angle times cosine, h^2 / (r^2 + h^2)^2.
  const double heightM = std::max(field.layer().cloudHeight, kLowestBaseM), cellM = periodM_ / kSide;
  std::array<float, (2 * kReach + 1) * (2 * kReach + 1)> weights{};
  double sum = 0;
  const auto weightOf = [&](int dx, int dz) -> float& {
    return weights[static_cast<std::size_t>((dz + kReach) * (2 * kReach + 1) + dx + kReach)];
  };
  for (int dz = -kReach; dz <= kReach; ++dz) {
    for (int dx = -kReach; dx <= kReach; ++dx) {
      const double square = (dx * dx + dz * dz) * cellM * cellM + heightM * heightM;
      weightOf(dx, dz) = static_cast<float>(heightM * heightM / (square * square));
      sum += static_cast<double>(weightOf(dx, dz));
    }
  }
  for (float& weight : weights) weight = static_cast<float>(static_cast<double>(weight) / sum);
  shares_.resize(columns.size());
  for (int z = 0; z < kSide; ++z) {
    for (int x = 0; x < kSide; ++x) {
      float share = 0;
      for (int dz = -kReach; dz <= kReach; ++dz) {
        for (int dx = -kReach; dx <= kReach; ++dx)
          share += weightOf(dx, dz) * columns[wrapped(x + dx, z + dz)];
      }
      shares_[wrapped(x, z)] = std::min(share, 1.0f);
    }
  }
}

double SkyCover::meanShare() const {
  return std::accumulate(shares_.begin(), shares_.end(), 0.0) / static_cast<double>(shares_.size());
}

double SkyCover::share(const glm::dvec2& place) const {
  const auto axis = [&](double metres) {
    const double turns = metres / periodM_;
    return (turns - std::floor(turns)) * kSide - 0.5;
  };
  const double x = axis(place.x), z = axis(place.y);
  const int x0 = static_cast<int>(std::floor(x)), z0 = static_cast<int>(std::floor(z));
  const double fx = x - x0, fz = z - z0;
  const auto at = [&](int dx, int dz) { return static_cast<double>(shares_[wrapped(x0 + dx, z0 + dz)]); };
  return std::lerp(std::lerp(at(0, 0), at(1, 0), fx), std::lerp(at(0, 1), at(1, 1), fx), fz);
}

}  // namespace skydrop::clouds
