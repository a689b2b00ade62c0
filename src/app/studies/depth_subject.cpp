// What formats of the depth buffer keep of a distance.
#include <algorithm>
#include <array>
#include <cmath>

#include "app/studies/subjects.h"
#include "app/studies/table_subject.h"
#include "skydrop/core/shared.h"

namespace skydrop::app {
namespace {

namespace f64 = core::shared::f64;

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

}  // namespace

std::unique_ptr<accuracy::Subject> makeDepthSubject() { return std::make_unique<DepthSubject>(); }

}  // namespace skydrop::app
