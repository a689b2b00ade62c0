#include "app/studies/light_pictures.h"

#include <cmath>
#include <cstdint>
#include <glm/gtc/constants.hpp>
#include <memory>
#include <vector>

#include "app/studies/light_models.h"
#include "skydrop/clouds/sky_cover.h"
#include "skydrop/core/hash.h"
#include "skydrop/core/shared.h"
#include "skydrop/render/frame/sky_light.h"

namespace skydrop::app {
namespace {

namespace f64 = core::shared::f64;

// What the sources send, as the game's shaders are given it, and what is behind the clouds. No air is
// between.
struct Scenery {
  render::SkyLight light;
  glm::dvec3 sun, sky, ground;  // illuminance, klx

  Scenery(const LightScene& scene, double groundShare, double eyeHeightM) {
    render::RenderSettings settings;
    settings.sun.elevationDegrees = scene.sunElevationDegrees;
    settings.sun.azimuthDegrees = scene.sunAzimuthDegrees();
    light = render::skyLight(settings, eyeHeightM);
    const clouds::CloudLayerSettings& layer = scene.medium.layer;
    sun = sky::sunIlluminance(light, layer.cloudHeight + 0.5 * layer.thickness);
    sky = light.sky;
    ground = light.ground * groundShare;
  }

  glm::dvec3 behind(const glm::dvec3& direction) const {
    return direction.y > 0 ? sky::skyRadiance(light, direction) : ground / glm::pi<double>();
  }
  // Of a march or of traced paths.
  template <class Light>
  glm::dvec3 seen(const Light& gathered, const glm::dvec3& direction) const {
    return (sun * gathered.sun + sky * gathered.sky + ground * gathered.ground +
            behind(direction) * gathered.transmittance) *
           light.exposure;
  }
};

void setPixel(core::Image& image, int x, int y, const glm::dvec3& light) {
  const f64::Vec3 shown = f64::srgbEncode(f64::toneMap({light.x, light.y, light.z}));
  std::uint8_t* pixel = image.pixel(x, y);
  for (int c = 0; c < 3; ++c) pixel[c] = static_cast<std::uint8_t>(std::lround(255 * shown[c]));
  pixel[3] = 255;
}

}  // namespace

core::Image lightPictures(const LightScene& scene, Size each, int paths, core::JobPool* pool,
                          const std::function<void(std::string_view)>& progress) {
  const std::shared_ptr<const clouds::PackedCloudNoise> noise = lightNoise(scene.noiseSeed);
  const clouds::CloudField field(noise, scene.medium);
  clouds::MarchMedium medium = clouds::mediumOf(field);
  medium.isShell = false;  // as the judge has it
  const clouds::LightVolume volume(field, scene.toSun());
  const clouds::CloudLayerSettings& layer = scene.medium.layer;
  const clouds::MarchLight light{scene.toSun(), layer.anisotropy, layer.forwardShare};
  const clouds::MarchSteps steps = stepsFor(scene.sunElevationDegrees);
  const clouds::ScatteredLight byVolume = litByVolume(volume, layer);
  const clouds::TracedMedium tracedMedium = clouds::tracedMediumOf(field);
  const clouds::TracedPhase phase = clouds::tracedPhaseOf(layer);
  const double groundShare = clouds::SkyCover(noise, scene.medium).meanShare();

  const std::vector<LightView> views = lightViews(scene, each.width, each.height);
  core::Image image(3 * each.width, static_cast<int>(views.size()) * each.height);
  for (std::size_t v = 0; v < views.size(); ++v) {
    progress(views[v].name);
    const std::vector<clouds::MarchRay>& rays = views[v].rays;
    const Scenery scenery(scene, groundShare, rays.front().origin.y);
    const std::vector<clouds::TracedPixel> traced =
        clouds::traceRays(tracedMedium, phase, scene.toSun(), rays, paths, core::hashCombine(1, v), pool);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const int x = static_cast<int>(i) % each.width,
                y = static_cast<int>(i) / each.width + static_cast<int>(v) * each.height;
      const auto show = [&](int column, const auto& gathered) {
        setPixel(image, column * each.width + x, y, scenery.seen(gathered, rays[i].direction));
      };
      show(0, clouds::referenceMarch(medium, light, rays[i], steps));
      show(1, traced[i].mean);
      show(2, clouds::referenceMarch(medium, light, rays[i], steps, byVolume));
    }
  }
  return image;
}

}  // namespace skydrop::app
