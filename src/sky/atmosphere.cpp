#include "skydrop/sky/atmosphere.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

namespace skydrop::sky {
namespace {

namespace shared = core::shared::f64;

// Of the angle between the azimuths of two directions; 0 where one is vertical.
double cosAzimuthBetween(const glm::dvec3& a, const glm::dvec3& b) {
  const double lengths = std::sqrt((a.x * a.x + a.z * a.z) * (b.x * b.x + b.z * b.z));
  return lengths > 1e-12 ? std::clamp((a.x * b.x + a.z * b.z) / lengths, -1.0, 1.0) : 0;
}

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

// The program's light of what the shell's tables hold, even and under the haze's phase function.
glm::dvec3 shellRadiance(const SkyLight& light, const glm::dvec3& direction, const glm::dvec3& even,
                         const glm::dvec3& haze) {
  const double phase = shared::henyeyGreenstein(glm::dot(direction, light.toSun), light.air.hazeAnisotropy);
  return (even + haze * phase) * light.sunOutside + light.night;
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

SkyLight skyLight(const Atmosphere& air, const glm::dvec3& toSun, double heightM, SkyModel model,
                  const SkyViews::Place* tables) {
  SkyLight light;
  light.toSun = toSun;
  light.heightM = heightM;
  light.air = air;
  light.sunOutside = shared::kSunIlluminance;
  light.night = shared::kNightRadiance;
  if (model == SkyModel::shell) {
    light.views = SkyViews::of(air);
    light.view = light.views->view(tables ? *tables : SkyViews::Place{heightM, toSun.y});
  }
  light.sun = sunIlluminance(light, heightM);
  light.column = shared::make_skyColumn(air, heightM, toSun.y);
  light.horizon = shared::skySource(light.column, air, 0);
  light.sky = skyIlluminance(light);
  light.ground = (light.sun * std::max(toSun.y, 0.0) + light.sky) * shared::kGroundAlbedo;
  return light;
}

glm::dvec3 skyRadiance(const SkyLight& light, const glm::dvec3& direction) {
  if (light.isShell()) {
    const double azimuth = cosAzimuthBetween(direction, light.toSun);
    return shellRadiance(light, direction, light.view->at(SkyLayer::skyEven, direction.y, azimuth),
                         light.view->at(SkyLayer::skyHaze, direction.y, azimuth));
  }
  const SkySource source = shared::skySource(light.column, light.air, direction.y);
  return shared::skyRadiance(source, glm::dot(direction, light.toSun), light.air.hazeAnisotropy) *
             light.sunOutside +
         light.night;
}

glm::dvec3 airRadiance(const SkyLight& light, const glm::dvec3& direction, double distanceM) {
  if (light.isShell()) {
    const double azimuth = cosAzimuthBetween(direction, light.toSun);
    return shellRadiance(light, direction,
                         light.view->upTo(SkyLayer::airEven, direction.y, azimuth, distanceM),
                         light.view->upTo(SkyLayer::airHaze, direction.y, azimuth, distanceM));
  }
  return shared::skyRadiance(light.horizon, glm::dot(direction, light.toSun), light.air.hazeAnisotropy) *
             light.sunOutside +
         light.night;
}

glm::dvec3 meanHorizonRadiance(const SkyLight& light) {
  if (light.isShell()) {
    constexpr int kSectors = 24;
    glm::dvec3 sum(0);
    for (int i = 0; i < kSectors; ++i) {
      const double azimuth = 2 * std::numbers::pi * (i + 0.5) / kSectors;
      sum += skyRadiance(light, {std::cos(azimuth), 0, std::sin(azimuth)}) - light.night;
    }
    return sum / static_cast<double>(kSectors);
  }
  const glm::dvec3 horizon =
      (light.horizon.rayleigh + light.horizon.haze) / (4 * std::numbers::pi) + light.horizon.isotropic;
  return horizon * light.sunOutside;
}

glm::dvec3 sunDiscRadiance(const SkyLight& light) {
  const double solidAngle = std::numbers::pi * kSunRadiusRad * kSunRadiusRad;
  if (!light.isShell()) return light.sun / solidAngle;
  // The horizon cuts what it hides where the disc is drawn.
  const AirTables::Level level = light.views->tables().at(static_cast<float>(light.heightM));
  return light.sunOutside * glm::dvec3(level.transmittance(static_cast<float>(light.toSun.y))) / solidAngle;
}

glm::dvec3 sunIlluminance(const SkyLight& light, double heightM) {
  if (!light.isShell())
    return shared::sunIlluminanceAt(light.air, heightM, light.toSun.y) *
           (light.sunOutside / shared::kSunIlluminance);
  const AirTables::Level level = light.views->tables().at(static_cast<float>(heightM));
  const auto cosine = static_cast<float>(light.toSun.y);
  return light.sunOutside * glm::dvec3(level.transmittance(cosine)) *
         shared::sunVisibleShareAt(heightM, light.toSun.y);
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
  return radiance * kept + airRadiance(light, relative / std::max(distance, 1e-6), distance) * (1.0 - kept);
}

}  // namespace skydrop::sky
