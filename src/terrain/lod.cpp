#include "skydrop/terrain/lod.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "skydrop/core/hash.h"

namespace skydrop::terrain {
namespace {

// Places at which the relief is measured, in a square of this half side around the origin.
constexpr int kReliefPlaces = 512;
constexpr double kReliefSquareM = 200000;
constexpr double kReliefQuantile = 0.95;

// Beyond the view distance tolerances grow with the square root of the distance.
constexpr double kFarGrowth = 0.5;

// Largest distance from the eye, in chunks of its own level, at which a chunk can be wanted; the GPU finds
// chunks through a table of 32 x 32 cells a level (docs/terrain-streaming.md).
constexpr double kLargestSplitChunks = 6;

// The distance at which a tolerance that is reached at `metres` without the view distance is reached with it.
double withFarGrowth(double metres, double viewDistance) {
  if (metres <= viewDistance) return metres;
  return viewDistance * std::pow(metres / viewDistance, 1.0 / (1.0 + kFarGrowth));
}

}  // namespace

ReliefErrors measureRelief(const HeightSource& source) {
  core::RandomStream random{0x7e11ef, 0};
  std::array<std::vector<double>, kTopPatchLevel + 1> errors;
  for (int place = 0; place < kReliefPlaces; ++place) {
    const glm::dvec2 at{(2 * random.nextUnit() - 1) * kReliefSquareM,
                        (2 * random.nextUnit() - 1) * kReliefSquareM};
    const double here = source.height(at);
    if (here < 0) continue;
    // A mesh is farthest from the land in the middle of its edges: along x, along z, and along the diagonal.
    for (int level = 1; level <= kTopPatchLevel; ++level) {
      const double half = 0.5 * cellMetres(level);
      double worst = 0;
      for (const glm::dvec2 edge : {glm::dvec2(half, 0), glm::dvec2(0, half), glm::dvec2(half, -half)}) {
        worst = std::max(worst, std::abs(here - 0.5 * (source.height(at - edge) + source.height(at + edge))));
      }
      errors[static_cast<std::size_t>(level)].push_back(worst);
    }
  }
  ReliefErrors relief{};
  for (std::size_t level = 1; level < relief.size(); ++level) {
    std::vector<double>& e = errors[level];
    if (e.empty()) continue;
    const auto nth =
        e.begin() + static_cast<std::ptrdiff_t>(kReliefQuantile * static_cast<double>(e.size() - 1));
    std::nth_element(e.begin(), nth, e.end());
    relief[level] = std::max(relief[level - 1], *nth);
  }
  return relief;
}

double LodDistances::lambda(double distanceM) const {
  double lambda = 0;
  for (std::size_t l = 0; l + 1 < morph.size(); ++l) {
    lambda += std::clamp((distanceM - morph[l]) / (morph[l + 1] - morph[l]), 0.0, 1.0);
  }
  return std::min(lambda, kTopPatchLevel - 0.001);
}

LodDistances makeLodDistances(const ReliefErrors& relief, double pixelsPerRadian,
                              const TerrainStreamingSettings& settings) {
  LodDistances lod;
  for (int level = 0; level <= kTopPatchLevel; ++level) {
    const auto l = static_cast<std::size_t>(level);
    const double cell = cellMetres(level);
    // Finer than its samples' own spacing on the picture no mesh need be, however rough the land.
    const double finest =
        std::min(cell * pixelsPerRadian / settings.texelPixels, kLargestSplitChunks * chunkMetres(level));
    const double coarsest = cell * pixelsPerRadian / std::max(settings.cellPixels, settings.texelPixels);
    const double byError = relief[l] * pixelsPerRadian / settings.pixelError;
    const double least = kLeastReachM * cell / kCellMetres;
    if (level == 0) continue;
    const double reach = std::clamp(std::max(byError, coarsest), least, std::max(finest, least));
    lod.morph[l] = withFarGrowth(reach, settings.viewDistanceM);
    // Far enough apart that no level is passed in one step.
    if (level > 1) lod.morph[l] = std::max(lod.morph[l], lod.morph[l - 1] * std::sqrt(2.0));
    if (level <= kMaxChunkLevel) {
      // Patches beside much finer ones are split too (patch_selection.cpp): their finer samples must be
      // there.
      const double beside = lod.morph[l - 1] + 2 * chunkMetres(level) / kPatchesPerChunk;
      lod.split[l] = std::max({withFarGrowth(finest, settings.viewDistanceM), lod.morph[l], beside});
    }
  }
  lod.morph[0] = 0.5 * lod.morph[1];
  return lod;
}

}  // namespace skydrop::terrain
