#include "skydrop/sky/sky_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "skydrop/sky/sky_curve.h"

namespace skydrop::sky {
namespace {

namespace f32 = core::shared::f32;
namespace f64 = core::shared::f64;
using glm::vec3;

constexpr int kColumns = f32::kSkyColumns, kRows = f32::kSkyRows;
constexpr int kSteps = 32;  // of a ray

std::size_t indexOf(SkyLayer layer, int row, int column) {
  return static_cast<std::size_t>((static_cast<int>(layer) * kRows + row) * kColumns + column);
}

// What a ray gathers under one azimuth of the light.
struct Gathered {
  vec3 rayleigh{0}, haze{0}, many{0};
};

}  // namespace

// By curves; no texel across the horizon takes part.
glm::dvec3 SkyView::curveAt(SkyLayer layer, double row, double column) const {
  const bool isAbove = row >= f32::kSkyRowsBelow;
  const int lowest = isAbove ? f32::kSkyRowsBelow : 0, highest = isAbove ? kRows - 1 : f32::kSkyRowsBelow - 1;
  const int i = std::clamp(static_cast<int>(column), 0, kColumns - 2),
            j = std::clamp(static_cast<int>(row), lowest, highest - 1);
  const auto inRow = [&](int of) {
    const auto texel = [&](int di) {
      return glm::dvec3(texels[indexOf(layer, of, std::clamp(i + di, 0, kColumns - 1))]);
    };
    const glm::dvec3 before = texel(-1), after = texel(2);
    return curveThrough(i > 0 ? &before : nullptr, texel(0), texel(1), i + 2 < kColumns ? &after : nullptr,
                        column - i);
  };
  const glm::dvec3 before = inRow(std::max(j - 1, lowest)), after = inRow(std::min(j + 2, highest));
  return curveThrough(j > lowest ? &before : nullptr, inRow(j), inRow(j + 1),
                      j + 2 <= highest ? &after : nullptr, row - j);
}

glm::dvec3 SkyView::at(SkyLayer layer, double sine, double cosAzimuth) const {
  const double row = f64::skyTableRow(sine, horizon, airEnds), column = f64::skyTableColumn(cosAzimuth);
  if (layer <= SkyLayer::left) return curveAt(layer, row, column);
  const int i = std::min(static_cast<int>(column), kColumns - 2),
            j = std::min(static_cast<int>(row), kRows - 2);
  const auto texel = [&](int dj, int di) { return glm::dvec3(texels[indexOf(layer, j + dj, i + di)]); };
  const double u = column - i, v = row - j;
  return glm::mix(glm::mix(texel(0, 0), texel(0, 1), u), glm::mix(texel(1, 0), texel(1, 1), u), v);
}

glm::dvec3 SkyView::upTo(SkyLayer layer, double sine, double cosAzimuth, double distanceM) const {
  const double slice = std::isinf(distanceM) ? f64::kSkySlices - 1 : f64::skyTableSlice(distanceM);
  const int first = std::min(static_cast<int>(slice), f64::kSkySlices - 2);
  const auto of = [&](int which) {
    return at(static_cast<SkyLayer>(static_cast<int>(layer) + which), sine, cosAzimuth);
  };
  return glm::mix(of(first), of(first + 1), slice - first);
}

void makeSkyRows(const AirTables& tables, double heightM, double cosine, int first, int last, SkyView& view) {
  const f32::Atmosphere& air = tables.airInFloat();
  const double eye = std::max(heightM, kLeastEyeM);
  view.horizon = f64::horizonSine(eye);
  view.airEnds = f64::airEndsSine(eye);
  view.texels.resize(static_cast<std::size_t>(kSkyLayers * kRows * kColumns));
  const double sunSine = std::sqrt(std::max(1 - cosine * cosine, 0.0));
  for (int row = first; row < last; ++row) {
    const double up = f64::skyTableSine(row, view.horizon, view.airEnds);
    const double across = std::sqrt(std::max(1 - up * up, 0.0));
    // Outside the air the ray begins where it enters.
    const f64::Vec2 shell = f64::shellCrossing(eye, up, f64::kShellTop), sea = f64::shellCrossing(eye, up, 0);
    const double begin = std::max(shell.x, 0.0);
    const bool meetsGround = row < f32::kSkyRowsBelow;
    const double tangent = std::sqrt(eye * (2 * f64::kEarthRadius + eye));
    const double end = meetsGround ? (sea.x <= sea.y ? sea.x : tangent) : std::max(shell.y, begin);
    const auto length = static_cast<float>(std::max(end - begin, 0.0));
    const auto startHeight = static_cast<float>(f64::shellHeightAlong(eye, up, begin));
    const auto startUp = static_cast<float>(f64::shellCosineAlong(eye, up, begin));
    std::array<float, kColumns> between{}, startSun{};
    for (int column = 0; column < kColumns; ++column) {
      const double azimuth = 2.0 * column / (kColumns - 1) - 1;
      const double angle = up * cosine + across * sunSine * azimuth;
      between[static_cast<std::size_t>(column)] = static_cast<float>(angle);
      startSun[static_cast<std::size_t>(column)] = static_cast<float>(
          ((f64::kEarthRadius + eye) * cosine + begin * angle) / (f64::kEarthRadius + startHeight));
    }
    std::array<Gathered, kColumns> gathered{};
    vec3 left(1), opacity(0);
    int slice = 0;
    // What a column has gathered, as light and as means along the ray.
    const auto put = [&](SkyLayer layer, int slices, int column, const vec3& value) {
      view.texels[indexOf(static_cast<SkyLayer>(static_cast<int>(layer) + slices), row, column)] =
          glm::vec4(value, 0);
    };
    const auto evenOf = [&](const Gathered& g, int column) {
      return g.rayleigh * f32::rayleighPhase(between[static_cast<std::size_t>(column)]) + g.many;
    };
    const auto putMeans = [&](int column, const Gathered& g, const vec3& taken) {
      const vec3 whole = glm::max(taken, vec3(1e-30f));
      put(SkyLayer::airEven, slice, column, evenOf(g, column) / whole);
      put(SkyLayer::airHaze, slice, column, g.haze / whole);
    };
    for (int i = 0; i < kSteps; ++i) {
      const float a = static_cast<float>(i) / kSteps, b = static_cast<float>(i + 1) / kSteps;
      const float from = length * a * a, to = length * b * b, t = 0.5f * (from + to);
      const float there = f32::shellHeightAlong(startHeight, startUp, t);
      const float upThere = f32::shellCosineAlong(startHeight, startUp, t);
      const f32::ShellAir here = f32::shellAirAt(air, there);
      const vec3 step = here.extinction * (to - from);
      const vec3 taken = left * (step * f32::oneMinusExpOverX3(step));
      const vec3 perExtinction = taken / (here.extinction + vec3(1e-30f));
      const vec3 byAir = here.rayleigh * perExtinction, byHaze = here.haze * perExtinction;
      const AirTables::Level level = tables.at(there);
      std::array<Gathered, kColumns> added;
      for (std::size_t column = 0; column < kColumns; ++column) {
        const float sun =
            std::clamp(((f32::kEarthRadius + startHeight) * startSun[column] + t * between[column]) /
                           (f32::kEarthRadius + there),
                       -1.0f, 1.0f);
        const vec3 light = level.transmittance(sun) * level.visibleShare(sun);
        const ScatteredBefore before = level.scatteredBefore(sun);
        // The direction of the ray in the place's axes.
        const float x = (between[column] - sun * upThere) / std::sqrt(std::max(1 - sun * sun, 1e-6f));
        const vec3 squares =
            before.xx * (x * x) + before.yy * (upThere * upThere) + before.xy * (2 * x * upThere) +
            (before.once - before.xx - before.yy) * std::max(1 - x * x - upThere * upThere, 0.0f);
        const vec3 flow = before.alongX * x + before.alongY * upThere;
        const vec3 rest = before.mean - before.once;
        const float g = air.hazeAnisotropy;
        added[column].rayleigh = byAir * light;
        added[column].haze = byHaze * light;
        // Of the last scattering: Rayleigh's phase function as it is, the haze's up to its second moment.
        added[column].many = byAir * (rest + 0.75f * (before.once + squares)) +
                             byHaze * glm::max(rest + before.once + flow * (3 * g) +
                                                   (squares * 1.5f - before.once * 0.5f) * (5 * g * g),
                                               vec3(0));
      }
      // Slices that end within this step take a part of it.
      for (; slice < f32::kSkySlices - 1; ++slice) {
        const float distance = f32::skyTableDistance(slice) - static_cast<float>(begin);
        if (distance > to) break;
        const float part = to > from ? std::clamp((distance - from) / (to - from), 1e-3f, 1.0f) : 1;
        for (int column = 0; column < kColumns; ++column) {
          const auto k = static_cast<std::size_t>(column);
          const Gathered& g = gathered[k];
          putMeans(column,
                   {g.rayleigh + added[k].rayleigh * part, g.haze + added[k].haze * part,
                    g.many + added[k].many * part},
                   opacity + taken * part);
        }
      }
      for (std::size_t column = 0; column < kColumns; ++column) {
        gathered[column].rayleigh += added[column].rayleigh;
        gathered[column].haze += added[column].haze;
        gathered[column].many += added[column].many;
      }
      opacity += taken;
      left *= f32::exp3(-step);
    }
    for (int column = 0; column < kColumns; ++column) {
      const Gathered& g = gathered[static_cast<std::size_t>(column)];
      put(SkyLayer::skyEven, 0, column, evenOf(g, column));
      put(SkyLayer::skyHaze, 0, column, g.haze);
      put(SkyLayer::left, 0, column, left);
    }
    // Rays that end before a slice does: their whole mean.
    for (; slice < f32::kSkySlices; ++slice) {
      for (int column = 0; column < kColumns; ++column)
        putMeans(column, gathered[static_cast<std::size_t>(column)], opacity);
    }
  }
}

SkyView makeSkyView(const AirTables& tables, double heightM, double cosine) {
  SkyView view;
  makeSkyRows(tables, heightM, cosine, 0, kRows, view);
  return view;
}

}  // namespace skydrop::sky
