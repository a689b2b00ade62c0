// What the ground looks like from a few metres: a square of each material, as a texture that repeats. Made of
// integer hashes with + - * / and square roots alone, so it is the same everywhere, and no file is shipped.
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "skydrop/core/settings.h"

namespace skydrop::terrain {

// In the order of the texture's layers (shaders/shared/ground_detail.glsl).
enum class GroundMaterial { grass, forestFloor, scree, rock, sand, snow, count_ };
inline constexpr int kGroundMaterials = static_cast<int>(GroundMaterial::count_);

inline constexpr double kReliefTileM = 7.5;   // side of the square, m; 128 of them to a chunk
inline constexpr double kReliefSteepest = 2;  // slope that a full byte stands for

// Texels along a side of each square: 128, 256 or 512.
enum class ReliefTexels { coarse, medium, fine };
int texelsOf(ReliefTexels texels);

// How the land close by is drawn. A value; any thread.
struct GroundDetailSettings {
  double contrast = 1;  // of light and dark against the material's mean, [0, 2]
  double relief = 1;    // of the slopes that catch light, [0, 2]
  double reach = 1;     // how far away it is seen, in units of the shipped distance, [0, 3]
  double erosion = 1;   // depth of the rills on slopes, in units of the shipped one, [0, 2]; rich land alone
  ReliefTexels texels = ReliefTexels::medium;

  bool operator==(const GroundDetailSettings&) const = default;
};

void describe(core::SettingsVisitor& visitor, GroundDetailSettings& settings);

// Squares of all materials. A value.
struct GroundRelief {
  // Of one material, row-major, x east and z south. Four bytes a texel, each 128 + 127 times a number in [-1,
  // 1]: slope along x and z (kReliefSteepest), share by which the albedo is higher than the material's, and
  // height in shares of the material's own relief. The mean of all of a level is 0 within half a byte's step
  // in each.
  struct Level {
    int texels = 0;
    std::vector<std::uint8_t> bytes;
  };
  // levels[material][k]: of half the sides of level k - 1, the last of one texel.
  std::vector<std::vector<Level>> levels;

  int texels() const { return levels.empty() ? 0 : levels[0][0].texels; }
};

// Relief and tint of a material at a place [0, 1) of its square, before any mean is taken out.
struct GroundSpot {
  double heightM = 0, tint = 0;
};
GroundSpot groundSpot(GroundMaterial material, double u, double v);

// `texels`: along a side, a power of two in [64, 512]. 60 ms for 256 (one core). Heeds `stop` between rows;
// what it gives then is not complete.
GroundRelief makeGroundRelief(int texels, std::stop_token stop = {});

}  // namespace skydrop::terrain
