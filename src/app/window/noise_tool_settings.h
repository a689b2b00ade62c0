// What the noise tool is set to: the texture, how it is looked at, how it is saved.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "app/window/noise_work.h"
#include "skydrop/core/settings.h"
#include "skydrop/noise/noise_settings.h"

namespace skydrop::app {

enum class NoiseKind { plane, volume };
inline constexpr std::array<std::string_view, 2> kNoiseKindNames = {"2D texture", "volume"};
enum class PlaneSide { side128, side256, side512, side1024, side2048 };
inline constexpr std::array<std::string_view, 5> kPlaneSideNames = {"128", "256", "512", "1024", "2048"};
enum class VolumeSide { side32, side64, side128, side256 };
inline constexpr std::array<std::string_view, 4> kVolumeSideNames = {"32", "64", "128", "256"};
enum class NoiseTexels { alpha8, luminance8, luminance16, luminanceFloat };
inline constexpr std::array<std::string_view, 4> kNoiseTexelsNames = {
    "alpha, 8 bits", "luminance, 8 bits", "luminance, 16 bits", "luminance, float"};
enum class NoiseHeader { legacy, dx10 };
inline constexpr std::array<std::string_view, 2> kNoiseHeaderNames = {"legacy", "DX10"};

struct NoiseToolSettings {
  noise::NoiseSettings noise;
  bool cut = false;
  noise::PostProcess clouds;

  NoiseKind kind = NoiseKind::plane;
  PlaneSide planeSide = PlaneSide::side512;
  VolumeSide volumeSide = VolumeSide::side64;
  bool tiled = false;  // 2 x 2
  double slice = 0;    // of the volume, a share of its period
  bool turns = true;   // the volume

  NoiseTexels texels = NoiseTexels::alpha8;
  NoiseHeader header = NoiseHeader::dx10;
};

void describe(core::SettingsVisitor& visitor, NoiseToolSettings& settings);

// What is asked for at full size, and the small one that is there at once.
NoiseOrder fullOrder(const NoiseToolSettings& settings);
NoiseOrder smallOrder(const NoiseToolSettings& settings);

core::TexelFormat texelsOf(NoiseTexels texels);

// As a file's recipe says.
void takeRecipe(NoiseToolSettings& settings, const noise::NoiseRecipe& recipe);

}  // namespace skydrop::app
