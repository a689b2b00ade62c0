#include "skydrop/terrain/land_shade.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "skydrop/core/shared.h"

namespace skydrop::terrain {
namespace {

constexpr double kSunRadiusRad = core::shared::f64::kSunRadius;
constexpr double kSteepest = 1.57;    // rad: a sun in the zenith has a tangent too
constexpr float kLeastWidth = 1e-3f;  // m: of half a penumbra

// A coordinate in texels, and how far behind the next lower one it is.
struct Texels {
  std::int64_t whole;
  double rest;
};
Texels texelsOf(double value) {
  const double whole = std::floor(value);
  return {static_cast<std::int64_t>(whole), value - whole};
}

// The first texel of a level around a coordinate (texels).
std::int64_t firstTexel(double at, int side) {
  return static_cast<std::int64_t>(std::floor(at / kShadeSnap + 0.5)) * kShadeSnap - side / 2;
}

}  // namespace

double shareOfDisc(double q) {
  const double x = std::clamp(q, -1.0, 1.0), square = x * x;
  return 0.5 + x * (0.6297 - square * (0.0679 + 0.0618 * square));
}

ShadeAxes::ShadeAxes(const glm::dvec3& toSun) {
  const double level = std::hypot(toSun.x, toSun.z);
  const glm::dvec2 azimuth = level > 1e-9 ? glm::dvec2(toSun.x, toSun.z) / level : glm::dvec2(1, 0);
  alongX = std::abs(azimuth.x) >= std::abs(azimuth.y);
  const double along = alongX ? azimuth.x : azimuth.y;
  towardsSun = along > 0 ? 1 : -1;
  shear = (alongX ? azimuth.y : azimuth.x) / along;
  stepM = 1 / std::abs(along);
  const double elevation = std::atan2(toSun.y, level);
  const auto tangent = [](double angle) { return std::tan(std::clamp(angle, 0.0, kSteepest)); };
  tanUpperLimb = tangent(elevation + kSunRadiusRad);
  tanLowerLimb = tangent(elevation - kSunRadiusRad);
}

ShadeKey shadeKey(const ShadeLayout& layout, const glm::dvec2& eye, const glm::dvec3& toSun) {
  ShadeKey key{layout, toSun, {}};
  const glm::dvec2 inside = glm::clamp(eye, -kWorldLimitMetres, kWorldLimitMetres);
  const glm::dvec2 at = ShadeAxes(toSun).fromWorld(inside);
  for (int level = 0; level < kShadeLevels; ++level) {
    const double texel = layout.texelM(level);
    key.first[level] = {firstTexel(at.x / texel, layout.side), firstTexel(at.y / texel, layout.side)};
  }
  return key;
}

LandShade LandShade::make(ShadeHeights& heights, const ShadeKey& key, const std::stop_token& stop) {
  LandShade shade(key);
  for (int level = kShadeLevels - 1; level >= 0; --level) {
    if (shade.sweep(level, heights, stop)) continue;
    shade.levels_ = {};
    break;
  }
  heights.endUse();
  shade.heightBytes_ = heights.bytes();
  return shade;
}

bool LandShade::sweep(int level, ShadeHeights& heights, const std::stop_token& stop) {
  const int side = key_.layout.side;
  const auto count = static_cast<std::size_t>(side);
  const auto [firstAlong, firstAcross] = key_.first[level];
  const double texel = key_.layout.texelM(level);
  const auto step = static_cast<float>(texel * axes_.stepM);
  const auto fallUmbra = static_cast<float>(texel * axes_.stepM * axes_.tanUpperLimb);
  const auto fallPenumbra = static_cast<float>(texel * axes_.stepM * axes_.tanLowerLimb);
  const auto widening = static_cast<float>(0.5 * (axes_.tanUpperLimb - axes_.tanLowerLimb));
  Level& out = levels_[level];
  out.umbra.resize(count * count);
  out.penumbra.resize(count * count);
  std::vector<float> ground(count * count), clearance(count * count), halfWidth(count * count);
  std::vector<float> line(count + 1);
  // Heights of both limbs' shade on the line before, and how far from the edges that throw it.
  std::vector<float> umbra(count), penumbra(count), umbraWay(count), penumbraWay(count);
  const bool isHandedOn = level > 0;  // to the finer one
  if (isHandedOn) out.ways.resize(count * count);

  // What the sun passes before it comes to the first line; before all, land that goes on level.
  const int begin = axes_.towardsSun > 0 ? side - 1 : 0;
  if (level + 1 < kShadeLevels) {
    const auto [coarseAlong, coarseAcross] = key_.first[level + 1];
    const double along = static_cast<double>(firstAlong + begin + axes_.towardsSun - 4 * coarseAlong) / 4;
    for (int j = 0; j < side; ++j) {
      const Limbs before = at(level + 1, along, static_cast<double>(firstAcross + j - 4 * coarseAcross) / 4);
      umbra[j] = static_cast<float>(before.umbra);
      penumbra[j] = static_cast<float>(before.penumbra);
      umbraWay[j] = penumbraWay[j] = static_cast<float>(before.way);
    }
  }
  for (int done = 0; done < side; ++done) {
    const int i = begin - axes_.towardsSun * done;
    const Texels shift = texelsOf(axes_.shear * static_cast<double>(firstAlong + i));
    if (!heights.read(key_.layout.chunkLevel + 2 * level, axes_.alongX, firstAlong + i,
                      firstAcross + shift.whole, side + 1, line.data(), stop))
      return false;
    const auto rest = static_cast<float>(shift.rest);
    const std::size_t row = static_cast<std::size_t>(i) * count;
    for (std::size_t j = 0; j < count; ++j) line[j] += (line[j + 1] - line[j]) * rest;
    if (level + 1 == kShadeLevels && done == 0) {
      std::copy_n(line.begin(), side, umbra.begin());
      penumbra = umbra;
    }
    for (std::size_t j = 0; j < count; ++j) {
      const float height = line[j];
      const float dark = umbra[j] - fallUmbra, dim = penumbra[j] - fallPenumbra;
      const float darkWay = umbraWay[j] + step, dimWay = penumbraWay[j] + step;
      // The middles of the penumbrae of the edges that throw dark and dim. The higher edge in the sky counts:
      // there may be an edge a step away that only the upper limb's rays meet, and a far one before the lower
      // limb.
      const float darkHalf = std::max(widening * darkWay, kLeastWidth),
                  dimHalf = std::max(widening * dimWay, kLeastWidth);
      const float overDark = height - (dark + darkHalf), overDim = height - (dim - dimHalf);
      const bool isDark = overDark * dimHalf < overDim * darkHalf;
      ground[row + j] = height;
      clearance[row + j] = isDark ? overDark : overDim;
      halfWidth[row + j] = isDark ? darkHalf : dimHalf;
      umbra[j] = std::max(height, dark);
      umbraWay[j] = height >= dark ? 0 : darkWay;
      penumbra[j] = out.penumbra[row + j] = std::max(height, dim);
      penumbraWay[j] = height >= dim ? 0 : dimWay;
      // Land that hides nothing from itself is no umbra in the air above it: that is of the edge before the
      // lower limb.
      out.umbra[row + j] =
          height >= dark ? std::min(height, penumbra[j] - 2 * widening * penumbraWay[j]) : dark;
      if (isHandedOn) out.ways[row + j] = penumbraWay[j];
    }
  }

  // At an edge not narrower than half of what the clearance changes by from a texel to the next: so the edge
  // is where the clearance between them is 0, not halfway.
  out.clearances.resize(count * count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) {
      const std::size_t at = i * count + j;
      const float here = clearance[at];
      float width = halfWidth[at];
      const auto widenTo = [&](std::size_t beside) {
        if ((clearance[beside] < 0) != (here < 0))
          width = std::max(width, 0.5f * std::abs(here - clearance[beside]));
      };
      if (i > 0) widenTo(at - count);
      if (i + 1 < count) widenTo(at + count);
      if (j > 0) widenTo(at - 1);
      if (j + 1 < count) widenTo(at + 1);
      const float q = std::clamp(here / (2 * width), -1.0f, 1.0f);
      out.clearances[at] = static_cast<std::uint16_t>((q * 0.5f + 0.5f) * 65535.0f + 0.5f);
    }
  }
  topM_ = std::max(topM_, static_cast<double>(*std::max_element(out.penumbra.begin(), out.penumbra.end())));
  noteShaded(level, ground, clearance, halfWidth);
  return true;
}

