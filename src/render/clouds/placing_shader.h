#pragma once

#include <string>

#include "skydrop/render/frame/land_ground.h"
#include "skydrop/render/frame/pass.h"
#include "skydrop/render/gl/shader.h"

namespace skydrop::render {

// A program that places instances on the land (its file includes shaders/terrain/placing.glsl), in use, with
// the land, the places, and whatever shades (clouds, land, ice), lights (lamp, flash) and covers them (snow) in
// this frame.
gl::ComputeShader& placingShader(FrameContext& context, const LandGround& land, const std::string& file);

}  // namespace skydrop::render
