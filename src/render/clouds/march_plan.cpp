#include "render/clouds/march_plan.h"

#include <algorithm>
#include <cmath>

#include "skydrop/core/shared.h"

namespace skydrop::render {
namespace {

constexpr int kTileSide = 16, kExactTileSide = 8;  // pixels

// The most times that all loops of a ray can run together. A segment with its light is at least so deep, or
// kMaxStepsPerSegment steps long.
double mostIterations(const clouds::CloudSettings& s) {
  const double growthBegins = s.march.stepM / s.march.stepGrowth;
  const double steps =
      growthBegins / s.march.stepM * (1 + std::max(0.0, std::log2(s.fadeDistance / growthBegins)));
  const double segments = steps / core::shared::f64::kMaxStepsPerSegment -
                          std::log(s.march.transmittanceCutoff) / s.march.maxSegmentOpticalDepth;
  return 2 * steps + segments * static_cast<double>(s.march.sunSamples);
}

}  // namespace

bool isMultiDispatch(const clouds::CloudSettings& settings) {
  return settings.march.exact && mostIterations(settings) > core::shared::f64::kMostIterations;
}

int tileSideOf(const clouds::CloudSettings& settings) {
  return settings.march.exact ? kExactTileSide : kTileSide;
}

int widestSpacing(const clouds::CloudSettings& settings) {
  return settings.march.exact ? 1 : 1 << static_cast<int>(settings.march.resolution);
}

int raysAcross(int pixels, int spacing, int widest) {
  return spacing == 1 ? pixels : ((pixels + widest - 1) / widest) * (widest / spacing) + 1;
}

std::vector<std::string> marchDefines(std::span<const std::string> ofFrame,
                                      const clouds::CloudSettings& settings, bool flatLoops) {
  std::vector<std::string> defines(ofFrame.begin(), ofFrame.end());
  if (flatLoops) defines.emplace_back("FLAT_LOOPS");
  if (settings.march.detail) defines.emplace_back("DETAIL");
  if (isMultiDispatch(settings)) defines.emplace_back("MULTI_DISPATCH");
  defines.push_back("TILE_SIDE " + std::to_string(tileSideOf(settings)));
  return defines;
}

std::vector<std::string> withSpacing(std::span<const std::string> defines, int spacing) {
  std::vector<std::string> all(defines.begin(), defines.end());
  all.push_back("RAY_SPACING " + std::to_string(spacing));
  return all;
}

std::vector<std::string> withGroups(std::span<const std::string> defines, int spacing) {
  std::vector<std::string> all = withSpacing(defines, spacing);
  all.push_back(spacing == 1 ? "GROUP_SIZE 256" : "GROUP_SIZE 64");  // a tile's rays, or those of four tiles
  return all;
}

}  // namespace skydrop::render
