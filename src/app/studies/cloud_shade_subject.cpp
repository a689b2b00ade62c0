#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>
#include <memory>

#include "app/session/cloud_noise.h"
#include "app/studies/subjects.h"
#include "app/studies/table_subject.h"
#include "skydrop/clouds/cloud_field.h"
#include "skydrop/clouds/sun_depth.h"
#include "skydrop/core/hash.h"
#include "skydrop/core/shared.h"

namespace skydrop::app {
namespace {

struct CloudShadeParameters {
  std::int64_t samples = clouds::kSunDepthSamples;
  double sunElevationDegrees = 40;
};

void describe(core::SettingsVisitor& visitor, CloudShadeParameters& p) {
  visitor.integer("samples", p.samples, {.unit = "1", .min = 1, .max = 65536, .help = "Towards the sun."});
  visitor.number("sunElevationDegrees", p.sunElevationDegrees,
                 {.unit = "degree", .min = 2, .max = 90, .help = "Above the horizon."});
}

constexpr int kPlaces = 256;
constexpr double kSideM = 50000, kHighestM = 3000;  // of the box that they lie in

// The default clouds.
class CloudShadeSubject final : public TableSubject<CloudShadeParameters> {
  // Share of the sun's light.
  double valueAt(const CloudShadeParameters& p, int index) {
    if (!field_) {
      const CloudNoise noise(NoiseStore(cacheFolder()), Preparation::Maker::processor);
      field_ = std::make_unique<clouds::CloudField>(noise.wait(), clouds::CloudSettings());
    }
    core::RandomStream random{5, static_cast<std::uint64_t>(index) * 4};
    const double x = random.nextUnit(), y = random.nextUnit(), z = random.nextUnit(),
                 turn = random.nextUnit();
    const double elevation = glm::radians(p.sunElevationDegrees), azimuth = 2 * glm::pi<double>() * turn;
    const glm::dvec3 toSun(std::cos(elevation) * std::cos(azimuth), std::sin(elevation),
                           std::cos(elevation) * std::sin(azimuth));
    const glm::dvec3 place(kSideM * x, kHighestM * y, kSideM * z);
    return core::shared::f64::sunBelowCloud(
        clouds::sunOpticalDepth(*field_, place, toSun, static_cast<int>(p.samples)));
  }

  accuracy::Observation compute(const CloudShadeParameters& p) override {
    accuracy::Observation observation;
    for (int i = 0; i < kPlaces; ++i) observation.values.push_back(valueAt(p, i));
    return observation;
  }
  double work(const CloudShadeParameters& p) override {
    double sum = 0;
    for (int i = 0; i < kPlaces; ++i) sum += valueAt(p, i);
    return sum;
  }

  std::unique_ptr<clouds::CloudField> field_;  // null until it is asked for
};

}  // namespace

std::unique_ptr<accuracy::Subject> makeCloudShadeSubject() { return std::make_unique<CloudShadeSubject>(); }

}  // namespace skydrop::app
