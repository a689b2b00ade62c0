#include "render/clouds/cloud_uniforms.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "skydrop/clouds/occupancy.h"
#include "skydrop/clouds/raised_sun.h"
#include "skydrop/core/shared.h"

namespace skydrop::render {
namespace {

glm::vec4 packed(const glm::dvec3& xyz, double w) { return glm::vec4(glm::vec3(xyz), static_cast<float>(w)); }

// In periods, [0, 1): wrapped in double before anything is rounded.
glm::vec4 inPeriods(const glm::dvec3& place, double period) {
  const glm::dvec3 periods = place / period;
  return packed(periods - glm::floor(periods), 1 / period);
}

// The sky's light below clouds that let a share through: what droplets have scattered has the colour of all
// light that falls on them, so the less comes through, the less blue is left of it.
glm::dvec3 belowClouds(const glm::dvec3& sky, const glm::dvec3& all, double share) {
  const auto luminance = [](const glm::dvec3& rgb) {
    return glm::dot(rgb, glm::dvec3(0.2126, 0.7152, 0.0722));
  };
  const glm::dvec3 scattered = all * (luminance(sky) / std::max(luminance(all), 1e-12));
  return glm::mix(scattered, sky, share) * share;
}

// Where steps begin to grow: an even number of them, so that longer steps begin at multiples of themselves.
double growthBegin(const clouds::MarchSettings& march) {
  return march.stepM * 2 * std::round(0.5 / march.stepGrowth);
}

// Where the far field begins: at the end of a turn of its steps, however often those before it have doubled.
double farBegin(const clouds::MarchSettings& march) {
  const double doubled = std::max(0.0, std::floor(std::log2(march.farStartM / growthBegin(march))));
  const double turn = core::shared::f64::kSamplesATurn * march.stepM * std::exp2(doubled) * march.farStep;
  return std::max(1.0, std::round(march.farStartM / turn)) * turn;
}

// By what ice leaves of the light at the layer's middle over the eye's place.
template <class Uniforms>
void dim(Uniforms& u, const clouds::CloudLayerSettings& layer, const IceShade& ice, const glm::dvec3& eye) {
  const LightShares shares = ice.below({eye.x, layer.cloudHeight + 0.5 * layer.thickness, eye.z});
  u.sunLight *= glm::vec4(glm::vec3(static_cast<float>(shares.sun)), 1);
  u.skyLight *= glm::vec4(glm::vec3(static_cast<float>(shares.sky)), 1);
}

}  // namespace

CloudUniforms fieldUniforms(const clouds::CloudLayerSettings& s, double fadeDistance, const glm::dvec3& place,
                            double meanDetail) {
  const double weatherPeriod = clouds::weatherPeriod(s, fadeDistance);
  CloudUniforms u{};
  u.shapePlace = inPeriods(place, clouds::shapePeriod(s));
  u.detailPlace = inPeriods(place, clouds::detailPeriod(s));
  u.weatherPlace = inPeriods(place, weatherPeriod);
  u.layer = glm::vec4(s.cloudHeight - place.y, s.thickness, fadeDistance, s.extinction);
  u.medium = glm::vec4(s.densityThreshold, s.coverage, s.typeShift, s.erosion);
  u.scattering = glm::vec4(s.anisotropy, s.forwardShare, meanDetail, 0);
  const double cellsAPeriod = clouds::Occupancy::kSide;
  u.cells = glm::vec4(u.weatherPlace.x * clouds::Occupancy::kSide, cellsAPeriod / weatherPeriod,
                      u.weatherPlace.z * clouds::Occupancy::kSide, clouds::Occupancy::kRows / s.thickness);
  return u;
}

clouds::CloudLayerSettings hullOf(std::span<const DrawnLayer> layers) {
  clouds::CloudLayerSettings hull;
  double low = 1e9, high = -1e9;
  for (const DrawnLayer& layer : layers) {
    if (!layer.isThere) continue;
    low = std::min(low, layer.medium.layer.cloudHeight);
    high = std::max(high, layer.medium.layer.cloudHeight + layer.medium.layer.thickness);
  }
  hull.cloudHeight = std::min(low, high);
  hull.thickness = std::max(high - low, 0.0);
  return hull;
}

CloudUnionUniforms unionUniforms(std::span<const DrawnLayer> layers, double fadeDistance,
                                 const glm::dvec3& place, double meanDetail) {
  const clouds::CloudLayerSettings hull = hullOf(layers);
  CloudUnionUniforms u{};
  u.common.layer = glm::vec4(hull.cloudHeight - place.y, hull.thickness, fadeDistance, 0);
  u.common.scattering = glm::vec4(hull.anisotropy, hull.forwardShare, meanDetail, 0);
  u.shells = glm::vec4(hull.cloudHeight + hull.thickness - place.y, 0, 0, 0);
  for (std::size_t i = 0; i < layers.size(); ++i) {
    CloudLayerUniforms& l = u.layers[i];
    if (!layers[i].isThere) {
      l.shell = glm::vec4(1e9, 1, 1, 0);  // where no ray comes
      continue;
    }
    const clouds::CloudLayerSettings& s = layers[i].medium.layer;
    const clouds::CloudForm& form = layers[i].medium.form;
    const double weatherPeriod = clouds::weatherPeriod(layers[i].medium);
    l.shapePlace = inPeriods(place * form.stretch, clouds::shapePeriod(s));
    l.shapeScale = packed(form.stretch / clouds::shapePeriod(s), 0);
    l.detailPlace = inPeriods(place, clouds::detailPeriod(s));
    l.weatherPlace = inPeriods(place, weatherPeriod);
    l.shell = glm::vec4(s.cloudHeight - place.y, s.thickness, 1 / s.thickness, s.extinction);
    l.medium = glm::vec4(s.densityThreshold, s.coverage, s.typeShift, s.erosion);
    l.profile = glm::vec4(form.slopes());
    l.form = glm::vec4(form.own, form.anvilBase, form.spread, form.anvilThreshold);
    const double cellsAPeriod = clouds::Occupancy::kSide;
    l.cells = glm::vec4(l.weatherPlace.x * clouds::Occupancy::kSide, cellsAPeriod / weatherPeriod,
                        l.weatherPlace.z * clouds::Occupancy::kSide, clouds::Occupancy::kRows / s.thickness);
    l.sunLight.w = static_cast<float>(form.taper);
    l.skyLight.w = static_cast<float>(form.contrast);
  }
  return u;
}

void addLight(CloudUnionUniforms& u, std::span<const DrawnLayer> layers, const SkyLight& light) {
  u.common.toSun = packed(clouds::raisedSun(light.direct.toSun), 0);
  const auto middleOf = [](const DrawnLayer& layer) {
    return layer.medium.layer.cloudHeight + 0.5 * layer.medium.layer.thickness;
  };
  double toGround = 1;
  for (const DrawnLayer& layer : layers) toGround *= layer.isThere ? layer.skyMean : 1;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (!layers[i].isThere) continue;
    const double middle = middleOf(layers[i]);
    // Of each other layer, what lies above the middle of this one.
    double above = 1;
    for (const DrawnLayer& other : layers) {
      if (!other.isThere || &other == &layers[i]) continue;
      const double apart = 0.5 * (other.medium.layer.thickness + layers[i].medium.layer.thickness);
      above *= std::pow(other.skyMean, std::clamp((middleOf(other) - middle) / apart, 0.0, 1.0));
    }
    const glm::dvec3 sun = sky::sunIlluminance(light.direct, middle);
    CloudLayerUniforms& l = u.layers[i];
    l.sunLight = packed(sun * light.exposure, static_cast<double>(l.sunLight.w));
    const glm::dvec3 all = light.sky + sun * std::max(light.direct.toSun.y, 0.0);
    l.skyLight =
        packed(belowClouds(light.sky, all, above) * light.exposure, static_cast<double>(l.skyLight.w));
    l.groundLight = packed(light.ground * (toGround * light.exposure), 0);
  }
}

