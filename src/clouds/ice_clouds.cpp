#include "skydrop/clouds/ice_clouds.h"

#include <algorithm>
#include <cmath>

#include "skydrop/core/shared_ice.h"
#include "skydrop/core/wind.h"

namespace skydrop::clouds {
namespace {

namespace shared = core::shared::f64;

// Speed at which crystals fall, and the longest streak.
constexpr double kFallMps = 0.9, kLongestTrailM = 20'000, kShortestTrailM = 300;
// Grains are about as thick as they are wide.
constexpr double kGrainsM = 120;
// Shear that gives no direction.
constexpr double kNoShearMps = 0.05;

// Density straight through each genus, in the mean of what is cloud at cover 1 (a column of more than a tenth
// of it).
constexpr std::array<double, 3> kMeanDensity = {0.217, 1.0, 0.415};

// Noise above which a share of it lies, about; all of it at 1. Standard deviation of each genus's noise.
constexpr std::array<double, 3> kAreaSpread = {0.33, 0.27, 0.33};
double thresholdOf(double cover, double spread) {
  const double x = 2 * std::clamp(cover, 0.0, 1.0) - 1, x2 = x * x, x4 = x2 * x2, x8 = x4 * x4;
  return -spread * x * (1.2 / (1 - 0.35 * x2) + 2.2 * x8 * x8 * x8);
}

}  // namespace

using core::Range;

void describe(core::SettingsVisitor& v, IceCloudSettings& s) {
  const auto none = [&s] { return !(s.cover > 0 && s.opticalDepth > 0); };
  v.choice("genus", s.genus, kIceGenusNames,
           {.help = "Cirrus: strands in patches. Cirrostratus: an even veil. Cirrocumulus: grains and "
                    "ripples.",
            .aliases = "high clouds, fibratus, uncinus, mackerel sky"});
  v.number("base", s.base,
           {.unit = "m",
            .min = 3000,
            .max = 14000,
            .help = "Height of the layer's base above the sea; with weather, that decides.",
            .slider = Range{5000, 13000},
            .aliases = "altitude, level"});
  v.number("thickness", s.thickness,
           {.unit = "m",
            .min = 50,
            .max = 4000,
            .help = "From base to top: the way on which crystals fall and trail.",
            .slider = Range{200, 3000},
            .aliases = "depth, top"});
  v.number("cover", s.cover,
           {.unit = "1",
            .min = 0,
            .max = 1,
            .help = "Share of the sky that the layer covers; 0 for none.",
            .aliases = "coverage, amount, oktas"});
  v.number("opticalDepth", s.opticalDepth,
           {.unit = "1",
            .min = 0,
            .max = 4,
            .help = "How much light the layer takes straight through, in the mean of what is cloud.",
            .slider = Range{0, 2},
            .aliases = "thickness, density, opacity"});
  v.number("shear", s.shear,
           {.unit = "m/s",
            .min = 0,
            .max = 40,
            .help = "By how much the wind at the top exceeds that at the base: longer strands.",
            .slider = Range{0, 25},
            .aliases = "streaks, strands, mares' tails",
            .note = core::noteWhile(none, "Does nothing without a layer.")});
  v.number("shearDirection", s.shearDirection,
           {.unit = "deg",
            .min = 0,
            .max = 360,
            .help = "By compass where the wind that the top has more comes from; strands lie along it.",
            .aliases = "wind direction, orientation",
            .note = core::noteWhile(none, "Does nothing without a layer.")});
  v.number("turn", s.turn,
           {.unit = "deg",
            .min = -90,
            .max = 90,
            .help = "By how much it turns on the way down: strands become hooks.",
            .aliases = "hooks, uncinus, veering"});
  v.integer("samples", s.samples,
            {.unit = "1",
             .min = 1,
             .max = 64,
             .help = "Places along a ray at which a layer is asked; more show streaks behind each other.",
             .slider = Range{1, 16},
             .aliases = "steps, quality"});
  describeResolution(v, s.resolution);
}

void setLevels(IceLayer& layer, double baseM, double topM) {
  layer.baseM = baseM;
  layer.topM = topM;
  if (layer.genus != IceGenus::cirrocumulus || topM - baseM <= kGrainsM) return;
  layer.baseM = 0.5 * (baseM + topM - kGrainsM);
  layer.topM = layer.baseM + kGrainsM;
}

void setStreaks(IceLayer& layer, const glm::dvec2& shear, double across, const glm::dvec2& fallback) {
  const double speed = std::sqrt(shear.x * shear.x + shear.y * shear.y);
  const double other = std::sqrt(fallback.x * fallback.x + fallback.y * fallback.y);
  if (speed > kNoShearMps)
    layer.along = shear / speed;
  else if (other > kNoShearMps)
    layer.along = fallback / other;
  else
    layer.along = {1, 0};
  const double falling = (layer.topM - layer.baseM) / kFallMps;
  layer.trailM = std::clamp(0.5 * speed * falling, kShortestTrailM, kLongestTrailM);
  layer.hookM = std::clamp(across * falling / 3, -layer.trailM, layer.trailM);
}

IceLayer iceLayerOf(const IceCloudSettings& settings) {
  IceLayer layer;
  layer.genus = settings.genus;
  setLevels(layer, settings.base, settings.base + settings.thickness);
  layer.cover = settings.cover;
  layer.opticalDepth = settings.opticalDepth;
  // Half of the layer's shear lies in its lower half.
  const glm::dvec2 unit = core::windDrift({.speed = 1, .direction = settings.shearDirection}, 1);
  const glm::dvec2 turned = core::windDrift({.speed = 1, .direction = 90 + settings.turn}, 1);
  setStreaks(layer, unit * settings.shear, settings.shear * turned.y, unit);
  return layer;
}

IceField::IceField(const IceLayer& layer, const glm::dvec2& drift)
    : layer_(layer),
      drift_(drift),
      threshold_(thresholdOf(layer.cover, kAreaSpread[static_cast<std::size_t>(layer.genus)])) {}

double IceField::extinction() const {
  return layer_.opticalDepth / (layer_.topM - layer_.baseM) /
         kMeanDensity[static_cast<std::size_t>(layer_.genus)];
}

IceAnchor IceField::anchor(const glm::dvec2& xz) const {
  const glm::dvec2 at = xz - drift_;
  const glm::dvec2 cells = glm::dvec2(layer_.along.x * at.x + layer_.along.y * at.y,
                                      layer_.along.x * at.y - layer_.along.y * at.x) /
                           shared::kIceCellM;
  const auto wrapped = [](double whole) {
    return static_cast<std::uint32_t>(
        static_cast<std::int64_t>(whole - 4294967296.0 * std::floor(whole / 4294967296.0)));
  };
  IceAnchor anchor;
  const double u = std::floor(cells.x), v = std::floor(cells.y);
  anchor.cell = {wrapped(u), wrapped(v)};
  anchor.inside = {std::min(cells.x - u, 1.0), std::min(cells.y - v, 1.0)};
  return anchor;
}

double IceField::densityIn(const glm::dvec2& xz, double depth, const glm::dvec2& extent) const {
  const IceAnchor at = anchor(xz);
  const shared::IcePlace place = shared::make_icePlace(at.cell, at.inside);
  const shared::IceForm form{layer_.trailM, layer_.hookM, threshold_};
  switch (layer_.genus) {
    case IceGenus::cirrus:
      return shared::cirrusDensity(place, form, depth, extent);
    case IceGenus::cirrostratus:
      return shared::cirrostratusDensity(place, form, depth, extent);
    case IceGenus::cirrocumulus:
      return shared::cirrocumulusDensity(place, form, depth, extent);
  }
  return 0;
}

double IceField::density(const glm::dvec3& place) const {
  if (!(layer_.cover > 0) || !(place.y > layer_.baseM) || !(place.y < layer_.topM)) return 0;
  const double depth = (layer_.topM - place.y) / (layer_.topM - layer_.baseM);
  return densityIn({place.x, place.z}, depth, glm::dvec2(0));
}

double IceField::depthAbove(const glm::dvec3& place, int samples, double extentM) const {
  if (!(layer_.cover > 0) || !(place.y < layer_.topM)) return 0;
  const double low = std::max(place.y, layer_.baseM), lengthM = layer_.topM - low;
  double sum = 0;
  for (int i = 0; i < samples; ++i) {
    const double depth = (i + 0.5) / samples * lengthM / (layer_.topM - layer_.baseM);
    sum += densityIn({place.x, place.z}, depth, glm::dvec2(extentM));
  }
  return sum / samples * lengthM * extinction();
}

double IceField::depthAlong(const glm::dvec3& eye, const glm::dvec3& direction, int samples,
                            double pixelRad) const {
  if (!(layer_.cover > 0)) return 0;
  const shared::IceStretch way =
      shared::iceStretch(eye.y - layer_.baseM, eye.y - layer_.topM, eye.y, direction);
  if (!(way.end > way.begin)) return 0;
  const double bend = shared::rayBend(direction);
  const glm::dvec2 level(direction.x, direction.z);
  const double levelM = std::sqrt(level.x * level.x + level.y * level.y);
  const glm::dvec2 unit = level / std::max(levelM, 1e-6);
  const glm::dvec2 inAxes(std::abs(layer_.along.x * unit.x + layer_.along.y * unit.y),
                          std::abs(layer_.along.x * unit.y - layer_.along.y * unit.x));
  double sum = 0, last = shared::icePlaceOnStretch(way, 0.0);
  for (int i = 0; i < samples; ++i) {
    const double end = shared::icePlaceOnStretch(way, (i + 1.0) / samples),
                 at = shared::iceDistance(way, 0.5 * (last + end));
    const double across = pixelRad * at, slope = std::abs(direction.y + 2 * bend * at);
    const double laid = std::min(across / std::max(slope, 1e-4), end - last);
    const double along = std::max(std::max(laid, 0.4 * (end - last)) * levelM, across);
    const double rise = (direction.y + bend * at) * at;
    const double depth = std::clamp((layer_.topM - eye.y - rise) / (layer_.topM - layer_.baseM), 0.0, 1.0);
    sum += densityIn(glm::dvec2(eye.x, eye.z) + level * at, depth,
                     inAxes * along + glm::dvec2(inAxes.y, inAxes.x) * across) *
           (end - last);
    last = end;
  }
  return sum * extinction();
}

}  // namespace skydrop::clouds
