#include <algorithm>
#include <array>
#include <cmath>

#include "app/studies/subjects.h"
#include "app/studies/table_subject.h"
#include "skydrop/clouds/reference_march.h"
#include "skydrop/core/shared.h"

namespace skydrop::app {
namespace {

namespace f64 = core::shared::f64;

enum class MarchMethod { analytic, sum };
constexpr std::array<std::string_view, 2> kMethodNames = {"analytic", "sum"};

enum class MarchView { below, inside, above, far };
constexpr std::array<std::string_view, 4> kViewNames = {"below", "inside", "above", "far"};

struct MarchParameters {
  MarchMethod method = MarchMethod::analytic;
  MarchView view = MarchView::below;
  std::int64_t steps = 64, sunSamples = 64;
};

void describe(core::SettingsVisitor& visitor, MarchParameters& p) {
  visitor.choice(
      "method", p.method, kMethodNames,
      {.help = "The analytic integral over each step, or density x step x transmittance x light."});
  visitor.choice("view", p.view, kViewNames, {.help = "Where the rays begin; far is low and almost level."});
  visitor.integer("steps", p.steps, {.unit = "1", .min = 2, .max = 16384, .help = "Through the layer."});
  visitor.integer("sunSamples", p.sunSamples, {.unit = "1", .min = 1, .max = 4096, .help = "To the sun."});
}

constexpr clouds::MarchLight kLight{.toSun = {0.48, 0.6, 0.64}, .anisotropy = 0.12, .forwardShare = 0.15};
constexpr int kRays = 24;

// Billows of 400 m, 0.04 1/m at most, smooth everywhere.
clouds::MarchMedium billows() {
  clouds::MarchMedium medium;
  medium.baseM = 1500, medium.topM = 2700;
  medium.extinction = [](const glm::dvec3& p) {
    const double height = (p.y - 1500) / 1200;
    if (height <= 0 || height >= 1) return 0.0;
    constexpr double kWave = 2 * 3.141592653589793 / 800;
    const double billow =
        0.5 + 0.5 * std::sin(p.x * kWave) * std::sin(p.z * kWave + 0.5) * std::sin(p.y * kWave);
    const double body = 4 * height * (1 - height);
    return 0.04 * body * body * billow * billow;
  };
  return medium;
}

clouds::MarchRay rayOf(MarchView view, int index) {
  const auto ray = [&](double heightM, double elevationDegrees) -> clouds::MarchRay {
    const double elevation = glm::radians(elevationDegrees), azimuth = glm::radians(15.0 * index);
    return {{0, heightM, 0},
            {std::cos(elevation) * std::cos(azimuth), std::sin(elevation),
             std::cos(elevation) * std::sin(azimuth)}};
  };
  switch (view) {
    case MarchView::inside:
      return ray(2100, -57.5 + 5 * index);
    case MarchView::above:
      return ray(3800, -12.0 - 3 * index);
    case MarchView::far:
      return ray(400, 4 + 0.2 * index);
    case MarchView::below:
      break;
  }
  return ray(400, 12.0 + 3 * index);
}

// The form that games use: each sample's light is weakened by what lies before it, itself not counted.
clouds::MarchResult plainSum(const clouds::MarchMedium& medium, const clouds::MarchRay& ray,
                             const MarchParameters& p) {
  clouds::MarchResult result;
  const double toBase = (medium.baseM - ray.origin.y) / ray.direction.y;
  const double toTop = (medium.topM - ray.origin.y) / ray.direction.y;
  const double begin = std::max(0.0, std::min(toBase, toTop)), end = std::max(toBase, toTop);
  const double step = (end - begin) / static_cast<double>(p.steps);
  const f64::Vec4 phases =
      f64::cloudPhases(glm::dot(ray.direction, kLight.toSun), kLight.anisotropy, kLight.forwardShare);
  for (std::int64_t i = 0; i < p.steps; ++i) {
    const glm::dvec3 at = ray.origin + ray.direction * (begin + (static_cast<double>(i) + 0.5) * step);
    const double sigma = medium.extinction(at);
    if (sigma > 0) {
      const double depth = clouds::sunDepth(medium, kLight.toSun, at, static_cast<int>(p.sunSamples));
      result.sun += result.transmittance * sigma * step * f64::scatteredSun(phases, depth);
    }
    result.transmittance *= std::exp(-sigma * step);
  }
  return result;
}

class MarchSubject final : public TableSubject<MarchParameters> {
  clouds::MarchResult march(const MarchParameters& p, int ray) const {
    if (p.method == MarchMethod::sum) return plainSum(medium_, rayOf(p.view, ray), p);
    return clouds::referenceMarch(medium_, kLight, rayOf(p.view, ray),
                                  {static_cast<int>(p.steps), static_cast<int>(p.sunSamples)});
  }
  accuracy::Observation compute(const MarchParameters& p) override {
    accuracy::Observation observation;
    for (int i = 0; i < kRays; ++i) observation.values.push_back(march(p, i).sun);
    return observation;
  }
  double work(const MarchParameters& p) override {
    double sum = 0;
    for (int i = 0; i < kRays; ++i) sum += march(p, i).sun;
    return sum;
  }
  const clouds::MarchMedium medium_ = billows();
};

}  // namespace

std::unique_ptr<accuracy::Subject> makeMarchSubject() { return std::make_unique<MarchSubject>(); }

}  // namespace skydrop::app
