// What a list that a compute shader makes begins with (shaders/listed.glsl): the groups of the indirect
// dispatch that goes through it, and its length.
#pragma once

#include <array>

#include "skydrop/render/gl/functions.h"

namespace skydrop::render {

struct ListGroups {
  std::array<GLuint, 3> groups{0, 0, 1};
  GLuint count = 0;
};

}  // namespace skydrop::render
