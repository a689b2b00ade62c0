#include "game/ground_surface.h"

#include <algorithm>
#include <cmath>

#include "skydrop/core/hash.h"
#include "skydrop/terrain/strips.h"

namespace skydrop::game {
namespace {

// Rolling resistance (share of the load), factor on the tyre's friction, and height of the bumps, m.
struct Kind {
  double rolling, grip, bumps;
};
// Of the order of those that are taken for soft ground (Gudmundsson 2014, table 17-1: turf .05, long grass
// .1, soft sand .2); snow is hard snow.
constexpr Kind kStrip{0.04, 1, 0}, kMeadow{0.07, 0.9, 0.025}, kSand{0.1, 0.8, 0.015}, kScree{0.08, 0.9, 0.15},
    kSnow{0.08, 0.4, 0.02};
constexpr double kShoreM = 4;         // below it lies sand
constexpr double kScreeSlope = 0.55;  // steeper land is scree
constexpr double kSnowM = 960;        // the first snow, as the land is drawn
constexpr double kBlend = 0.15;       // share of each border over which kinds blend
constexpr double kBumpMetres = 3;     // from a bump to the next

double rise(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

Kind mixed(const Kind& a, const Kind& b, double share) {
  return {a.rolling + (b.rolling - a.rolling) * share, a.grip + (b.grip - a.grip) * share,
          a.bumps + (b.bumps - a.bumps) * share};
}

struct Bump {
  double height = 0;
  glm::dvec2 gradient{0};
};

// Smooth value noise on a lattice of integers, in [-1, 1].
Bump bumpAt(const glm::dvec2& xz) {
  const double x = xz.x / kBumpMetres, z = xz.y / kBumpMetres;
  const double fx = std::floor(x), fz = std::floor(z);
  const auto at = [&](int i, int j) {
    const std::uint64_t bits =
        core::hashCombine(static_cast<std::uint64_t>(static_cast<std::int64_t>(fx) + i),
                          static_cast<std::uint64_t>(static_cast<std::int64_t>(fz) + j));
    return static_cast<double>(bits >> 11) * 0x1p-52 - 1;
  };
  const double u = x - fx, v = z - fz;
  const double su = u * u * u * (10 + u * (6 * u - 15)), sv = v * v * v * (10 + v * (6 * v - 15));
  const double du = 30 * u * u * (1 - u) * (1 - u) / kBumpMetres,
               dv = 30 * v * v * (1 - v) * (1 - v) / kBumpMetres;
  const double a = at(0, 0), b = at(1, 0), c = at(0, 1), d = at(1, 1);
  const double top = a + (b - a) * su, bottom = c + (d - c) * su;
  return {top + (bottom - top) * sv, {((b - a) * (1 - sv) + (d - c) * sv) * du, (bottom - top) * dv}};
}

}  // namespace

flight::GroundPatch groundPatchAt(const terrain::HeightSource& ground, const glm::dvec2& xz,
                                  double roughness) {
  const terrain::HeightSample land = ground.sample(xz);
  flight::GroundPatch patch;
  patch.at = xz;
  if (!(land.height > 0)) {
    patch.water = true;
    return patch;
  }
  const double slope = std::sqrt(land.gradient.x * land.gradient.x + land.gradient.y * land.gradient.y);
  Kind kind = mixed(kSand, kMeadow, rise(kShoreM * (1 - kBlend), kShoreM * (1 + kBlend), land.height));
  kind = mixed(kind, kSnow, rise(kSnowM * (1 - kBlend), kSnowM, land.height));
  kind = mixed(kind, kScree, rise(kScreeSlope * (1 - kBlend), kScreeSlope, slope));
  if (const terrain::Strips* strips = ground.strips()) {
    if (const auto strip = strips->at(xz)) {
      // From its edge on, over the blend's two metres.
      const glm::dvec2 at = strip->local(xz);
      const double inside = std::min(strip->halfLength - std::abs(at.x), strip->halfWidth - std::abs(at.y));
      kind = mixed(kind, kStrip, rise(0, 2, inside));
    }
  }
  patch.height = land.height;
  patch.gradient = land.gradient;
  patch.rolling = kind.rolling;
  patch.grip = kind.grip;
  if (const double bumps = kind.bumps * roughness; bumps > 0) {
    const Bump bump = bumpAt(xz);
    patch.height += bumps * bump.height;
    patch.gradient += bumps * bump.gradient;
  }
  return patch;
}

}  // namespace skydrop::game
