#pragma once

#include "skydrop/render/gl/texture.h"

namespace skydrop::render {

// What the rays of a picture see of the clouds and where, a texel a ray, as in CloudTransmittance.
struct CloudRays {
  gl::Texture light, distances;
};

}  // namespace skydrop::render