void LandShade::noteShaded(int level, const std::vector<float>& ground, const std::vector<float>& clearance,
                           const std::vector<float>& halfWidth) {
  const int side = key_.layout.side;
  const double texel = key_.layout.texelM(level);
  const std::vector<float>& top = levels_[level].penumbra;
  for (int i0 = 0; i0 < side; i0 += kShadeSnap) {
    for (int j0 = 0; j0 < side; j0 += kShadeSnap) {
      float lowest = 0, highest = 0;
      bool isShaded = false;
      // With the texels beside it, as far as filtering carries them.
      for (int i = std::max(i0 - 1, 0); i <= std::min(i0 + kShadeSnap, side - 1); ++i) {
        for (int j = std::max(j0 - 1, 0); j <= std::min(j0 + kShadeSnap, side - 1); ++j) {
          const std::size_t at = static_cast<std::size_t>(i) * static_cast<std::size_t>(side) + j;
          if (clearance[at] >= halfWidth[at]) continue;
          lowest = isShaded ? std::min(lowest, ground[at]) : ground[at];
          highest = isShaded ? std::max(highest, top[at]) : top[at];
          isShaded = true;
        }
      }
      if (!isShaded) continue;
      const double along = static_cast<double>(key_.first[level][0] + i0) * texel;
      const double across = static_cast<double>(key_.first[level][1] + j0) * texel;
      const double width = kShadeSnap * texel, bend = axes_.shear * along, more = axes_.shear * width;
      glm::dvec2 low(along - texel, across + bend + std::min(more, 0.0) - 2 * texel);
      glm::dvec2 high(along + width, across + width + bend + std::max(more, 0.0) + texel);
      if (!axes_.alongX) low = {low.y, low.x}, high = {high.y, high.x};
      // Land is drawn from meshes of its own, a little off.
      shaded_.push_back(boxOf(low, high, {lowest - 2 * texel, highest + 2 * texel}));
    }
  }
}

