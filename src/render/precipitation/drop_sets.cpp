#include "skydrop/render/precipitation/drop_sets.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>

#include "skydrop/core/hash.h"
#include "skydrop/core/shared_precipitation.h"

namespace skydrop::render {
namespace {

namespace shared = core::shared::f64;

// Thirds of the water of Marshall and Palmer's drops: the mean of diameter times slope in each, and its share
// of the cross section (incomplete gamma functions of 4 and 3).
constexpr std::array<double, 3> kRainSizes = {2.045, 3.692, 6.263}, kRainSections = {0.557, 0.275, 0.168};
constexpr std::array<double, 2> kSnowSizes = {1.7, 4.0}, kSnowSpeeds = {0.8, 1.2}, kSnowSections = {0.6, 0.4};
constexpr double kSleetMm = 2.5, kSleetMps = 5, kHailMm = 12, kIceDensity = 0.9;
constexpr double kSpanShift = 0.37;  // of a span, between classes

std::uint32_t wrapped(double number) {
  // Exact for whole numbers below 2^53; beyond there are no others.
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::fmod(number, 4294967296.0)));
}

// Bounds of what the view sees within a distance, relative to the eye.
struct Box {
  glm::dvec3 low{0}, high{0};
};

Box seenWithin(const View& view, double distanceM) {
  Box box;
  const glm::dmat3 toRay = rayMatrix(view);
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      const glm::dvec3 corner = toRay * glm::dvec3(x, y, 1) * distanceM;
      box.low = glm::min(box.low, corner);
      box.high = glm::max(box.high, corner);
    }
  }
  box.low = glm::max(box.low, glm::dvec3(-distanceM));
  box.high = glm::min(box.high, glm::dvec3(distanceM));
  return box;
}

struct KindLook {
  double mostOpacity, forward, flutterM, leastPixels;
};
KindLook lookOf(FallKind kind) {
  switch (kind) {
    case FallKind::rain:
      return {0.5, 0.6, 0, 1};
    case FallKind::snow:
      return {0.85, 0.25, 0.06, 1.6};
    case FallKind::sleet:
      return {0.7, 0.35, 0, 1.2};
    case FallKind::hail:
      return {0.95, 0.15, 0, 1.4};
  }
  return {};
}

}  // namespace

std::vector<FallClass> fallClasses(const weather::Precipitation& fall) {
  std::vector<FallClass> classes;
  if (fall.rain > 0) {
    const double slope = shared::rainSlope(fall.rain);
    for (std::size_t i = 0; i < kRainSizes.size(); ++i) {
      const double diameter = kRainSizes[i] / slope;
      classes.push_back({FallKind::rain, diameter, shared::dropSpeed(diameter),
                         kRainSections[i] * shared::rainExtinction(fall.rain)});
    }
  }
  if (fall.snow > 0) {
    const double slope = shared::snowSlope(fall.snow);
    for (std::size_t i = 0; i < kSnowSizes.size(); ++i) {
      classes.push_back({FallKind::snow, shared::kFlakeWidening * kSnowSizes[i] / slope, kSnowSpeeds[i],
                         kSnowSections[i] * shared::snowExtinction(fall.snow)});
    }
  }
  if (fall.sleet > 0)
    classes.push_back({FallKind::sleet, kSleetMm, kSleetMps,
                       shared::spheresExtinction(fall.sleet, kSleetMm, kSleetMps, kIceDensity)});
  if (fall.hail > 0) {
    const double speed = shared::hailSpeed(kHailMm);
    classes.push_back(
        {FallKind::hail, kHailMm, speed, shared::spheresExtinction(fall.hail, kHailMm, speed, kIceDensity)});
  }
  return classes;
}

DropSets dropSets(const PrecipitationSettings& settings, std::span<const FallClass> classes, const View& view,
                  const glm::dvec3& eyeVelocity, const glm::dvec3& air, double seconds) {
  DropSets result;
  if (classes.empty() || settings.drops < 1) return result;
  const double range = settings.rangeM;
  const double dropsAClass = std::max(settings.drops / static_cast<double>(classes.size()), 1.0);
  const double cell = 2 * range / std::cbrt(dropsAClass);
  const Box box = seenWithin(view, range);
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const FallClass& fall = classes[i];
    const KindLook look = lookOf(fall.kind);
    const glm::dvec3 velocity = air - glm::dvec3(0, fall.speedMps, 0);
    for (const double half : {0.0, 0.5}) {
      const double spans = seconds / kSpanS + half + kSpanShift * static_cast<double>(i);
      const double span = std::floor(spans), since = spans - span;
      const double filled = 1 - std::abs(2 * since - 1);
      if (filled <= 0) continue;
      // In cells, moved along with what falls.
      const glm::dvec3 eye = (view.position - velocity * (since * kSpanS)) / cell;
      const glm::dvec3 low = glm::floor(eye + box.low / cell), high = glm::floor(eye + box.high / cell);
      const glm::dvec3 size = high - low + 1.0;
      DropSet& set = result.sets[static_cast<std::size_t>(result.count++)];
      set.corner = glm::vec4(glm::vec3((low - eye) * cell), static_cast<float>(cell));
      set.passing = glm::vec4(glm::vec3(velocity - eyeVelocity), static_cast<float>(filled));
      set.look = glm::vec4(fall.diameterMm * 1e-3, fall.extinction / 2 * cell * cell * cell, look.mostOpacity,
                           look.flutterM);
      set.light = glm::vec4(look.forward, since * kSpanS, look.leastPixels, 0);
      const auto salt = core::mix64(static_cast<std::uint64_t>(wrapped(span)) << 8 ^ (2 * i + (half > 0)));
      set.first = {wrapped(low.x), wrapped(low.y), wrapped(low.z), static_cast<std::uint32_t>(salt)};
      glm::ivec3 counts(size);
      counts.z = std::min(counts.z, std::max(kMostDropsASet / (counts.x * counts.y), 1));
      set.counts = glm::ivec4(counts, counts.x * counts.y * counts.z);
      result.mostDrops = std::max(result.mostDrops, set.counts.w);
      if (result.count == kMostSets) return result;
    }
  }
  return result;
}

}  // namespace skydrop::render
