// How water close by is drawn. A value; any thread.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "skydrop/core/settings.h"

namespace skydrop::render {

enum class WaterReflection { off, quarter, half, full };
inline constexpr std::array<std::string_view, 4> kWaterReflectionNames = {"off", "quarter", "half", "full"};

// Where mirrored rays look for what they meet: in the picture itself, or in one of its own, which is drawn
// from the eye's mirror image at the plane of the sea.
enum class WaterMirror { picture, plane };
inline constexpr std::array<std::string_view, 2> kWaterMirrorNames = {"picture", "plane"};

struct WaterDetailSettings {
  std::int64_t wavesPerOctave = 8;  // directions that waves of a length come from, [2, 8]
  double shortestM = 0.16;          // length of the shortest wave that is drawn, m, [0.04, 8]
  double foam = 1;                  // whitecaps and surf, as a share of what the wind makes, [0, 3]
  double turbidity = 1;             // matter in the water: 0 pure, 1 clear coastal water, [0, 20]
  double caustics = 0.7;            // how strongly waves gather light on the ground, [0, 1]
  WaterReflection reflection = WaterReflection::half;  // of the picture's width and height
  WaterMirror mirror = WaterMirror::picture;
  double mirrorMargin = 0.15;  // of a mirrored picture around the scene's, of its width and height, [0, 1]
  std::int64_t reflectionSteps = 24;  // along a mirrored ray, [4, 512]
  std::int64_t reflectionRays = 2;    // slopes of the waves that are not drawn, [1, 16]
  double reflectionM = 3000;          // how far mirrored rays look, m, [10, 20000]

  bool operator==(const WaterDetailSettings&) const = default;
};

// Pixels between two mirrored rays, and across a pixel of a mirrored picture: 1, 2, 4. Not of `off`.
int spacingOf(const WaterDetailSettings& settings);

void describe(core::SettingsVisitor& visitor, WaterDetailSettings& settings);

}  // namespace skydrop::render
