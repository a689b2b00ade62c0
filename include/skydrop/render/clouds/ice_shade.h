#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "skydrop/render/frame/light_shares.h"
#include "skydrop/render/frame/view.h"
#include "skydrop/render/gl/shader.h"
#include "skydrop/render/gl/texture.h"

namespace skydrop::render {

// What the ice clouds of a frame leave of the light below them. A resource of the frame (FrameResources),
// published before land is drawn by the pass that owns it.
class IceShade {
 public:
  static constexpr GLuint kMapUnit = 5;  // of shaders/clouds/ice_shade_map.glsl

  virtual ~IceShade() = default;

  // Of the sun (what comes on from its direction or near it), and of the light of the sky, which what the ice
  // scatters makes more: [0, 1] and [1, 2]. Smoothed over 3 km, and 1 above the ice.
  virtual LightShares below(const glm::dvec3& place) const = 0;
  // The same as a map, for programs that include that file.
  virtual void bind(gl::ShaderProgram& shader, const View& view) const = 0;
};

}  // namespace skydrop::render
