// The uniform block that every shader of a frame may read (shaders/frame.glsl, binding 0): written once a
// frame, matrices and 16-byte vectors only, so that both sides have equal offsets (a GL test compares them).
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "skydrop/render/sky_light.h"
#include "skydrop/render/view.h"

namespace skydrop::render {

inline constexpr unsigned kFrameUniformsBinding = 0;

// Light is multiplied by exposure. Positions are relative to the eye, in world axes.
struct FrameUniforms {
  glm::mat4 viewProjection;  // eye-relative position to clip space
  glm::mat4 ndcToRay;        // (ndc.x, ndc.y, 1, 0) to a ray whose component along the view axis is 1
  glm::vec4 eye;  // height above the sea (m), near plane (m), exposure, simulated time (s, wrapped at 3600)
  glm::vec4 viewport;         // width, height (pixels), 1 / width, 1 / height
  glm::vec4 toSun;            // xyz: unit vector; w: cosine of the radius at which the disc's edge is drawn
  glm::vec4 sunLight;         // rgb: illuminance of the sun at the eye's height on a surface that faces it
  glm::vec4 skyLight;         // rgb: illuminance by the sky on a level surface
  glm::vec4 groundLight;      // rgb: illuminance from below
  glm::vec4 sunOutside;       // rgb: illuminance of the sun above the atmosphere
  glm::vec4 nightRadiance;    // rgb
  glm::vec4 airRayleigh;      // rgb: scattering at sea level (1/m); w: scale height (m)
  glm::vec4 airHaze;          // extinction at sea level (1/m), scale height (m), albedo, anisotropy
  glm::vec4 horizonRayleigh;  // rgb: the sky's sources at the horizon, times sunOutside
  glm::vec4 horizonHaze;
  glm::vec4 horizonIsotropic;  // with the night's radiance
};

FrameUniforms frameUniforms(const View& view, const SkyLight& light, double simulatedSeconds);

}  // namespace skydrop::render