LandShade::Limbs LandShade::at(int level, double along, double across) const {
  const int side = key_.layout.side;
  const auto last = static_cast<double>(side - 1);
  const double a = std::clamp(along, 0.0, last), c = std::clamp(across, 0.0, last);
  const int i = std::min(static_cast<int>(a), side - 2), j = std::min(static_cast<int>(c), side - 2);
  const double u = a - i, v = c - j;
  const auto mean = [&](const std::vector<float>& values) {
    const float* const cell = values.data() + static_cast<std::ptrdiff_t>(i) * side + j;
    const double near = static_cast<double>(cell[0]) * (1 - v) + static_cast<double>(cell[1]) * v;
    const double far = static_cast<double>(cell[side]) * (1 - v) + static_cast<double>(cell[side + 1]) * v;
    return near * (1 - u) + far * u;
  };
  const Level& of = levels_[level];
  return {mean(of.umbra), mean(of.penumbra), of.ways.empty() ? 0 : mean(of.ways)};
}

double LandShade::clearanceAt(int level, const glm::dvec2& xz) const {
  const auto& first = key_.first[static_cast<std::size_t>(level)];
  const glm::dvec2 at = axes_.fromWorld(xz) / key_.layout.texelM(level);
  const double along = at.x - static_cast<double>(first[0]), across = at.y - static_cast<double>(first[1]);
  const int i = static_cast<int>(along), j = static_cast<int>(across);
  const auto texel = [&](int a, int b) {
    return levels_[level].clearances[static_cast<std::size_t>((i + a) * key_.layout.side + j + b)] / 65535.0 *
               4 -
           2;
  };
  const double u = along - i, v = across - j;
  return (texel(0, 0) * (1 - v) + texel(0, 1) * v) * (1 - u) + (texel(1, 0) * (1 - v) + texel(1, 1) * v) * u;
}

double LandShade::sunShare(const glm::dvec3& place) const {
  const glm::dvec2 at = axes_.fromWorld({place.x, place.z});
  for (int level = 0; level < kShadeLevels; ++level) {
    const double texel = key_.layout.texelM(level);
    // From the next texel towards the sun: the land here hides nothing of the sun from what stands on it.
    const double along = at.x / texel - static_cast<double>(key_.first[level][0]) + axes_.towardsSun;
    const double across = at.y / texel - static_cast<double>(key_.first[level][1]);
    const double last = key_.layout.side - 1;
    if (!(along >= 0 && along <= last && across >= 0 && across <= last)) continue;
    if (levels_[level].umbra.empty()) return 1;
    const Limbs top = this->at(level, along, across);
    const double step = texel * axes_.stepM;
    const double dark = top.umbra - step * axes_.tanUpperLimb;
    const double dim = top.penumbra - step * axes_.tanLowerLimb;
    const double halfWidth = std::max(0.5 * (dim - dark), static_cast<double>(kLeastWidth));
    return shareOfDisc((place.y - 0.5 * (dark + dim)) / halfWidth);
  }
  return 1;
}

std::size_t LandShade::bytes() const {
  std::size_t bytes = heightBytes_;
  for (const Level& level : levels_) {
    bytes += (level.umbra.size() + level.penumbra.size() + level.ways.size()) * sizeof(float);
    bytes += level.clearances.size() * sizeof(std::uint16_t);
  }
  return bytes;
}

}  // namespace skydrop::terrain
