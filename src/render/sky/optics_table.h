// What the passes of halo and rainbow share: their tables, and when they can be seen.
#pragma once

#include <string>

#include "skydrop/render/frame/frame_input.h"
#include "skydrop/render/gl/texture.h"

namespace skydrop::render {

// The texture or volume of assets/optics with this name, as half floats that are filtered and held at the
// edges. Throws core::DataError unless it is a DDS file of 32-bit floats, RGBA, finite and from 0 to what a
// half float holds; `isVolume`: with slices.
gl::Texture opticsTable(gl::Context& context, const std::string& name, bool isVolume);

// Whether the light that casts shadows stands below the horizon of the eye, the whole disc of it.
bool isLightBelowHorizon(const FrameInput& frame);

// Whether all rays of the picture are more than `degrees` from a direction. Conservative: false for each
// picture that has a nearer ray.
bool isFartherThan(const View& view, const glm::dvec3& direction, double degrees);

}  // namespace skydrop::render
