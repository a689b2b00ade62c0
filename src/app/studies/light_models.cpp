#include "app/studies/light_models.h"

#include "skydrop/core/shared.h"

namespace skydrop::app {

namespace f64 = core::shared::f64;

clouds::MarchSteps stepsFor(double sunElevationDegrees) {
  constexpr double kLowDegrees = 15;
  return {256, sunElevationDegrees < kLowDegrees ? 128 : 32};
}

clouds::ScatteredLight litByVolume(const clouds::LightVolume& volume,
                                   const clouds::CloudLayerSettings& layer) {
  return [&volume, &layer, rowM = layer.thickness / clouds::LightVolume::kRows](const clouds::LitPlace& at) {
    const clouds::LightVolume::Texel texel = volume.at(at.place);
    return glm::dvec3(
        f64::scatteredSunOfVolume(f64::volumePhases(at.sunCosine, layer.anisotropy, layer.forwardShare),
                                  at.sunDepth, static_cast<double>(texel.sun), at.extinction, rowM),
        texel.sky, texel.ground());
  };
}

}  // namespace skydrop::app
