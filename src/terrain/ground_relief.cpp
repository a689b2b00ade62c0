#include "skydrop/terrain/ground_relief.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/vec4.hpp>
#include <string_view>

namespace skydrop::terrain {
namespace {

constexpr double kMostTint = 0.95;

std::uint8_t byteOf(double x) {
  return static_cast<std::uint8_t>(std::floor(128.5 + 127 * std::clamp(x, -1.0, 1.0)));
}

// Slopes, tint and height of every texel, the mean of each 0.
std::vector<glm::dvec4> squareOf(GroundMaterial material, int texels, const std::stop_token& stop) {
  const auto count = static_cast<std::size_t>(texels) * texels;
  std::vector<GroundSpot> spots(count);
  for (int y = 0; y < texels && !stop.stop_requested(); ++y) {
    for (int x = 0; x < texels; ++x)
      spots[static_cast<std::size_t>(y) * texels + x] =
          groundSpot(material, (x + 0.5) / texels, (y + 0.5) / texels);
  }
  const auto heightAt = [&](int x, int y) {
    return spots[static_cast<std::size_t>((y + texels) % texels) * texels + (x + texels) % texels].heightM;
  };
  double meanHeight = 0, meanTint = 0, lowest = 1e9, highest = -1e9;
  for (const GroundSpot& spot : spots) {
    meanHeight += spot.heightM / static_cast<double>(count);
    lowest = std::min(lowest, spot.heightM), highest = std::max(highest, spot.heightM);
    meanTint += spot.tint / static_cast<double>(count);
  }
  const double twice = 2 * kReliefTileM / texels, range = std::max(highest - lowest, 1e-6);
  std::vector<glm::dvec4> square(count);
  for (int y = 0; y < texels; ++y) {
    for (int x = 0; x < texels; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * texels + x;
      const auto slope = [&](double rise) { return std::clamp(rise / twice / kReliefSteepest, -1.0, 1.0); };
      square[i] = {slope(heightAt(x + 1, y) - heightAt(x - 1, y)),
                   slope(heightAt(x, y + 1) - heightAt(x, y - 1)),
                   std::clamp(spots[i].tint - meanTint, -kMostTint, kMostTint),
                   (spots[i].heightM - meanHeight) / range};
    }
  }
  // What is cut off at the ends leaves a mean again.
  glm::dvec4 mean(0);
  for (const glm::dvec4& texel : square) mean += texel / static_cast<double>(count);
  for (glm::dvec4& texel : square) texel -= mean;
  return square;
}

std::vector<glm::dvec4> halved(const std::vector<glm::dvec4>& square, int texels) {
  const int half = texels / 2;
  std::vector<glm::dvec4> result;
  result.reserve(static_cast<std::size_t>(half) * half);
  for (int y = 0; y < half; ++y) {
    for (int x = 0; x < half; ++x) {
      const std::size_t at = static_cast<std::size_t>(2 * y) * texels + 2 * x;
      result.push_back(0.25 * (square[at] + square[at + 1] + square[at + texels] + square[at + texels + 1]));
    }
  }
  return result;
}

GroundRelief::Level levelOf(const std::vector<glm::dvec4>& square, int texels) {
  GroundRelief::Level level{texels, {}};
  level.bytes.reserve(4 * square.size());
  for (const glm::dvec4& texel : square) {
    for (int c = 0; c < 4; ++c) level.bytes.push_back(byteOf(texel[c]));
  }
  return level;
}

}  // namespace

int texelsOf(ReliefTexels texels) { return 128 << static_cast<int>(texels); }

void describe(core::SettingsVisitor& visitor, GroundDetailSettings& s) {
  visitor.number("contrast", s.contrast,
                 {.unit = "1",
                  .min = 0,
                  .max = 2,
                  .help = "How much lighter and darker single tufts, stones and ripples are than the ground.",
                  .aliases = "ground texture, close, near, tint"});
  visitor.number("relief", s.relief,
                 {.unit = "1",
                  .min = 0,
                  .max = 2,
                  .help = "How much the light shows the ground's small slopes and the edges of rock layers.",
                  .aliases = "ground texture, bumps, normals"});
  visitor.number("reach", s.reach,
                 {.unit = "1",
                  .min = 0,
                  .max = 4,
                  .help = "How far away the ground's detail is drawn; 1: until a pixel covers half a metre.",
                  .aliases = "ground texture, distance, LOD"});
  visitor.number("erosion", s.erosion,
                 {.unit = "1",
                  .min = 0,
                  .max = 2,
                  .help = "How deep running water has cut the slopes; drawn where render.land.detail is rich.",
                  .aliases = "ground texture, rills, gullies, lines, slopes"});
  static constexpr std::array<std::string_view, 3> kNames{"coarse", "medium", "fine"};
  visitor.choice("texels", s.texels, kNames,
                 {.help = "Side of each material's square of 7.5 m: 128, 256 or 512 texels.",
                  .takesEffect = core::TakesEffect::rebuild,
                  .aliases = "ground texture, resolution"});
}

GroundRelief makeGroundRelief(int texels, std::stop_token stop) {
  assert(texels >= 64 && texels <= 512 && (texels & (texels - 1)) == 0);
  GroundRelief relief;
  for (int m = 0; m < kGroundMaterials; ++m) {
    std::vector<glm::dvec4> square = squareOf(static_cast<GroundMaterial>(m), texels, stop);
    std::vector<GroundRelief::Level> levels;
    for (int side = texels;; side /= 2) {
      levels.push_back(levelOf(square, side));
      if (side == 1) break;
      square = halved(square, side);
    }
    relief.levels.push_back(std::move(levels));
  }
  return relief;
}

}  // namespace skydrop::terrain
