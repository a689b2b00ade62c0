// Subjects that are about the numbers themselves: noise far from the origin, depth, targets.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/gtc/packing.hpp>
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

enum class DepthFormat { exact, float64, reversedFloat32, float32, unorm24, unorm16 };
constexpr std::array<std::string_view, 6> kDepthNames = {"exact",   "float64", "reversedFloat32",
                                                         "float32", "unorm24", "unorm16"};

struct DepthParameters {
  DepthFormat format = DepthFormat::reversedFloat32;
  double distanceM = 1000, nearM = 0.1;
};

void describe(core::SettingsVisitor& visitor, DepthParameters& p) {
  visitor.choice("format", p.format, kDepthNames, {.help = "What keeps a depth."});
  visitor.number("distanceM", p.distanceM, {.unit = "m", .min = 0.2, .max = 1e6, .help = "Around it."});
  visitor.number("nearM", p.nearM, {.unit = "m", .min = 0.01, .max = 5, .help = "Of the near plane."});
}

// The distance that comes back from what was kept. Of the formats that are not reversed the far plane is at
// 100 km.
double keptDistance(const DepthParameters& p, double z) {
  constexpr double kFarM = 1e5;
  const double n = p.nearM;
  const double share = kFarM / (kFarM - n);
  const double depth = share * (1 - n / z);
  const auto back = [&](double kept) { return n / (1 - kept / share); };
  const auto steps = [&](double count) { return std::round(depth * count) / count; };
  switch (p.format) {
    case DepthFormat::exact:
      return z;
    case DepthFormat::float64:
      return f64::viewZOfDepth(f64::depthOfViewZ(z, n), n);
    case DepthFormat::reversedFloat32:
      return f64::viewZOfDepth(static_cast<float>(f64::depthOfViewZ(z, n)), n);
    case DepthFormat::float32:  // what has become 1 is as far as can be told apart from it
      return back(std::min<double>(static_cast<float>(depth), 1 - 0x1p-24));
    case DepthFormat::unorm24:
      return back(std::min(steps(16777215), 1 - 0.5 / 16777215));
    case DepthFormat::unorm16:
      return back(std::min(steps(65535), 1 - 0.5 / 65535));
  }
  return z;
}

class DepthSubject final : public TableSubject<DepthParameters> {
  accuracy::Observation compute(const DepthParameters& p) override {
    accuracy::Observation observation;
    observation.unit = "m";
    for (int i = 0; i < kPlaces; ++i) observation.values.push_back(keptDistance(p, placeOf(p, i)));
    return observation;
  }
  double work(const DepthParameters& p) override {
    double sum = 0;
    for (int i = 0; i < kPlaces; ++i) sum += keptDistance(p, placeOf(p, i));
    return sum;
  }
  static constexpr int kPlaces = 1000;
  static double placeOf(const DepthParameters& p, int i) { return p.distanceM * (1 + 1e-4 * i); }
};

enum class TargetFormat { exact, float32, float16, float11, unorm8 };
constexpr std::array<std::string_view, 5> kTargetNames = {"exact", "float32", "float16", "float11", "unorm8"};

struct TargetParameters {
  TargetFormat format = TargetFormat::float16;
  double brightest = 100;
};

void describe(core::SettingsVisitor& visitor, TargetParameters& p) {
  visitor.choice("format", p.format, kTargetNames, {.help = "What keeps the light of a pixel."});
  visitor.number("brightest", p.brightest,
                 {.unit = "1", .min = 1, .max = 60000, .help = "Light of the brightest pixel; white is 1."});
}

double keptLight(TargetFormat format, double light) {
  switch (format) {
    case TargetFormat::exact:
      return light;
    case TargetFormat::float32:
      return static_cast<float>(light);
    case TargetFormat::float16:
      return glm::unpackHalf1x16(glm::packHalf1x16(static_cast<float>(light)));
    case TargetFormat::float11:
      return glm::unpackF2x11_1x10(glm::packF2x11_1x10(glm::vec3(static_cast<float>(light)))).x;
    case TargetFormat::unorm8:
      return std::round(std::clamp(light, 0.0, 1.0) * 255) / 255;
  }
  return light;
}

// Relative errors of lights that grow by ratios, from a thousandth of white.
class TargetSubject final : public TableSubject<TargetParameters> {
  accuracy::Observation compute(const TargetParameters& p) override {
    accuracy::Observation observation;
    for (int i = 0; i < kLights; ++i)
      observation.values.push_back(keptLight(p.format, lightOf(p, i)) / lightOf(p, i));
    return observation;
  }
  double work(const TargetParameters& p) override {
    double sum = 0;
    for (int i = 0; i < kLights; ++i) sum += keptLight(p.format, lightOf(p, i));
    return sum;
  }
  static constexpr int kLights = 4096;
  static double lightOf(const TargetParameters& p, int i) {
    constexpr double kDarkest = 1e-3;
    return kDarkest * std::pow(p.brightest / kDarkest, (i + 0.5) / kLights);
  }
};

}  // namespace

std::unique_ptr<accuracy::Subject> makeFarNoiseSubject() { return std::make_unique<FarNoiseSubject>(); }
std::unique_ptr<accuracy::Subject> makeDepthSubject() { return std::make_unique<DepthSubject>(); }
std::unique_ptr<accuracy::Subject> makeTargetSubject() { return std::make_unique<TargetSubject>(); }

}  // namespace skydrop::app
