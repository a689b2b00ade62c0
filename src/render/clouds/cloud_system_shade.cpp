// What clouds throw onto land, air and what flies: the shadow maps, and the light at places.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/clouds/cloud_textures.h"
#include "render/clouds/cloud_uniforms.h"
#include "render/clouds/sun_optical_depth_grid.h"
#include "render/clouds/weather_layers.h"
#include "skydrop/clouds/raised_sun.h"
#include "skydrop/clouds/sun_depth.h"
#include "skydrop/core/shared.h"
#include "skydrop/core/shared_clouds.h"
#include "skydrop/game/snapshot.h"
#include "skydrop/render/clouds/cloud_system.h"

namespace skydrop::render {
namespace {

constexpr double kFineShadowMapM = 60, kFineShadowRadiusM = 6000, kCoarseShadowMapM = 240,
                 kCoarseShadowRadiusM = 24000;  // cells of shadows, how far they reach

// Samples along a sun ray through a layer of the weather, fine and coarse map.
constexpr double kFineSampleM = 90, kCoarseSampleM = 180;

// What shadow maps are made of: rounded, so that they are not filled in every frame of a weather that
// changes.
clouds::LayerMedium inShadowMap(const clouds::LayerMedium& medium) {
  constexpr double kCoverages = 128, kHeightM = 10, kExtinctions = 8;  // an octave
  const auto rounded = [](double value, double step) { return std::round(value / step) * step; };
  clouds::LayerMedium out = medium;
  clouds::CloudLayerSettings& s = out.layer;
  s.coverage = rounded(s.coverage, 1 / kCoverages);
  const double top = rounded(s.cloudHeight + s.thickness, kHeightM);
  s.cloudHeight = rounded(s.cloudHeight, kHeightM);
  s.thickness = std::max(top - s.cloudHeight, kHeightM);
  if (s.extinction > 0) s.extinction = std::exp2(rounded(std::log2(s.extinction), 1 / kExtinctions));
  return out;
}

// Below clouds of an optical depth towards the sun that leave so much of sun and sky. reach: [0, 1], how much
// of that counts.
LightShares sharesBelow(double depth, double sun, double sky, double reach) {
  const double straight = core::shared::f64::sunStraightThroughCloud(depth);
  return {std::lerp(1.0, straight, reach), std::lerp(1.0, sky, reach), std::max(sun - straight, 0.0) * reach};
}

}  // namespace

void CloudSystem::forgetShadowMap() {
  fineShadowMap_ = std::make_unique<SunOpticalDepthGrid>("fine cloud shadow map");
  coarseShadowMap_ = std::make_unique<SunOpticalDepthGrid>("coarse cloud shadow map");
}

void CloudSystem::update(FrameContext& context, SunOpticalDepthGrid& grid, double cellM, double radiusM,
                         const glm::dvec3& middle) {
  grid.update(context_, context.shaders,
              sunOpticalDepthGridLayout(layer(), clouds::raisedSun(context.light.direct.toSun), cellM,
                                        std::min(radiusM, settings_.fadeDistance), middle),
              layer(), settings_, textures_->meanDetail());
}

std::optional<std::string> CloudSystem::shadowSkipReason(const FrameInput& frame) const {
  if (settings_.tier == clouds::CloudTier::off) return "switched off";
  if (drawsWeather(frame)) {
    const std::vector<DrawnLayer> layers =
        WeatherLayers::mediaOf(frame.game->weather, {frame.view.position.x, frame.view.position.z});
    if (std::ranges::none_of(layers, &DrawnLayer::isThere)) return "no cloud anywhere";
    if (frame.view.position.y > hullOf(layers).cloudHeight + settings_.fadeDistance)
      return "the eye is too far above";
    return std::nullopt;
  }
  if (textures_->isEmpty(kMarchedLayer)) return "no cloud anywhere";
  if (frame.view.position.y > layer().cloudHeight + settings_.fadeDistance) return "the eye is too far above";
  return std::nullopt;
}

CloudShadowMap CloudSystem::shadowMapOfLayers(FrameContext& context) {
  std::vector<DrawnLayer> layers = weather_->layers();
  std::vector<clouds::LayerMedium> media;
  for (DrawnLayer& layer : layers) {
    layer.medium = inShadowMap(layer.medium);
    media.push_back(layer.isThere ? layer.medium : clouds::LayerMedium{});
  }
  if (media != shadowLayers_) {
    shadowLayers_ = std::move(media);
    fineShadowMap_->forget();
    coarseShadowMap_->forget();
  }
  const glm::dvec3 eye = eyeInField(context.frame);
  const clouds::CloudLayerSettings hull = hullOf(layers);
  CloudShadowMap::Layers channels;
  channels.count = static_cast<int>(layers.size());
  channels.overcast = glm::vec2(overcastOf(layers), clouds::raisedSun(context.light.direct.toSun).y);
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const clouds::CloudLayerSettings& s = layers[i].medium.layer;
    const int channel = static_cast<int>(i);
    channels.bases[channel] = static_cast<float>(s.cloudHeight - context.frame.view.position.y);
    channels.inverseThicknesses[channel] = static_cast<float>(1 / s.thickness);
    const double period = weatherPeriod(layers[i].medium);
    const glm::dvec2 periods = glm::dvec2(eye.x, eye.z) / period;
    channels.skyPlaces[i] =
        glm::vec4(glm::vec2(periods - glm::floor(periods)), static_cast<float>(1 / period),
                  static_cast<float>(settings_.fadeDistance));
  }
  const CloudShadowMap::Sky sky{&weather_->skyShares(), glm::vec4(0)};
  const glm::dvec2 baseAndThickness(hull.cloudHeight - context.frame.view.position.y,
                                    std::max(hull.thickness, 1.0));
  CloudShadowMap shadows(sky, baseAndThickness);
  if (context.frame.toSun.y > 0) {
    textures_->bind(kMarchedLayer);
    const glm::dvec3 toSun = clouds::raisedSun(context.light.direct.toSun);
    const glm::dvec3 middle = eye + glm::dvec3(toSun.x, 0, toSun.z) * (hull.cloudHeight / toSun.y);
    const auto map = [&](SunOpticalDepthGrid& grid, double cellM, double radiusM, double sampleM) {
      const double reach = std::min(radiusM, settings_.fadeDistance);
      grid.update(context_, context.shaders, sunOpticalDepthGridLayout(hull, toSun, cellM, reach, middle),
                  layers, settings_, textures_->meanDetail(), sampleM);
      const std::array<glm::vec4, 3> rows = toSunOpticalDepthGrid(grid.layout(), eye);
      return CloudShadowMap::Map{&grid.depths(), {rows[0], rows[1]}, reach};
    };
    const CloudShadowMap::Map fine = map(*fineShadowMap_, kFineShadowMapM, kFineShadowRadiusM, kFineSampleM);
    shadows = CloudShadowMap(sky, baseAndThickness, fine,
                             map(*coarseShadowMap_, kCoarseShadowMapM, kCoarseShadowRadiusM, kCoarseSampleM));
  }
  shadows.setLayers(channels);
  return shadows;
}

