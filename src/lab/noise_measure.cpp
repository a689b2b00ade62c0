#include "skydrop/lab/noise_measure.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <set>

#include "lab/chapters.h"
#include "skydrop/lab/shared.h"

namespace skydrop::lab {
namespace {

namespace f32 = core::shared::f32;
namespace f64 = core::shared::f64;

}  // namespace

RandomError randomError(double from) {
  constexpr int kCount = 4096;
  RandomError error;
  std::set<float> sines, hashes;
  for (int i = 0; i < kCount; ++i) {
    const double x = from + i;
    const float inFloat = f32::sineRandom2(glm::vec2(static_cast<float>(x), 3));
    sines.insert(inFloat);
    error.sineApart += std::abs(inFloat - f64::sineRandom2({x, 3})) > 0.01 ? 1.0 / kCount : 0;
    const glm::u32vec2 cell(static_cast<std::uint32_t>(static_cast<std::int64_t>(x)), 3);
    const float hashed = f32::hashRandom2(cell);
    hashes.insert(hashed);
    error.hashApart += hashed != f64::hashRandom2(cell) ? 1.0 / kCount : 0;
  }
  error.sineDistinct = static_cast<double>(sines.size()) / kCount;
  error.hashDistinct = static_cast<double>(hashes.size()) / kCount;
  return error;
}

Smoothness smoothnessOf(const NoisePlane& noise, int cells) {
  constexpr double kStep = 1e-6;
  constexpr int kRows = 200;
  Smoothness found;
  double sum = 0, squares = 0;
  int count = 0;
  for (int column = 1; column < cells; ++column) {
    const double x = static_cast<double>(column) / cells;
    for (int row = 0; row < kRows; ++row) {
      const double y = (row + 0.371) / kRows;
      const double far = noise(x - 2 * kStep, y), before = noise(x - kStep, y), after = noise(x + kStep, y),
                   beyond = noise(x + 2 * kStep, y);
      found.largestJump = std::max(found.largestJump, std::abs(after - before));
      found.largestSlopeJump =
          std::max(found.largestSlopeJump, std::abs((beyond - after) - (before - far)) / kStep);
    }
  }
  for (int i = 0; i < kRows * kRows; ++i) {
    const double value = noise((i % kRows + 0.19) / kRows, (i / kRows + 0.43) / kRows);
    sum += value;
    squares += value * value;
    ++count;
  }
  found.mean = sum / count;
  found.deviation = std::sqrt(std::max(squares / count - found.mean * found.mean, 0.0));
  return found;
}

OwnCellError ownCellError(const VoronoiKnobs& knobs) {
  constexpr int kSide = 200;
  OwnCellError error;
  const auto cells = static_cast<std::uint32_t>(knobs.cells), salt = static_cast<std::uint32_t>(knobs.seed);
  for (int i = 0; i < kSide * kSide; ++i) {
    const glm::dvec2 place((i % kSide + 0.5) / kSide, (i / kSide + 0.5) / kSide);
    const double apart = f64::ownVoronoi(place, cells, salt) - f64::nearVoronoi(place, cells, salt);
    error.wrongShare += apart > 1e-9 ? 1.0 / (kSide * kSide) : 0;
    error.meanError += apart / (kSide * kSide);
  }
  return error;
}

double tileError(const VoronoiKnobs& knobs, bool mended) {
  const auto period = static_cast<int>(knobs.period);
  const auto salt = static_cast<std::uint32_t>(knobs.seed);
  double most = 0;
  // Sixteenths of a cell: sums with whole periods are exact.
  for (int y = -48; y < 48; y += 5) {
    for (int x = -160; x < 160; ++x) {
      const glm::vec2 place(static_cast<float>(x) / 16, static_cast<float>(y) / 16);
      const glm::vec2 next = place + glm::vec2(static_cast<float>(period), 0);
      most = std::max<double>(most, std::abs(f32::tiledVoronoi(place, period, salt, mended) -
                                             f32::tiledVoronoi(next, period, salt, mended)));
    }
  }
  return most;
}

Curve histogramOf(const NoisePlane& noise, double low, double high) {
  constexpr int kSide = 128;
  Curve counts{};
  for (int i = 0; i < kSide * kSide; ++i) {
    const double value = noise((i % kSide + 0.5) / kSide, (i / kSide + 0.5) / kSide);
    const double share = std::clamp((value - low) / (high - low), 0.0, 0.9999);
    counts[static_cast<std::size_t>(share * kPlotPlaces)] += 1;
  }
  const float most = *std::ranges::max_element(counts);
  for (float& count : counts) count /= most;
  return counts;
}

Curve spectrumOf(const NoisePlane& noise) {
  constexpr int kSamples = 128, kRows = 16;
  constexpr double kDecades = 6;
  std::array<double, kPlotPlaces> power{};
  for (int row = 0; row < kRows; ++row) {
    std::array<double, kSamples> line{};
    for (int i = 0; i < kSamples; ++i)
      line[static_cast<std::size_t>(i)] = noise((i + 0.5) / kSamples, (row + 0.5) / kRows);
    for (std::size_t place = 0; place < kPlotPlaces; ++place) {
      const double frequency =
          std::floor(std::pow(64.0, static_cast<double>(place) / (kPlotPlaces - 1)) + 0.5);
      double real = 0, imaginary = 0;
      for (int i = 0; i < kSamples; ++i) {
        const double angle = 2 * std::numbers::pi * frequency * i / kSamples;
        real += line[static_cast<std::size_t>(i)] * std::cos(angle);
        imaginary += line[static_cast<std::size_t>(i)] * std::sin(angle);
      }
      power[place] += real * real + imaginary * imaginary;
    }
  }
  const double most = std::max(*std::ranges::max_element(power), 1e-300);
  Curve curve{};
  for (std::size_t i = 0; i < kPlotPlaces; ++i)
    curve[i] = static_cast<float>(
        std::clamp(1 + std::log10(std::max(power[i] / most, 1e-300)) / kDecades, 0.0, 1.0));
  return curve;
}

double megasampleMs(const NoisePlane& noise) {
  constexpr int kSide = 64, kTimes = 4;
  double least = 0;
  for (int time = 0; time < kTimes; ++time) {
    const auto begin = std::chrono::steady_clock::now();
    double sum = 0;
    for (int i = 0; i < kSide * kSide; ++i)
      sum += noise((i % kSide + 0.5) / kSide, (i / kSide + 0.5) / kSide);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (!std::isfinite(sum)) return 0;
    if (time == 0 || seconds < least) least = seconds;
  }
  return 1e9 * least / (kSide * kSide);
}

}  // namespace skydrop::lab
