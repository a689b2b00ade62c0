// The block of shaders/clouds/uniforms.glsl, as FrameUniforms is one: 16-byte vectors only.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "render/clouds/weather_layers.h"
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

// One of several layers, as in shaders/clouds/uniforms.glsl.
struct CloudLayerUniforms {
  glm::vec4 shapePlace, shapeScale, detailPlace, weatherPlace;
  glm::vec4 shell;
  glm::vec4 medium;
  glm::vec4 profile, form;
  glm::vec4 strides;
  glm::vec4 cells;
  glm::vec4 sunLight, skyLight, groundLight;
};

// The block of variants with LAYERS, which may be fewer than there is room for.
struct CloudUnionUniforms {
  CloudUniforms common;
  glm::vec4 shells;
  std::array<CloudLayerUniforms, WeatherLayers::kMost> layers;
};

// The media of several layers seen from a place in the field. The rest is 0.
CloudUnionUniforms unionUniforms(std::span<const DrawnLayer> layers, double fadeDistance,
                                 const glm::dvec3& placeInField, double meanDetail);
// Each has its own: sun and sky are dimmed by what lies above, the ground's light by all.
void addLight(CloudUnionUniforms& uniforms, std::span<const DrawnLayer> layers, const SkyLight& light);
void addMarch(CloudUnionUniforms& uniforms, std::span<const DrawnLayer> layers,
              const clouds::CloudSettings& settings, const View& view, int tilePixels);

// A layer from the lowest base to the highest top of those that are there; without any, one of no thickness.
clouds::CloudLayerSettings hullOf(std::span<const DrawnLayer> layers);

// Of a field seen from a place in it (drift taken off): all that has to do with the medium. The rest is 0.
CloudUniforms fieldUniforms(const clouds::CloudLayerSettings& layer, double fadeDistance,
                            const glm::dvec3& placeInField, double meanDetail);

// Light, direction and steps of a frame. Tiles are of so many pixels a side. skyMean: of the light above,
// what the layer leaves in the mean to the ground, which sends back as much less, (0, 1].
void addLight(CloudUniforms& uniforms, const clouds::CloudLayerSettings& layer, double skyMean,
              const SkyLight& light);
// What ice above leaves of it over the eye's place, after addLight().
void addIceShade(CloudUniforms& uniforms, const clouds::CloudLayerSettings& layer, const IceShade& ice,
                 const glm::dvec3& eye);
void addIceShade(CloudUnionUniforms& uniforms, std::span<const DrawnLayer> layers, const IceShade& ice,
                 const glm::dvec3& eye);
void addMarch(CloudUniforms& uniforms, const clouds::CloudSettings& settings,
              const clouds::ClearAir& clearAir, const View& view, int tilePixels);

}  // namespace skydrop::render
