// A picture of the ground from above, and how the land wears it.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "skydrop/core/settings.h"

namespace skydrop::terrain {

struct GroundPictureSettings {
  double share = 1;       // of the ground's colour that is the picture's, [0, 1]
  double nearShare = .6;  // of that share, right before the eye: the rest is made detail, [0, 1]
  double nearM = 900;     // from which distance on the picture has its whole share, m, [1, 1e5]
  double gain = 1;        // reflectance for the picture's linear value, [0.1, 4]
  double edgeM = 400;     // over which distance within its edges it comes in, m, [1, 1e5]
  double megatexels = 8;  // that are kept at most, 2^20, [1/16, 64]

  bool operator==(const GroundPictureSettings&) const = default;
};

void describe(core::SettingsVisitor& visitor, GroundPictureSettings& settings);

// A value. Texels lie along the world's axes, x east and z south, and are square.
struct GroundPicture {
  // Row-major from the north-western corner: 8-bit sRGB-encoded colour, and in alpha the share that the
  // picture has there, 0 where it shows nothing. Transparent texels have colours of others near by.
  struct Level {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
  };

  glm::dvec2 corner{};        // the north-western one, m
  double texelM = 0;          // side of a texel of the first level, m
  std::vector<Level> levels;  // each of half the sides of the one before it; at least one

  double metresAcross() const { return texelM * levels[0].width; }
  double metresDown() const { return texelM * levels[0].height; }
};

inline constexpr int kMostGroundTexels = 8192;  // along a side

}  // namespace skydrop::terrain
