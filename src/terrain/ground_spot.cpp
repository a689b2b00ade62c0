#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "skydrop/core/shared.h"
#include "skydrop/terrain/ground_relief.h"

namespace skydrop::terrain {
namespace {

namespace shared = core::shared::f64;
using glm::dvec2;

std::uint32_t bitsOf(int x, int y, std::uint32_t salt) {
  return shared::latticeBits(static_cast<std::uint32_t>(x) * 0x9e3779b1u + salt,
                             static_cast<std::uint32_t>(y) * 0x85ebca77u);
}
double byteOf(std::uint32_t bits, int which) { return (bits >> (8 * which) & 0xffu) / 255.0; }

double rise(double low, double high, double x) { return shared::smoothRise(low, high, x); }

// Periodic gradient noise of n by m cells to the square, within [-1, 1], standard deviation about .3.
double noise(dvec2 at, int n, int m, std::uint32_t salt) {
  const double x = at.x * n, y = at.y * m;
  const int cx = static_cast<int>(std::floor(x)), cy = static_cast<int>(std::floor(y));
  const dvec2 inside(x - cx, y - cy);
  const auto corner = [&](int i, int j) {
    const std::uint32_t bits = bitsOf(((cx + i) % n + n) % n, ((cy + j) % m + m) % m, salt);
    const dvec2 gradient(2 * byteOf(bits, 0) - 1, 2 * byteOf(bits, 1) - 1);
    return glm::dot(gradient, inside - dvec2(i, j));
  };
  const double u = shared::smoothStep5(inside.x), v = shared::smoothStep5(inside.y);
  const double upper = corner(0, 0) + u * (corner(1, 0) - corner(0, 0));
  const double lower = corner(0, 1) + u * (corner(1, 1) - corner(0, 1));
  return 1.6 * (upper + v * (lower - upper));
}
double noise(dvec2 at, int n, std::uint32_t salt) { return noise(at, n, n, salt); }

double octaves(dvec2 at, int n, int count, std::uint32_t salt) {
  double sum = 0, weight = 1;
  for (int i = 0; i < count; ++i, n *= 2, weight *= 0.55) sum += weight * noise(at, n, salt + 77u * i);
  return sum;
}

// The cell of a periodic jittered lattice that a place lies in (Worley, 1996), n to a side.
struct Cell {
  double nearest = 9, second = 9;  // distances to centres, in cells
  dvec2 aside{};                   // from the nearest centre, in cells
  std::uint32_t bits = 0;          // of the nearest
  double edge() const { return second - nearest; }
};
Cell cellAt(dvec2 at, int n, std::uint32_t salt) {
  const double x = at.x * n, y = at.y * n;
  const int cx = static_cast<int>(std::floor(x)), cy = static_cast<int>(std::floor(y));
  Cell cell;
  for (int j = -1; j <= 1; ++j) {
    for (int i = -1; i <= 1; ++i) {
      const std::uint32_t bits = bitsOf(((cx + i) % n + n) % n, ((cy + j) % n + n) % n, salt);
      const dvec2 centre(cx + i + byteOf(bits, 0), cy + j + byteOf(bits, 1));
      const double distance = glm::length(dvec2(x, y) - centre);
      if (distance < cell.nearest) {
        cell.second = cell.nearest;
        cell.nearest = distance, cell.bits = bits, cell.aside = dvec2(x, y) - centre;
      } else if (distance < cell.second) {
        cell.second = distance;
      }
    }
  }
  return cell;
}

// Turned by an eighth of a circle times `which`, so that blades and twigs lie all ways.
dvec2 turned(dvec2 v, unsigned which) {
  constexpr double kHalf = 0.70710678118654752;
  constexpr std::array<dvec2, 4> kAxes{{{1, 0}, {kHalf, kHalf}, {0, 1}, {-kHalf, kHalf}}};
  const dvec2 axis = kAxes[which & 3u];
  return {v.x * axis.x + v.y * axis.y, v.y * axis.x - v.x * axis.y};
}

// Strokes within a cell: long along a direction of its own.
double strokes(const Cell& cell, double across, double along) {
  const dvec2 local = turned(cell.aside, cell.bits >> 16);
  return noise({(local.x + 8) / 64, (local.y + 8) / 64}, static_cast<int>(64 * along),
               static_cast<int>(64 * across), cell.bits);
}

GroundSpot grass(dvec2 at) {
  const dvec2 bent = at + 0.014 * dvec2(noise(at, 9, 1), noise(at, 9, 2)) +
                     0.004 * dvec2(noise(at, 31, 6), noise(at, 31, 7));
  const Cell tuft = cellAt(bent, 13, 3), clump = cellAt(bent, 34, 4);
  const double blades = 0.6 * strokes(tuft, 11, 2.6) + 0.7 * strokes(clump, 5, 1.3);
  const double dome = std::max(1 - tuft.nearest * tuft.nearest * 2.2, 0.0) * byteOf(tuft.bits, 2);
  const double bush = std::max(1 - clump.nearest * clump.nearest * 2.0, 0.0) * byteOf(clump.bits, 2);
  const double sward = octaves(at, 3, 4, 5);
  GroundSpot spot;
  spot.heightM = 0.08 * dome + 0.035 * bush + 0.022 * blades + 0.06 * sward;
  spot.tint = 0.60 * blades + 0.46 * bush + 0.40 * dome * (byteOf(tuft.bits, 3) - 0.3) + 0.42 * sward +
              0.22 * (byteOf(clump.bits, 3) - 0.5) * bush;
  // Here and there a flower, or a dry halm.
  if (byteOf(clump.bits, 3) > 0.97) spot.tint += 0.9 * rise(0.30, 0.10, clump.nearest);
  return spot;
}

GroundSpot forestFloor(dvec2 at) {
  const Cell leaf = cellAt(at, 61, 11),
             heap = cellAt(at + 0.01 * dvec2(noise(at, 7, 12), noise(at, 7, 13)), 11, 14);
  const Cell twig = cellAt(at, 9, 15);
  const double litter = 0.6 * strokes(leaf, 3.2, 1.1) + 0.5 * octaves(at, 24, 3, 16);
  const dvec2 lying = turned(twig.aside, twig.bits >> 18);
  const double stick = byteOf(twig.bits, 3) > 0.55
                           ? rise(0.03, 0.012, std::abs(lying.y + 0.04 * noise(at, 33, 17))) *
                                 rise(0.34, 0.28, std::abs(lying.x))
                           : 0.0;
  const double moss = rise(-0.05, 0.25, octaves(at, 3, 3, 18));
  GroundSpot spot;
  spot.heightM = 0.05 * (1 - std::min(heap.nearest, 1.0)) + 0.022 * litter + 0.03 * stick + 0.05 * moss;
  spot.tint = 0.42 * litter + 0.55 * (byteOf(leaf.bits, 2) - 0.5) * rise(0.02, 0.15, leaf.edge()) +
              0.35 * moss * octaves(at, 30, 2, 19) + 0.45 * stick - 0.25 * rise(0.12, 0.02, leaf.edge());
  return spot;
}

// Stones that lie on what is below them: of n cells to a side a share of them, with flat tops and round
// shoulders.
void lay(GroundSpot& spot, dvec2 at, int n, double share, double tallM, std::uint32_t salt) {
  const dvec2 bent = at + (0.16 / n) * dvec2(noise(at, 3 * n, salt + 1), noise(at, 3 * n, salt + 2));
  const Cell stone = cellAt(bent, n, salt);
  if (byteOf(stone.bits, 2) > share) return;
  const double size = 0.45 + 0.55 * byteOf(stone.bits, 3);
  const double inside = std::min(stone.edge(), 0.9 * size - stone.nearest);
  if (inside <= 0) return;
  const dvec2 lean = turned(stone.aside, stone.bits >> 9);
  const double top = tallM * size * (0.75 + 0.5 * lean.x);
  const double body = std::sqrt(std::min(inside / 0.28, 1.0));
  const double facet = 0.08 * tallM * octaves(at, 4 * n, 2, salt + 3);
  spot.heightM += top * body + facet;
  spot.tint = 0.75 * (byteOf(stone.bits, 1) - 0.45) + 0.30 * octaves(at, 5 * n, 2, salt + 4) -
              0.45 * rise(0.10, 0.0, inside) + 0.12 * body;
}

GroundSpot scree(dvec2 at) {
  GroundSpot spot;
  spot.heightM = 0.02 * octaves(at, 16, 3, 21);
  spot.tint = -0.45 + 0.4 * octaves(at, 48, 2, 22);
  lay(spot, at, 63, 1, 0.035, 23);
  lay(spot, at, 29, 0.75, 0.09, 24);
  lay(spot, at, 13, 0.55, 0.20, 25);
  lay(spot, at, 6, 0.30, 0.40, 26);
  return spot;
}

GroundSpot rock(dvec2 at) {
  const dvec2 bent = at + 0.03 * dvec2(noise(at, 5, 31), noise(at, 5, 32)) +
                     0.008 * dvec2(noise(at, 21, 33), noise(at, 21, 34));
  // Blocks between joints, each with a face of its own.
  const Cell block = cellAt({bent.x, bent.y}, 5, 35), piece = cellAt(bent, 14, 36);
  const dvec2 tilt(byteOf(block.bits, 2) - 0.5, byteOf(block.bits, 3) - 0.5);
  const dvec2 tip(byteOf(piece.bits, 2) - 0.5, byteOf(piece.bits, 3) - 0.5);
  const double joint = rise(0.085, 0.0, block.edge()), crack = rise(0.10, 0.0, piece.edge());
  const double rough = octaves(at, 10, 5, 37);
  const double ridged = 0.5 - std::abs(octaves(bent, 4, 4, 38));
  GroundSpot spot;
  spot.heightM = 0.30 * glm::dot(tilt, block.aside) + 0.07 * glm::dot(tip, piece.aside) + 0.11 * rough +
                 0.22 * ridged - 0.10 * joint - 0.03 * crack;
  spot.tint = 0.26 * (byteOf(block.bits, 1) - 0.5) + 0.24 * (byteOf(piece.bits, 1) - 0.5) + 0.36 * rough +
              0.25 * ridged - 0.36 * joint * byteOf(block.bits, 0) - 0.24 * crack * byteOf(piece.bits, 0);
  // Lichen.
  spot.tint += 0.28 * rise(0.30, 0.50, octaves(at, 8, 4, 39));
  return spot;
}

GroundSpot sand(dvec2 at) {
  // Ripples a foot apart, which fork where two of them meet, and shells and pebbles.
  const double bend = 0.55 * noise(at, 3, 41) + 0.32 * noise(at, 8, 42);
  const double wave = shared::bandWave(26 * at.y + 2.0 * bend + 2 * at.x).x;
  const double here = rise(-0.30, 0.25, octaves(at, 3, 2, 43));
  GroundSpot spot;
  spot.heightM = 0.026 * here * wave + 0.05 * octaves(at, 2, 2, 44) + 0.004 * noise(at, 110, 45);
  spot.tint =
      0.20 * here * wave + 0.30 * octaves(at, 3, 4, 46) + 0.2 * noise(at, 120, 47) + 0.2 * noise(at, 57, 48);
  const Cell pebble = cellAt(at, 33, 49);
  if (byteOf(pebble.bits, 2) > 0.90 && pebble.nearest < 0.2) {
    spot.heightM += 0.02 * std::sqrt(1 - pebble.nearest / 0.2);
    spot.tint = 0.7 * (byteOf(pebble.bits, 3) - 0.62);
  }
  return spot;
}

GroundSpot snow(dvec2 at) {
  // Sastrugi: long ridges that the wind has cut, steep on one side, over soft drifts.
  const dvec2 bent = at + 0.02 * dvec2(noise(at, 4, 51), noise(at, 4, 52));
  const double ridges = noise(bent, 5, 17, 53) + 0.5 * noise(bent, 11, 37, 54);
  const double cut = rise(-0.1, 0.45, ridges);
  const double crust = octaves(at, 24, 3, 55);
  GroundSpot spot;
  spot.heightM = 0.07 * cut + 0.05 * octaves(at, 2, 2, 56) + 0.006 * crust;
  spot.tint = 0.035 * cut + 0.03 * crust + 0.02 * octaves(at, 3, 2, 57);
  return spot;
}

}  // namespace

GroundSpot groundSpot(GroundMaterial material, double u, double v) {
  const dvec2 at(u, v);
  switch (material) {
    case GroundMaterial::grass:
      return grass(at);
    case GroundMaterial::forestFloor:
      return forestFloor(at);
    case GroundMaterial::scree:
      return scree(at);
    case GroundMaterial::rock:
      return rock(at);
    case GroundMaterial::sand:
      return sand(at);
    case GroundMaterial::snow:
      return snow(at);
    case GroundMaterial::count_:
      break;
  }
  return {};
}

}  // namespace skydrop::terrain
