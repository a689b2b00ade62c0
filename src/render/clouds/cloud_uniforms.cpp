#include "render/clouds/cloud_uniforms.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

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

void addLight(CloudUniforms& u, const clouds::CloudLayerSettings& layer, const SkyLight& light) {
  u.toSun = packed(clouds::raisedSun(light.direct.toSun), 0);
  const double middle = layer.cloudHeight + 0.5 * layer.thickness;
  u.sunLight = packed(sky::sunIlluminance(light.direct, middle) * light.exposure, 0);
  u.skyLight = packed(light.sky * light.exposure, 0);
  u.groundLight = packed(light.ground * light.exposure, 0);
}

void addIceShade(CloudUniforms& u, const clouds::CloudLayerSettings& layer, const IceShade& ice,
                 const glm::dvec3& eye) {
  const double middle = layer.cloudHeight + 0.5 * layer.thickness;
  const LightShares shares = ice.below({eye.x, middle, eye.z});
  u.sunLight *= glm::vec4(glm::vec3(static_cast<float>(shares.sun)), 1);
  u.skyLight *= glm::vec4(glm::vec3(static_cast<float>(shares.sky)), 1);
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