void addMarch(CloudUnionUniforms& u, std::span<const DrawnLayer> layers,
              const clouds::CloudSettings& settings, const View& view, int tilePixels) {
  addMarch(u.common, settings, clouds::ClearAir{}, view, tilePixels);
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (!layers[i].isThere) continue;
    const clouds::ClearAir& air = layers[i].work->clearAir;
    u.layers[i].strides = glm::vec4(air.leastShape, air.slopeM * settings.march.clearStride,
                                    air.slopeM * settings.march.sunClearStride, air.evenWear);
  }
}

void addLight(CloudUniforms& u, const clouds::CloudLayerSettings& layer, double skyMean,
              const SkyLight& light) {
  u.toSun = packed(clouds::raisedSun(light.direct.toSun), 0);
  const double middle = layer.cloudHeight + 0.5 * layer.thickness;
  u.sunLight = packed(sky::sunIlluminance(light.direct, middle) * light.exposure, 0);
  u.skyLight = packed(light.sky * light.exposure, 0);
  u.groundLight = packed(light.ground * (skyMean * light.exposure), 0);
}

void addIceShade(CloudUniforms& u, const clouds::CloudLayerSettings& layer, const IceShade& ice,
                 const glm::dvec3& eye) {
  dim(u, layer, ice, eye);
}

void addIceShade(CloudUnionUniforms& u, std::span<const DrawnLayer> layers, const IceShade& ice,
                 const glm::dvec3& eye) {
  for (std::size_t i = 0; i < layers.size(); ++i) dim(u.layers[i], layers[i].medium.layer, ice, eye);
}

void addMarch(CloudUniforms& u, const clouds::CloudSettings& settings, const clouds::ClearAir& clearAir,
              const View& view, int tilePixels) {
  const clouds::MarchSettings& march = settings.march;
  u.march = glm::vec4(march.stepM, growthBegin(march), march.lightOpacity, march.transmittanceCutoff);
  u.strides = glm::vec4(clearAir.leastShape, clearAir.slopeM * march.clearStride,
                        clearAir.slopeM * march.sunClearStride, 0);
  u.sunSteps = glm::vec4(march.sunStepM, march.sunStepGrowth, march.sunStepPerDepthM, 0);
  u.exact = glm::vec4(march.maxSegmentOpticalDepth, 0, 0, 0);
  u.farField = glm::vec4(farBegin(march), march.farStep, march.farTolerance, clearAir.evenWear);
  // Of a tile in the middle of the picture; elsewhere it is seen under a smaller angle.
  const double halfDiagonal = 1.02 * std::sqrt(0.5) * tilePixels * view.pixelAngleRad();
  u.sight = glm::vec4(halfDiagonal, march.coarseTolerance, march.fineTolerance, 0);
}

}  // namespace skydrop::render
