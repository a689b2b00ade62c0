// The block of shaders/clouds/uniforms.glsl, as FrameUniforms is one: 16-byte vectors only.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "skydrop/clouds/clear_air.h"
#include "skydrop/clouds/cloud_settings.h"
#include "skydrop/render/clouds/ice_shade.h"
#include "skydrop/render/frame/sky_light.h"
#include "skydrop/render/frame/view.h"

namespace skydrop::render {

inline constexpr unsigned kCloudUniformsBinding = 1;

struct CloudUniforms {
  glm::vec4 shapePlace, detailPlace, weatherPlace;
  glm::vec4 layer;
  glm::vec4 medium;
  glm::vec4 scattering;
  glm::vec4 toSun;
  glm::vec4 sunLight, skyLight, groundLight;
  glm::vec4 march, strides, sunSteps, exact;
  glm::vec4 cells;
  glm::vec4 farField;
  glm::vec4 sight;
};

// Of a field seen from a place in it (drift taken off): all that has to do with the medium. The rest is 0.
CloudUniforms fieldUniforms(const clouds::CloudLayerSettings& layer, double fadeDistance,
                            const glm::dvec3& placeInField, double meanDetail);

// Light, direction and steps of a frame. Tiles are of so many pixels a side.
void addLight(CloudUniforms& uniforms, const clouds::CloudLayerSettings& layer, const SkyLight& light);
// What ice above leaves of it over the eye's place, after addLight().
void addIceShade(CloudUniforms& uniforms, const clouds::CloudLayerSettings& layer, const IceShade& ice,
                 const glm::dvec3& eye);
void addMarch(CloudUniforms& uniforms, const clouds::CloudSettings& settings,
              const clouds::ClearAir& clearAir, const View& view, int tilePixels);

}  // namespace skydrop::render
