#include "skydrop/render/frame/eye_adaptation.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace skydrop::render {
namespace {

constexpr double kFaintest = 1e-12, kBrightest = 1e12;  // klx: ratios of levels stay numbers
constexpr double kMostFactor = 4;
constexpr double kGlareAngleRad = 0.7;  // of the sun from the view's axis, where its glare begins
constexpr double kGlare = 1.5;          // of a clear sun on the axis, times the level

double luminance(const glm::dvec3& light) { return glm::dot(light, glm::dvec3(0.2126, 0.7152, 0.0722)); }

// How much of the view lies above the horizon, 0 to 1.
double skyShare(const View& view) {
  const double pitch = std::asin(std::clamp(view.forward().y, -1.0, 1.0));
  return std::clamp(0.5 + pitch / view.fovYRad, 0.0, 1.0);
}

double glareOf(const SkyLight& light, const View& view) {
  if (light.toSun.y <= 0) return 0;
  const double angle = std::acos(std::clamp(glm::dot(view.forward(), light.toSun), -1.0, 1.0));
  const double nearness = std::clamp(1 - angle / kGlareAngleRad, 0.0, 1.0);
  const double outside = luminance(light.sunOutside);
  const double clear = outside > 0 ? std::clamp(luminance(light.sun) / outside, 0.0, 1.0) : 0;
  return kGlare * nearness * nearness * clear * (1 - light.overcast.cover);
}

}  // namespace

double levelInView(const SkyLight& light, const View& view) {
  glm::dvec3 above = sky::meanHorizonRadiance(light) + light.night;
  if (light.moon) above += light.moon->illuminance / std::numbers::pi;
  const double sky = std::max(luminance(above), 0.0);
  const double land = std::max(luminance(light.ground), 0.0) / std::numbers::pi;
  const double even = 0.5 * (sky + land), share = skyShare(view);
  const double seen = share * sky + (1 - share) * land;
  const double factor = (even > 0 ? seen / even : 1) * (1 + glareOf(light, view));
  if (!std::isfinite(factor)) return light.level;
  return light.level * std::clamp(factor, 1 / kMostFactor, kMostFactor);
}

void EyeAdaptation::follow(double lightInView, double simulatedSeconds, double speed) {
  const double step = simulatedSeconds - seconds_;
  seconds_ = simulatedSeconds;
  if (!std::isfinite(lightInView) || lightInView <= 0) return;
  lightInView = std::clamp(lightInView, kFaintest, kBrightest);
  if (!level_ || !(step >= 0 && step <= kLongestStepS)) {
    level_ = lightInView;
    return;
  }
  const double timeConstant = lightInView > *level_ ? kToBrightnessS : kToDarknessS;
  const double left = std::exp(-step * std::max(speed, 1.0) / timeConstant);
  level_ = lightInView * std::pow(*level_ / lightInView, left);
}

}  // namespace skydrop::render
