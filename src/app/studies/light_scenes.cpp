#include "app/studies/light_scenes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <map>

#include "app/session/noise_store.h"
#include "skydrop/clouds/noise_textures.h"
#include "skydrop/core/error.h"
#include "skydrop/core/hash.h"
#include "skydrop/game/flown_clouds.h"
#include "skydrop/weather/usual_layer.h"

namespace skydrop::app {
namespace {

constexpr double kReachM = 15000;    // of the rays: flat, nothing has faded yet
constexpr double kViewDegrees = 64;  // across
constexpr double kSunAzimuthDegrees = 25;

clouds::LayerMedium cumulus(double coverage) {
  clouds::LayerMedium medium;
  medium.layer.coverage = coverage;
  return medium;
}

clouds::LayerMedium genus(weather::Genus genus, double cover) {
  weather::Layer layer = weather::usualLayer(genus);
  layer.cover = cover;
  return game::cloudLayerOf(layer);
}

clouds::LayerMedium droplets(clouds::LayerMedium medium) {
  medium.layer.forwardShare = 1;  // all in the forward lobe, g .85
  return medium;
}

std::vector<LightScene> makeScenes() {
  using weather::Genus;
  return {
      {"cumulus-40", 0, cumulus(0.5), 40, {0, 0}, true},
      {"cumulus-10", 0, cumulus(0.5), 10, {0, 0}, true},
      {"other-seed-20", 1, cumulus(0.5), 20, {0, 0}, false},
      {"elsewhere-60", 0, cumulus(0.7), 60, {17000, 9000}, false},
      {"stratocumulus-30", 1, genus(Genus::stratocumulus, 0.7), 30, {4000, 0}, false},
      {"overcast-40", 0, genus(Genus::stratus, 1), 40, {0, 5000}, false},
      {"droplets-40", 0, droplets(cumulus(0.5)), 40, {0, 0}, false},
  };
}

std::vector<clouds::MarchRay> picture(const glm::dvec3& eye, double azimuthDegrees, double pitchDegrees,
                                      int width, int height) {
  const double azimuth = glm::radians(azimuthDegrees), pitch = glm::radians(pitchDegrees);
  const glm::dvec3 forward(std::cos(pitch) * std::cos(azimuth), std::sin(pitch),
                           std::cos(pitch) * std::sin(azimuth));
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0))),
                   up = glm::cross(right, forward);
  const double half = std::tan(glm::radians(kViewDegrees / 2));
  std::vector<clouds::MarchRay> rays;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double across = (2 * (x + 0.5) / width - 1) * half,
                   upwards = (1 - 2 * (y + 0.5) / height) * half * height / width;
      rays.push_back({eye, glm::normalize(forward + across * right + upwards * up), 0, kReachM});
    }
  }
  return rays;
}

}  // namespace

glm::dvec3 LightScene::toSun() const {
  const double elevation = glm::radians(sunElevationDegrees), azimuth = glm::radians(kSunAzimuthDegrees);
  return {std::cos(elevation) * std::cos(azimuth), std::sin(elevation),
          std::cos(elevation) * std::sin(azimuth)};
}

double LightScene::sunAzimuthDegrees() const { return kSunAzimuthDegrees + 90; }  // theirs is from +x

std::uint64_t LightScene::digest() const {
  core::StateHasher hash;
  hash.add(std::uint64_t{noiseSeed});
  const clouds::CloudLayerSettings& s = medium.layer;
  const clouds::CloudForm& form = medium.form;
  for (const double value :
       {s.densityThreshold,  s.scale,        s.anisotropy,   s.extinction,   s.higherScale,
        s.weatherScale,      s.cloudHeight,  s.thickness,    s.coverage,     s.typeShift,
        s.erosion,           s.forwardShare, form.profile.x, form.profile.y, form.profile.z,
        form.profile.w,      form.own,       form.anvilBase, form.spread,    form.anvilThreshold,
        form.taper,          form.contrast,  form.stretch.x, form.stretch.y, form.stretch.z,
        sunElevationDegrees, place.x,        place.y}) {
    hash.add(value);
  }
  for (const LightView& view : lightViews(*this)) {
    for (const clouds::MarchRay& ray : view.rays) {
      // To a thousandth: roots and sines differ in their last bit between libraries.
      for (int axis = 0; axis < 3; ++axis) {
        hash.add(std::round(ray.origin[axis]));
        hash.add(std::round(ray.direction[axis] * 1e3) + 0.0);
      }
    }
  }
  return hash.value();
}

const std::vector<LightScene>& lightScenes() {
  static const std::vector<LightScene> scenes = makeScenes();
  return scenes;
}

const LightScene& lightScene(std::string_view name) {
  std::string names;
  for (const LightScene& scene : lightScenes()) {
    if (scene.name == name) return scene;
    names += (names.empty() ? "" : ", ") + scene.name;
  }
  throw core::RangeError("there is no judged scene '" + std::string(name) + "': " + names);
}

std::vector<LightView> lightViews(const LightScene& scene, int width, int height) {
  const clouds::CloudLayerSettings& layer = scene.medium.layer;
  const auto at = [&](double heightM) { return glm::dvec3(scene.place.x, heightM, scene.place.y); };
  const glm::dvec3 below = at(layer.cloudHeight - 900), above = at(layer.cloudHeight + layer.thickness + 300),
                   within = at(layer.cloudHeight + 0.45 * layer.thickness);
  const double sun = kSunAzimuthDegrees;
  const auto from = [&](const glm::dvec3& eye, double azimuth, double pitch) {
    return picture(eye, azimuth, pitch, width, height);
  };
  return {{"below, against the sun", from(below, sun, 32)},
          {"below, the sun behind", from(below, sun + 180, 32)},
          {"below, across", from(below, sun + 90, 30)},
          {"within, across", from(within, sun - 100, 2)},
          {"above, against the sun", from(above, sun + 10, -18)},
          {"above, the sun behind", from(above, sun + 170, -22)}};
}

std::shared_ptr<const clouds::PackedCloudNoise> lightNoise(std::uint32_t seed) {
  const NoiseStore store(cacheFolder());
  const auto texture = [&](clouds::NoiseTexture of) { return store.get(of, seed).texture; };
  return std::make_shared<const clouds::PackedCloudNoise>(
      clouds::packCloudNoise(texture(clouds::NoiseTexture::shape), texture(clouds::NoiseTexture::detail),
                             texture(clouds::NoiseTexture::weather)));
}

JudgedLight judge(const LightScene& scene, int paths, core::JobPool* pool,
                  const std::function<void(std::string_view)>& progress) {
  const clouds::CloudField field(lightNoise(scene.noiseSeed), scene.medium);
  const clouds::TracedMedium medium = clouds::tracedMediumOf(field);
  const clouds::TracedPhase phase = clouds::tracedPhaseOf(scene.medium.layer);
  JudgedLight judged{paths, {}};
  for (const LightView& view : lightViews(scene)) {
    progress(view.name);
    judged.views.push_back(clouds::traceRays(medium, phase, scene.toSun(), view.rays, paths,
                                             core::hashCombine(1, judged.views.size()), pool));
  }
  return judged;
}

}  // namespace skydrop::app