CloudShadowMap CloudSystem::shadowMap(FrameContext& context) {
  prepare(context.frame);
  if (weather_) return shadowMapOfLayers(context);
  if (!shadowLayers_.empty()) {
    shadowLayers_.clear();
    fineShadowMap_->forget();
    coarseShadowMap_->forget();
  }
  const glm::dvec3 eye = eyeInField(context.frame);
  const clouds::SkyCover& skyCover = textures_->skyCover(kMarchedLayer);
  const glm::dvec2 periods = glm::dvec2(eye.x, eye.z) / skyCover.periodM();
  CloudShadowMap::Sky sky{
      &textures_->skyShares(kMarchedLayer),
      glm::vec4(glm::vec2(periods - glm::floor(periods)), static_cast<float>(1 / skyCover.periodM()),
                static_cast<float>(settings_.fadeDistance))};
  const glm::dvec2 baseAndThickness(layer().cloudHeight - context.frame.view.position.y, layer().thickness);
  if (context.frame.toSun.y <= 0) return CloudShadowMap(sky, baseAndThickness);
  textures_->bind(kMarchedLayer);
  // What shades the land around the eye stands where the sun's rays to that land pass the base.
  const glm::dvec3 toSun = clouds::raisedSun(context.light.direct.toSun);
  const glm::dvec3 middle = eye + glm::dvec3(toSun.x, 0, toSun.z) * (layer().cloudHeight / toSun.y);
  const auto map = [&](SunOpticalDepthGrid& grid, double cellM, double radiusM) {
    const double reach = std::min(radiusM, settings_.fadeDistance);
    update(context, grid, cellM, reach, middle);
    const std::array<glm::vec4, 3> rows = toSunOpticalDepthGrid(grid.layout(), eye);
    return CloudShadowMap::Map{&grid.depths(), {rows[0], rows[1]}, reach};
  };
  const CloudShadowMap::Map fine = map(*fineShadowMap_, kFineShadowMapM, kFineShadowRadiusM);
  return CloudShadowMap(sky, baseAndThickness, fine,
                        map(*coarseShadowMap_, kCoarseShadowMapM, kCoarseShadowRadiusM));
}

