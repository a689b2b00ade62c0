#pragma once

#include <array>
#include <cstddef>
#include <glm/vec4.hpp>
#include <span>

#include "skydrop/render/gl/shader.h"
#include "skydrop/render/gl/texture.h"

namespace skydrop::render {

// Waves of the sea as a frame shows them near the eye. A resource of the frame (FrameResources), published
// before the land is drawn: land asks for it to show the ground below the water, and the sea. Programs that
// are compiled with kDefine show it (shaders/terrain/sea_waves.glsl); without one nothing of it is compiled.
struct SeaWaves {
  static constexpr const char* kDefine = "WATER_DETAIL";
  // With it the sea keeps what it mirrors in `mirror` besides.
  static constexpr const char* kKeepsDefine = "KEEPS_MIRROR";
  static constexpr std::size_t kMost = 64;  // as in shaders/terrain/sea_waves.glsl

  // The longest first; see withWave() of shaders/shared/sea_waves.glsl.
  std::array<glm::vec4, kMost> ways{}, shapes{};
  std::size_t count = 0;
  double slope = 0;              // standard deviation of all waves along each axis
  double threshold = -6;         // of whitecaps, in standard deviations
  double surfClock = 0;          // turns of the bores on the beach, [0, 1)
  double foam = 1;               // how much of all foam there is
  double turbidity = 1;          // of the water
  double caustics = 1;           // how strongly waves gather light on the ground, [0, 1]
  double curvatureVariance = 0;  // of the surface by the waves that gather light, 1/m^2
  std::size_t causticCount = 0;  // waves that do: the first of all

  // RGBA16F of the picture's size, valid where it shows the sea: the light of the sky that the water mirrors,
  // as it reaches the eye, and the share of what comes along the mirrored ray that reaches it. Null where
  // nobody asks.
  const gl::Texture* mirror = nullptr;

  // For programs that include that file, in use.
  void set(gl::ShaderProgram& shader) const {
    if (count > 0) {
      shader.setVec4s("seaWays", std::span(ways).first(count));
      shader.setVec4s("seaShapes", std::span(shapes).first(count));
    }
    shader.setInt("seaWaveCount", static_cast<int>(count));
    shader.setInt("seaCausticCount", static_cast<int>(causticCount));
    shader.setVec4("seaState", glm::vec4(slope, threshold, surfClock, foam));
    shader.setVec4("seaWater", glm::vec4(turbidity, caustics, curvatureVariance, 0));
  }
};

}  // namespace skydrop::render
