// Noise far from the origin, with positions kept in several ways.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <type_traits>

#include "app/studies/subjects.h"
#include "app/studies/table_subject.h"
#include "skydrop/core/shared.h"

namespace skydrop::app {
namespace {

namespace f32 = core::shared::f32;
namespace f64 = core::shared::f64;

enum class Arithmetic { exact, extended, doubles, cellSplit, floats };
constexpr std::array<std::string_view, 5> kArithmeticNames = {"exact", "extended", "doubles", "cellSplit",
                                                              "floats"};

struct FarNoiseParameters {
  Arithmetic arithmetic = Arithmetic::cellSplit;
  double distanceM = 0;
};

void describe(core::SettingsVisitor& visitor, FarNoiseParameters& p) {
  visitor.choice("arithmetic", p.arithmetic, kArithmeticNames, {.help = "What positions are kept in."});
  visitor.number("distanceM", p.distanceM, {.unit = "m", .min = 0, .max = 1e12, .help = "From the origin."});
}

constexpr double kCellM = 16;  // a power of two: a place in cells is exact

// Places are a whole number of cells and a whole number of 1/1024 of one: exact in double up to 1e12 m.
template <class Real>
double noiseAt(std::int64_t cell, Real inside) {
  const glm::u32vec2 column(static_cast<std::uint32_t>(cell), 7u);
  if constexpr (std::is_same_v<Real, float>) {
    return f32::latticeNoise(column, {inside, 0.37f}).x;
  } else {
    return f64::latticeNoise(column, {static_cast<double>(inside), 0.37}).x;
  }
}

// The cell is looked for in Real: where that resolves no place in it any more, noise has steps.
template <class Real>
double noiseOf(Real metres) {
  const Real cells = metres / static_cast<Real>(kCellM);
  const Real whole = std::floor(cells);
  return noiseAt<Real>(static_cast<std::int64_t>(whole), cells - whole);
}

double farNoise(const FarNoiseParameters& p, std::int64_t index) {
  constexpr int kParts = 1024;
  const auto first = static_cast<std::int64_t>(p.distanceM / kCellM);
  const std::int64_t cell = first + index / 8;
  const double inside = static_cast<double>((index * 389) % kParts) / kParts;
  const double metres = (static_cast<double>(cell) + inside) * kCellM;
  switch (p.arithmetic) {
    case Arithmetic::exact:
      return noiseAt<double>(cell, inside);
    case Arithmetic::extended:
      return noiseOf<long double>(metres);
    case Arithmetic::doubles:
      return noiseOf<double>(metres);
    case Arithmetic::cellSplit:
      return noiseAt<float>(cell, static_cast<float>(inside));
    case Arithmetic::floats:
      return noiseOf<float>(static_cast<float>(metres));
  }
  return 0;
}

class FarNoiseSubject final : public TableSubject<FarNoiseParameters> {
  accuracy::Observation compute(const FarNoiseParameters& p) override {
    accuracy::Observation observation;
    for (std::int64_t i = 0; i < kPlaces; ++i) observation.values.push_back(farNoise(p, i));
    return observation;
  }
  double work(const FarNoiseParameters& p) override {
    double sum = 0;
    for (std::int64_t i = 0; i < kPlaces; ++i) sum += farNoise(p, i);
    return sum;
  }
  static constexpr std::int64_t kPlaces = 4096;
};

}  // namespace

std::unique_ptr<accuracy::Subject> makeFarNoiseSubject() { return std::make_unique<FarNoiseSubject>(); }

}  // namespace skydrop::app
