// What clouds leave of the light on land and sea. Of the sun: the optical depth of the whole layer along each
// sun ray, in a fine grid near the eye and a coarse one out to 24 km, or to where clouds have faded. Of the
// sky: clouds::SkyCover. A resource of the frame (FrameResources), published by CloudShadowPass, read by
// whoever lights a surface below the layer (shaders/clouds/shadow_map.glsl).
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "skydrop/render/gl/shader.h"
#include "skydrop/render/gl/texture.h"

namespace skydrop::render {

class CloudShadowMap {
 public:
  // A texture, kept alive by the cloud system, and rows that carry a place relative to the eye (and 1) to
  // its coordinates. It holds at least the rays that meet sea level this far from below the eye.
  struct Map {
    const gl::Texture* depths = nullptr;
    std::array<glm::vec4, 2> rows{};
    double radiusM = 0;
  };

  // A texture that repeats, kept alive by the cloud system. place: x and y of the eye in it, texture
  // coordinates a metre, and where clouds have faded (m from the eye).
  struct Sky {
    const gl::Texture* shares = nullptr;
    glm::vec4 place{0};
  };

  // Several layers, up to four: a channel of the maps each. Those that are not there shade nothing.
  struct Layers {
    int count = 0;
    std::array<glm::vec4, 4> skyPlaces{};       // as Sky::place
    glm::vec4 bases{0}, inverseThicknesses{0};  // m above the eye, 1/m
    glm::vec2 overcast{0};  // how overcast the sky is, [0, 1]; sine of the sun's elevation
  };

  // Nothing to bind.
  CloudShadowMap() = default;
  // baseAndThickness: of the layer, m, the base above the eye. Without maps of the sun while it is below the
  // horizon.
  CloudShadowMap(const Sky& sky, const glm::dvec2& baseAndThickness)
      : sky_(sky), layer_(baseAndThickness.x, 1 / baseAndThickness.y) {}
  CloudShadowMap(const Sky& sky, const glm::dvec2& baseAndThickness, const Map& fine, const Map& coarse)
      : CloudShadowMap(sky, baseAndThickness) {
    fine_ = fine;
    coarse_ = coarse;
  }

  // Of several layers; the hull's base and thickness as above.
  void setLayers(const Layers& layers) { layers_ = layers; }

  // Of the programs that include shaders/clouds/shadow_map.glsl: with what the clouds leave of the sun, or
  // without.
  std::vector<std::string> defines(bool hasSun) const;
  bool hasSun() const { return fine_.depths != nullptr; }

  // Textures and uniforms for such a program of defines(hasSun()). eyeRiseM: how much higher the eye of the
  // program's frame is than the one that all this counts from (FrameInput::eyeRiseM).
  void bind(gl::ShaderProgram& shader, double eyeRiseM = 0) const;

  // Of the layer, above the eye, m: higher up there is no shade.
  double topAboveEyeM() const { return static_cast<double>(layer_.x) + 1 / static_cast<double>(layer_.y); }

 private:
  // As in shaders/clouds/shadow_map.glsl.
  static constexpr GLuint kFineUnit = 10, kCoarseUnit = 11, kSkyUnit = 12;

  Sky sky_;
  Map fine_, coarse_;
  glm::vec2 layer_{0};
  Layers layers_;
};

}  // namespace skydrop::render
