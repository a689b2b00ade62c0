// The uniform block that every shader of a frame may read (shaders/frame.glsl, binding 0): written once a
// frame, matrices and 16-byte vectors only, so that both sides have equal offsets (a GL test compares them).
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "skydrop/render/frame/sky_light.h"
#include "skydrop/render/frame/view.h"

namespace skydrop::render {

inline constexpr unsigned kFrameUniformsBinding = 0;

// Light is multiplied by exposure. Positions are relative to the eye, in world axes.
struct FrameUniforms {
  glm::mat4 viewProjection;  // eye-relative position to clip space
  glm::mat4 ndcToRay;        // (ndc.x, ndc.y, 1, 0) to a ray whose component along the view axis is 1
  glm::vec4 eye;  // height above the sea (m), near plane (m), exposure, simulated time (s, wrapped at 3600)
  glm::vec4 viewport;  // width, height (pixels), 1 / width, 1 / height
  glm::vec4
      toSun;  // xyz: unit vector to what casts shadows, sun or moon; w: angular radius of its disc (rad)
  glm::vec4 sunLight;       // rgb: its illuminance at the eye's height on a surface that faces it
  glm::vec4 skyLight;       // rgb: illuminance by the sky on a level surface
  glm::vec4 groundLight;    // rgb: illuminance from below
  glm::vec4 sunDisc;        // rgb: radiance of the sun's disc; may exceed a half float
  glm::vec4 nightRadiance;  // rgb
  glm::vec4 airRayleigh;    // rgb: scattering at sea level (1/m); w: scale height (m)
  glm::vec4 airHaze;        // extinction at sea level (1/m), scale height (m), albedo, anisotropy
  glm::vec4 columnDepth;    // rgb: optical depth above the eye; w: air mass towards the sun
  glm::vec4 columnHere;     // rgb: scattering of air at the eye (1/m); w: extinction of haze there (1/m)
  glm::vec4 airLight;       // rgb: illuminance on the air above the eye
  glm::vec4 hazeLight;      // rgb: on the haze, times its albedo
  glm::vec4 overhead;       // rgb: radiance of the sky overhead, scattered once
  glm::vec4 depthToSea;  // rgb: optical depth straight down to the sea; w: angle across a middle pixel (rad)
  glm::vec4 horizonRayleigh;  // rgb: the sky's sources at the horizon
  glm::vec4 horizonHaze;
  glm::vec4 horizonIsotropic;  // with the night's radiance
  glm::vec4 skySun;            // xyz: unit vector to the sun; w: radius of its disc (rad)
  glm::vec4 skyTable;  // of the shell: sines of the elevations at which the sea (x) and the air (y) end; zw:
                       // level unit vector (x, z) of skyGlow, 0 where it is vertical
  glm::vec4 skyGlow;   // of the shell, xyz: unit vector around which the sky is bright, to sun or moon
  glm::vec4 overcast;  // Overcast: cover, left, base above the eye (m)
};

FrameUniforms frameUniforms(const View& view, const SkyLight& light, double simulatedSeconds);

}  // namespace skydrop::render
