#include "skydrop/sky/air_tables.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <numbers>

namespace skydrop::sky {
namespace {

namespace f32 = core::shared::f32;
namespace f64 = core::shared::f64;
using glm::vec3;

constexpr int kSines = f32::kTransmittanceSines, kHeights = f32::kTransmittanceHeights;
constexpr int kDepthSteps = 48;  // of a ray of the table of transmittance

// The table of light scattered many times: rows by the root of the height, columns by the light's cosine,
// close to each other where it is level.
constexpr int kManyHeights = 32, kManyCosines = 48;
constexpr float kLowestCosine = -0.45f;  // no light is left in the air of a sun that low
constexpr float kLevelWidth = 0.25f;     // columns are dense about level light, over about this cosine
constexpr int kManySteps = 16, kManyRings = 12, kManySectors = 8;  // of rays, and of half the directions
constexpr std::size_t kFloats = sizeof(ScatteredBefore) / sizeof(float);

constexpr float spread(float cosine) { return cosine / (kLevelWidth + (cosine < 0 ? -cosine : cosine)); }
constexpr float kFirstSpread = spread(kLowestCosine), kLastSpread = spread(1);

float columnOf(float cosine) {
  const float share = (spread(cosine) - kFirstSpread) / (kLastSpread - kFirstSpread);
  return std::clamp(share, 0.0f, 1.0f) * (kManyCosines - 1);
}

float cosineOf(int column) {
  const float share = static_cast<float>(column) / (kManyCosines - 1);
  const float x = kFirstSpread + (kLastSpread - kFirstSpread) * share;
  return std::clamp(kLevelWidth * x / (1 - std::abs(x)), kLowestCosine, 1.0f);
}

// Row and share of the next one, of a place in [0, last].
struct Between {
  int row;
  float share;
};
Between between(float at, int last) {
  const int row = std::clamp(static_cast<int>(at), 0, last - 1);
  return {row, at - static_cast<float>(row)};
}

f32::Atmosphere inFloat(const Atmosphere& air) {
  f32::Atmosphere of;
  of.rayleigh = vec3(air.rayleigh);
  of.rayleighHeight = static_cast<float>(air.rayleighHeight);
  of.haze = static_cast<float>(air.haze);
  of.hazeHeight = static_cast<float>(air.hazeHeight);
  of.hazeAlbedo = static_cast<float>(air.hazeAlbedo);
  of.hazeAnisotropy = static_cast<float>(air.hazeAnisotropy);
  of.ozone = vec3(air.ozone);
  return of;
}

}  // namespace

AirTables::AirTables(const Atmosphere& air) : air_(air), airInFloat_(inFloat(air)) {
  makeTransmittance();
  makeScatteredBefore();
}

void AirTables::makeTransmittance() {
  transmittance_.resize(static_cast<std::size_t>(kSines * kHeights));
  for (int y = 0; y < kHeights; ++y) {
    for (int x = 0; x < kSines; ++x) {
      const f64::Vec2 place = f64::transmittanceTablePlace(
          {x / static_cast<double>(kSines - 1), y / static_cast<double>(kHeights - 1)});
      const auto height = static_cast<float>(place.x), cosine = static_cast<float>(place.y);
      const auto length = static_cast<float>(f64::shellCrossing(place.x, place.y, f64::kShellTop).y);
      vec3 depth(0);
      // Steps that grow with the square of their number: air is dense where the ray begins.
      for (int i = 0; i < kDepthSteps; ++i) {
        const float at = (static_cast<float>(i) + 0.5f) / kDepthSteps;
        const float there = f32::shellHeightAlong(height, cosine, length * at * at * at);
        depth += f32::shellAirAt(airInFloat_, there).extinction * (3 * at * at);
      }
      depth *= std::max(length, 0.0f) / kDepthSteps;
      transmittance_[static_cast<std::size_t>(y * kSines + x)] = f32::exp3(-depth);
    }
  }
}

AirTables::Level AirTables::at(float heightM) const {
  const float h = std::clamp(heightM, 0.0f, f32::kShellTop);
  // As transmittanceTableAt has it.
  const float most = std::sqrt(f32::kShellTop * (2 * f32::kEarthRadius + f32::kShellTop));
  const float toHorizon = std::sqrt(h * (2 * f32::kEarthRadius + h));
  const Between row = between(toHorizon / most * (kHeights - 1), kHeights - 1);
  const Between scatteredRow = between(std::sqrt(h / f32::kShellTop) * (kManyHeights - 1), kManyHeights - 1);
  Level level;
  level.radius_ = f32::kEarthRadius + h;
  level.horizon_ = -toHorizon / level.radius_;
  level.perHorizonCosine_ = level.radius_ / f32::kEarthRadius;
  level.toAirEnd_ = (f32::kShellTop - h) * (2 * f32::kEarthRadius + h + f32::kShellTop);
  level.shortest_ = f32::kShellTop - h;
  level.perLength_ = (kSines - 1) / (toHorizon + most - level.shortest_);
  level.transmittance_ = transmittance_.data() + row.row * kSines;
  level.transmittanceShare_ = row.share;
  level.scattered_ =
      scatteredBefore_.data() + static_cast<std::ptrdiff_t>(kFloats) * scatteredRow.row * kManyCosines;
  level.scatteredShare_ = scatteredRow.share;
  return level;
}

float AirTables::Level::visibleShare(float cosine) const {
  return f32::sunVisibleShare((cosine - horizon_) * perHorizonCosine_);
}

vec3 AirTables::Level::transmittance(float cosine) const {
  const float b = radius_ * std::max(cosine, horizon_);
  const float root = std::sqrt(b * b + toAirEnd_);
  const float length = b > 0 ? toAirEnd_ / (b + root) : root - b;
  const Between x = between(std::clamp((length - shortest_) * perLength_, 0.0f, kSines - 1.0f), kSines - 1);
  const vec3* low = transmittance_ + x.row;
  const vec3* high = low + kSines;
  return glm::mix(glm::mix(low[0], low[1], x.share), glm::mix(high[0], high[1], x.share),
                  transmittanceShare_);
}

ScatteredBefore AirTables::Level::scatteredBefore(float cosine) const {
  const Between x = between(columnOf(cosine), kManyCosines - 1);
  const float* low = scattered_ + static_cast<std::ptrdiff_t>(kFloats) * x.row;
  const float* high = low + kFloats * kManyCosines;
  const float b = x.share * (1 - scatteredShare_), a = 1 - scatteredShare_ - b, d = x.share * scatteredShare_,
              c = scatteredShare_ - d;
  std::array<float, kFloats> mixed;
  for (std::size_t i = 0; i < kFloats; ++i)
    mixed[i] = low[i] * a + low[i + kFloats] * b + high[i] * c + high[i + kFloats] * d;
  return std::bit_cast<ScatteredBefore>(mixed);
}

void AirTables::makeScatteredBefore() {
  scatteredBefore_.reserve(kFloats * kManyHeights * kManyCosines);
  for (int row = 0; row < kManyHeights; ++row) {
    const float share = static_cast<float>(row) / (kManyHeights - 1);
    for (int column = 0; column < kManyCosines; ++column) {
      const auto gathered = std::bit_cast<std::array<float, kFloats>>(
          gatherAt(f32::kShellTop * share * share, cosineOf(column)));
      scatteredBefore_.insert(scatteredBefore_.end(), gathered.begin(), gathered.end());
    }
  }
}

ScatteredBefore AirTables::gatherAt(float heightM, float cosine) const {
  // All further scatterings are a geometric series of the share that the air sends back to the same place,
  // taken as even (Hillaire 2020, section 5.5).
  const float sine = std::sqrt(std::max(1 - cosine * cosine, 0.0f));
  std::array<float, kManySectors> cosAzimuths{};
  for (std::size_t i = 0; i < kManySectors; ++i)
    cosAzimuths[i] = std::cos(std::numbers::pi_v<float> * (static_cast<float>(i) + 0.5f) / kManySectors);
  // Rings lie close to each other about the level, where the light changes fastest; each stands for a part of
  // the sphere.
  const auto upOf = [](int ring) {
    const float x = 1 - 2 * (static_cast<float>(ring) + 0.5f) / kManyRings;
    return x * std::abs(x);
  };
  const auto partOf = [](int ring) {
    const float high = 1 - 2 * static_cast<float>(ring) / kManyRings, low = high - 2.0f / kManyRings;
    return 0.5f * (high * std::abs(high) - low * std::abs(low));
  };
  // The haze's phase function is narrow for so few directions: its mean is made right.
  float hazeSum = 0;
  for (int ring = 0; ring < kManyRings; ++ring) {
    const float up = upOf(ring), across = std::sqrt(1 - up * up);
    for (const float cosAzimuth : cosAzimuths)
      hazeSum += partOf(ring) / kManySectors *
                 f32::henyeyGreenstein(up * cosine + across * sine * cosAzimuth, airInFloat_.hazeAnisotropy);
  }
  const float hazeScale = 1 / (4 * f32::kPi * hazeSum);
  const Level ground = at(0);
  ScatteredBefore all;
  vec3 again(0);
  for (int ring = 0; ring < kManyRings; ++ring) {
    const float up = upOf(ring), across = std::sqrt(1 - up * up);
    const bool meetsGround = up < f32::horizonSine(heightM);
    const float length = std::max(meetsGround ? f32::shellCrossing(heightM, up, 0).x
                                              : f32::shellCrossing(heightM, up, f32::kShellTop).y,
                                  0.0f);
    vec3 left(1);
    std::array<vec3, kManySectors> byAir{}, byHaze{};
    for (int i = 0; i < kManySteps; ++i) {
      const float begin = static_cast<float>(i) / kManySteps, end = static_cast<float>(i + 1) / kManySteps;
      const float from = length * begin * begin, to = length * end * end, t = 0.5f * (from + to);
      const float there = f32::shellHeightAlong(heightM, up, t);
      const f32::ShellAir air = f32::shellAirAt(airInFloat_, there);
      const vec3 step = air.extinction * (to - from);
      const vec3 share = left * (step * f32::oneMinusExpOverX3(step)) / (air.extinction + vec3(1e-30f));
      const Level level = at(there);
      again += partOf(ring) * share * (air.rayleigh + vec3(air.haze));
      for (std::size_t sector = 0; sector < kManySectors; ++sector) {
        const float between = up * cosine + across * sine * cosAzimuths[sector];
        const float sun =
            std::clamp(((f32::kEarthRadius + heightM) * cosine + t * between) / (f32::kEarthRadius + there),
                       -1.0f, 1.0f);
        const float visible = level.visibleShare(sun);
        if (visible <= 0) continue;
        const vec3 light = share * level.transmittance(sun) * visible;
        byAir[sector] += light * air.rayleigh;
        byHaze[sector] += light * air.haze;
      }
      left *= f32::exp3(-step);
    }
    for (std::size_t sector = 0; sector < kManySectors; ++sector) {
      const float between = up * cosine + across * sine * cosAzimuths[sector];
      vec3 light = byAir[sector] * f32::rayleighPhase(between) +
                   byHaze[sector] * (hazeScale * f32::henyeyGreenstein(between, airInFloat_.hazeAnisotropy));
      if (meetsGround) {
        const float sun = std::clamp(
            ((f32::kEarthRadius + heightM) * cosine + length * between) / f32::kEarthRadius, -1.0f, 1.0f);
        light += left * ground.transmittance(sun) *
                 (ground.visibleShare(sun) * std::max(sun, 0.0f) * f32::kGroundAlbedo / f32::kPi);
      }
      const float x = across * cosAzimuths[sector];
      light *= partOf(ring) / kManySectors;
      all.once += light;
      all.alongX += light * x;
      all.alongY += light * up;
      all.xx += light * (x * x);
      all.yy += light * (up * up);
      all.xy += light * (x * up);
    }
  }
  all.mean = all.once / (vec3(1) - glm::min(again, vec3(0.999f)));
  return all;
}

}  // namespace skydrop::sky