Overcast CloudSystem::overcast(const FrameInput& frame) {
  if (settings_.tier == clouds::CloudTier::off || !drawsWeather(frame)) return {};
  prepare(frame);
  Overcast overcast;
  double open = 1;
  for (const DrawnLayer& drawn : weather_->layers()) {
    if (!drawn.isThere) continue;
    const clouds::CloudLayerSettings& s = drawn.medium.layer;
    const double above = 1 - std::clamp((frame.view.position.y - s.cloudHeight) / s.thickness, 0.0, 1.0);
    const double cover = drawn.cover * above;
    open *= 1 - cover * cover * cover;
    overcast.left *= 1 - (1 - drawn.skyMean) * above;
    if (above > 0) overcast.baseM = std::min(overcast.baseM, s.cloudHeight);
  }
  overcast.cover = 1 - open;
  return overcast;
}

LightShares CloudSystem::lightAt(const glm::dvec3& place, const FrameInput& frame) const {
  const double distance = glm::distance(place, frame.view.position);
  const double reach = core::shared::f64::cloudFade(distance, settings_.fadeDistance);
  if (reach <= 0) return {};
  const glm::dvec3 at = inField(place, frame);
  if (weather_) {
    double depth = 0, sky = 1;
    for (std::size_t i = 0; i < weather_->layers().size(); ++i) {
      const DrawnLayer& drawn = weather_->layers()[i];
      if (!drawn.isThere) continue;
      const clouds::CloudLayerSettings& s = drawn.medium.layer;
      depth += clouds::sunOpticalDepth(weather_->field(i), at, clouds::raisedSun(frame.toSun));
      const double above = 1 - std::clamp((at.y - s.cloudHeight) / s.thickness, 0.0, 1.0);
      sky *= 1 - (1 - drawn.skyShare({at.x, at.z})) * above;
    }
    const double sun = core::shared::f64::sunBelowLayers(depth, clouds::raisedSun(frame.toSun).y,
                                                         overcastOf(weather_->layers()));
    return sharesBelow(depth, sun, sky, reach);
  }
  const double depth =
      clouds::sunOpticalDepth(textures_->field(kMarchedLayer), at, clouds::raisedSun(frame.toSun));
  const double above = 1 - std::clamp((at.y - layer().cloudHeight) / layer().thickness, 0.0, 1.0);
  const double sky = 1 - (1 - textures_->skyCover(kMarchedLayer).share({at.x, at.z})) * above;
  return sharesBelow(depth, core::shared::f64::sunBelowCloud(depth), sky, reach);
}

}  // namespace skydrop::render
