#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "skydrop/render/gl/shader.h"
#include "skydrop/render/gl/texture.h"

namespace skydrop::render {

// The fields, ways and buildings around the eye, as the land's colour and what grows on it have to know. A
// resource of the frame (FrameResources), published before land is drawn; programs that are compiled with
// kDefine show it (shaders/terrain/places.glsl), without one nothing of it is compiled.
struct PlaceMap {
  static constexpr const char* kDefine = "PLACES";
  static constexpr unsigned kGridUnit = 7, kDataUnit = 8;  // as in that file

  const gl::Texture* grid = nullptr;  // RG32UI, a texel to a square of 32 m
  const gl::Texture* data = nullptr;  // RGBA32UI
  glm::dvec2 corner{0};               // north-west, world (x, z), m
  double fadeM = 0, farM = 0;         // what is painted fades in between, m

  // For programs that include that file, in use. base: LandGround::base().
  void set(gl::ShaderProgram& shader, const glm::dvec2& base) const {
    shader.setVec4("placeFrame", glm::vec4(glm::vec2(corner - base), fadeM, farM));
    grid->bind(kGridUnit);
    data->bind(kDataUnit);
  }
};

}  // namespace skydrop::render
