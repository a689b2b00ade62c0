#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <map>
#include <optional>
#include <vector>

#include "app/studies/subjects.h"
#include "app/studies/table_subject.h"
#include "skydrop/core/error.h"
#include "skydrop/sky/atmosphere.h"
#include "skydrop/sky/reference_paths.h"
#include "skydrop/sky/reference_sky.h"

namespace skydrop::app {
namespace {

namespace f64 = core::shared::f64;
using glm::dvec3;

enum class SkyMethod { closedForm, integral, shell, reference };
constexpr std::array<std::string_view, 4> kMethodNames = {"closedForm", "integral", "shell", "reference"};
enum class SkyQuantity { transmittance, singleScattering, radiance };
constexpr std::array<std::string_view, 3> kQuantityNames = {"transmittance", "singleScattering", "radiance"};
enum class SkyChannel { red, green, blue };
constexpr std::array<std::string_view, 3> kChannelNames = {"red", "green", "blue"};

struct SkyParameters {
  SkyMethod method = SkyMethod::closedForm;
  SkyQuantity quantity = SkyQuantity::transmittance;
  std::int64_t steps = 32;
  std::int64_t paths = 4000;
  SkyChannel channel = SkyChannel::green;
  double sunElevationDegrees = 40;
};

void describe(core::SettingsVisitor& visitor, SkyParameters& p) {
  visitor.choice(
      "method", p.method, kMethodNames,
      {.help = "The game's closed form, a sum of steps in flat layers; of the radiance: the game's two "
               "models, and single scattering by steps with the rest by random paths."});
  visitor.choice("quantity", p.quantity, kQuantityNames, {.help = "What is compared."});
  visitor.integer("steps", p.steps, {.unit = "1", .min = 2, .max = 4096, .help = "Of the integral."});
  visitor.integer(
      "paths", p.paths,
      {.unit = "1",
       .min = 2,
       .max = 1 << 20,
       .help = "Of the reference's radiance, a direction. The first of more are those of fewer."});
  visitor.choice("channel", p.channel, kChannelNames, {.help = "Of the radiance."});
  visitor.number("sunElevationDegrees", p.sunElevationDegrees,
                 {.unit = "degree", .min = -30, .max = 90, .help = "Above the horizon."});
}

constexpr double kEyeM = 500, kEarthM = 6.371e6, kTopM = 100e3;
constexpr int kDirections =
    24;  // from 2 degrees above the horizon to the zenith, towards and away from the sun

f64::Atmosphere air() { return sky::makeAtmosphere(100000, 1200, 0.7); }

// A path over the round earth from a height, at a zenith angle by its cosine.
struct Path {
  double fromM, cosine;
  double heightAt(double lengthM) const {
    const double r = kEarthM + fromM;
    return std::sqrt(r * r + lengthM * lengthM + 2 * r * lengthM * cosine) - kEarthM;
  }
  double cosineAt(double lengthM) const {
    return ((kEarthM + fromM) * cosine + lengthM) / (kEarthM + heightAt(lengthM));
  }
  double lengthM() const {
    const double r = kEarthM + fromM, top = kEarthM + kTopM;
    return -r * cosine + std::sqrt(r * r * (cosine * cosine - 1) + top * top);
  }
};

struct Extinction {
  dvec3 air;
  double haze;
  dvec3 all() const { return air + dvec3(haze); }
};
Extinction extinctionAt(const f64::Atmosphere& a, double heightM) {
  return {a.rayleigh * f64::densityAt(heightM, a.rayleighHeight),
          a.haze * f64::densityAt(heightM, a.hazeHeight)};
}

// Midpoints of steps that grow with the square of their number: air is dense near the eye.
template <class Visit>
void forSteps(const Path& path, std::int64_t steps, const Visit& visit) {
  const double length = path.lengthM();
  double from = 0;
  for (std::int64_t i = 0; i < steps; ++i) {
    const double share = static_cast<double>(i + 1) / static_cast<double>(steps);
    const double to = length * share * share;
    visit(0.5 * (from + to), to - from);
    from = to;
  }
}

dvec3 depthOf(const f64::Atmosphere& a, const Path& path, std::int64_t steps) {
  dvec3 depth(0);
  forSteps(path, steps,
           [&](double at, double length) { depth += extinctionAt(a, path.heightAt(at)).all() * length; });
  return depth;
}

dvec3 scattered(const f64::Atmosphere& a, const Path& path, double cosSun, double cosBetween,
                std::int64_t steps) {
  dvec3 light(0), depth(0);
  const double byAir = f64::rayleighPhase(cosBetween);
  const double byHaze = a.hazeAlbedo * f64::henyeyGreenstein(cosBetween, a.hazeAnisotropy);
  forSteps(path, steps, [&](double at, double length) {
    const double height = path.heightAt(at);
    const Extinction here = extinctionAt(a, height);
    const dvec3 half = here.all() * (0.5 * length);
    // Over the distances of this path the sun's direction stays, but not its zenith angle.
    const Path toSun{height, std::min(1.0, cosSun + (path.cosineAt(at) - path.cosine) * cosBetween)};
    const dvec3 sun = glm::exp(-depthOf(a, toSun, std::max<std::int64_t>(2, steps / 2)));
    light += glm::exp(-depth - half) * sun * (here.air * byAir + dvec3(here.haze * byHaze)) * length;
    depth += 2.0 * half;
  });
  return light;
}

dvec3 valueOf(const SkyParameters& p, int index) {
  const f64::Atmosphere a = air();
  const int half = kDirections / 2;
  const double elevation = glm::radians(2 + 88.0 * (index % half) / (half - 1));
  const double cosine = std::sin(elevation), cosSun = std::sin(glm::radians(p.sunElevationDegrees));
  const double along = index < half ? 1 : -1;  // towards the sun, or away from it
  const double cosBetween =
      cosine * cosSun + along * std::cos(elevation) * std::cos(glm::radians(p.sunElevationDegrees));
  const Path path{kEyeM, cosine};
  if (p.quantity == SkyQuantity::transmittance) {
    if (p.method == SkyMethod::integral) return glm::exp(-depthOf(a, path, p.steps));
    return f64::exp3(-f64::opticalDepthAbove(a, kEyeM) * f64::airMass(cosine));
  }
  if (p.method == SkyMethod::integral) return scattered(a, path, cosSun, cosBetween, p.steps);
  const f64::SkyColumn column = f64::make_skyColumn(a, kEyeM, cosSun);
  const f64::SkySource source = f64::skySource(column, a, cosine);
  // Without ozone, which the integral leaves out too.
  const dvec3 once = source.rayleigh * f64::rayleighPhase(cosBetween) +
                     source.haze * f64::henyeyGreenstein(cosBetween, a.hazeAnisotropy);
  return once / f64::ozoneTransmittance(cosSun);
}

// The dome: rings of equal solid angle.
std::vector<sky::ReferenceRay> dome(double sunElevationDegrees) {
  constexpr int kRings = 6, kSectors = 6;
  std::vector<sky::ReferenceRay> rays;
  for (int i = 0; i < kRings * kSectors; ++i) {
    rays.push_back({kEyeM, (i / kSectors + 0.5) / kRings,
                    std::cos(glm::pi<double>() * (i % kSectors + 0.5) / kSectors),
                    std::sin(glm::radians(sunElevationDegrees))});
  }
  return rays;
}

// The reference's radiance over the dome. Keeps that of the last sun, for other channels and for more paths,
// which are added.
class ReferenceDome {
 public:
  const std::vector<dvec3>& radiances(double sunElevationDegrees, int steps, int paths) {
    const bool isOther = sun_ != sunElevationDegrees || steps_ != steps;
    if (isOther || (paths < most_ && !byPaths_.contains(paths))) begin(sunElevationDegrees, steps);
    std::vector<dvec3>& all = byPaths_[paths];
    if (!all.empty()) return all;
    for (std::size_t i = 0; i < once_.size(); ++i) all.push_back(once_[i] + paths_[i].upTo(paths).mean);
    most_ = paths;
    return all;
  }

