// What shared shaders compile in, computed once a frame. Features are variants, never uniform branches:
// llvmpipe runs the body of an `if` whether it is taken or not.
#pragma once

#include <string>
#include <vector>

namespace skydrop::render {

struct FrameFeatures {
  bool haze = false;         // HAZE: extinction and in-scattering between eye and surface
  bool landShadows = false;  // no define: a LandShadowMap may be published in some frame

  bool spotLight = false;   // no define: a SpotLight may be published in some frame
  bool flashLight = false;  // no define: a FlashLight may be published in some frame

  bool overcast = false;  // OVERCAST: clouds of a weather may darken the air below them

  bool fallenWater = false;  // no define: a FallenWater may be published in some frame

  bool operator==(const FrameFeatures&) const = default;
};

// The defines of a variant: "HAZE" ...
std::vector<std::string> definesOf(const FrameFeatures& features);

}  // namespace skydrop::render
