#include "skydrop/sky/atmosphere.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

namespace skydrop::sky {
namespace {

namespace shared = core::shared::f64;

// Illuminance on a horizontal surface by the sky: a sum over the hemisphere, rings of equal projected solid
// angle.
glm::dvec3 skyIlluminance(const SkyLight& light) {
  constexpr int kRings = 8, kSectors = 12;
  glm::dvec3 sum(0);
  for (int ring = 0; ring < kRings; ++ring) {
    const double sine = std::sqrt((ring + 0.5) / kRings), cosine = std::sqrt(1 - sine * sine);
    for (int sector = 0; sector < kSectors; ++sector) {
      const double angle = 2 * std::numbers::pi * (sector + 0.5) / kSectors;
      sum += skyRadiance(light, {sine * std::cos(angle), cosine, sine * std::sin(angle)});
    }
  }
  return sum * (std::numbers::pi / (kRings * kSectors));
}

}  // namespace

glm::dvec3 directionToSun(double elevationDegrees, double azimuthDegrees) {
  const double elevation = glm::radians(elevationDegrees), azimuth = glm::radians(azimuthDegrees);
  return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
          -std::cos(azimuth) * std::cos(elevation)};
}

Atmosphere makeAtmosphere(double visibilityM, double hazeHeightM, double hazeAnisotropy) {
  return shared::make_atmosphere(visibilityM, hazeHeightM, hazeAnisotropy);
}

SkyLight skyLight(const Atmosphere& air, const glm::dvec3& toSun, double heightM) {
  SkyLight light;
  light.toSun = toSun;
  light.air = air;
  light.sunOutside = shared::kSunIlluminance;
  light.night = shared::kNightRadiance;
  light.sun = sunIlluminance(light, heightM);
  light.column = shared::make_skyColumn(air, heightM, toSun.y);
  light.sky = skyIlluminance(light);
  light.horizon = shared::skySource(light.column, air, 0);
  light.ground = (light.sun * std::max(toSun.y, 0.0) + light.sky) * shared::kGroundAlbedo;
  return light;
}

glm::dvec3 skyRadiance(const SkyLight& light, const glm::dvec3& direction) {
  const SkySource source = shared::skySource(light.column, light.air, direction.y);
  return shared::skyRadiance(source, glm::dot(direction, light.toSun), light.air.hazeAnisotropy) *
             light.sunOutside +
         light.night;
}

glm::dvec3 horizonRadiance(const SkyLight& light, double cosSunAngle) {
  return shared::skyRadiance(light.horizon, cosSunAngle, light.air.hazeAnisotropy) * light.sunOutside +
         light.night;
}

glm::dvec3 meanHorizonRadiance(const SkyLight& light) {
  const glm::dvec3 horizon =
      (light.horizon.rayleigh + light.horizon.haze) / (4 * std::numbers::pi) + light.horizon.isotropic;
  return horizon * light.sunOutside;
}

glm::dvec3 sunDiscRadiance(const SkyLight& light) {
  return light.sun / (std::numbers::pi * kSunRadiusRad * kSunRadiusRad);
}

glm::dvec3 sunIlluminance(const SkyLight& light, double heightM) {
  return shared::sunIlluminanceAt(light.air, heightM, light.toSun.y);
}

glm::dvec3 opticalDepth(const Atmosphere& air, double fromHeightM, double toHeightM, double lengthM) {
  return shared::opticalDepthBetween(air, fromHeightM, toHeightM, lengthM);
}

glm::dvec3 transmittance(const Atmosphere& air, double fromHeightM, double toHeightM, double lengthM) {
  return shared::transmittanceBetween(air, fromHeightM, toHeightM, lengthM);
}

glm::dvec3 applyAerialPerspective(const SkyLight& light, const glm::dvec3& radiance, double eyeHeightM,
                                  const glm::dvec3& relative) {
  const double distance = glm::length(relative);
  const glm::dvec3 kept = transmittance(light.air, eyeHeightM, eyeHeightM + relative.y, distance);
  const double cosine = glm::dot(relative, light.toSun) / std::max(distance, 1e-6);
  return radiance * kept + horizonRadiance(light, cosine) * (1.0 - kept);
}

}  // namespace skydrop::sky