 private:
  void begin(double sunElevationDegrees, int steps) {
    static const sky::ReferenceSky reference(air());
    if (sun_ != sunElevationDegrees || steps_ != steps) {
      sun_ = sunElevationDegrees;
      steps_ = steps;
      once_.clear();
      byPaths_.clear();
      for (const sky::ReferenceRay& ray : dome(sunElevationDegrees))
        once_.push_back(reference.once(ray, steps));
    }
    paths_.clear();
    for (const sky::ReferenceRay& ray : dome(sunElevationDegrees))
      paths_.emplace_back(reference, ray, paths_.size());
    most_ = 0;
  }

  std::optional<double> sun_;
  int steps_ = 0, most_ = 0;
  std::vector<dvec3> once_;
  std::vector<sky::ReferencePaths> paths_;
  std::map<int, std::vector<dvec3>> byPaths_;
};

// The whole sky's radiance over the dome by the game, per irradiance of the sun, without the night's.
std::vector<double> radiances(const SkyParameters& p) {
  if (p.method == SkyMethod::integral) throw core::RangeError("method: 'integral' has no radiance");
  const auto channel = static_cast<glm::length_t>(p.channel);
  const double elevation = glm::radians(p.sunElevationDegrees);
  const sky::SkyLight light =
      sky::skyLight(air(), {std::cos(elevation), std::sin(elevation), 0}, kEyeM,
                    p.method == SkyMethod::shell ? sky::SkyModel::shell : sky::SkyModel::closedForm);
  std::vector<double> values;
  for (const sky::ReferenceRay& ray : dome(p.sunElevationDegrees)) {
    const double across = std::sqrt(1 - ray.sine * ray.sine);
    const dvec3 direction(across * ray.cosAzimuth, ray.sine,
                          across * std::sqrt(std::max(1 - ray.cosAzimuth * ray.cosAzimuth, 0.0)));
    values.push_back((sky::skyRadiance(light, direction) - light.night)[channel] / light.sunOutside[channel]);
  }
  return values;
}

class SkySubject final : public TableSubject<SkyParameters> {
  accuracy::Observation compute(const SkyParameters& p) override {
    accuracy::Observation observation;
    if (p.quantity == SkyQuantity::radiance) {
      observation.values = radiancesOf(p);
      return observation;
    }
    for (int i = 0; i < kDirections; ++i) {
      const dvec3 value = valueOf(p, i);
      observation.values.insert(observation.values.end(), {value.x, value.y, value.z});
    }
    return observation;
  }
  double work(const SkyParameters& p) override {
    if (p.quantity == SkyQuantity::radiance) return radiancesOf(p).back();
    double sum = 0;
    for (int i = 0; i < kDirections; ++i) sum += valueOf(p, i).y;
    return sum;
  }
  std::vector<double> radiancesOf(const SkyParameters& p) {
    if (p.method != SkyMethod::reference) return radiances(p);
    std::vector<double> values;
    for (const dvec3& radiance :
         reference_.radiances(p.sunElevationDegrees, static_cast<int>(p.steps), static_cast<int>(p.paths)))
      values.push_back(radiance[static_cast<glm::length_t>(p.channel)]);
    return values;
  }

  ReferenceDome reference_;
};

}  // namespace

std::unique_ptr<accuracy::Subject> makeSkySubject() { return std::make_unique<SkySubject>(); }

}  // namespace skydrop::app
