#include "skydrop/game/flown_clouds.h"

#include <algorithm>
#include <array>

#include "skydrop/game/ice_layers.h"

namespace skydrop::game {
namespace {

// Density from which on a column counts as a full one: what the core of a cumulus of the default layer has.
constexpr double kFullColumn = 0.3;
constexpr int kIceSamples = 3;

// What of a layer's look follows from the genus.
struct GenusLook {
  double typeShift, scale, erosion;
  double threshold, cover;  // least density of the noise; coverage of the medium at a cover of 1
  double extinction;        // 1/m
  double higherScale, weatherScale;
  clouds::CloudForm form;
};

constexpr clouds::CloudLayerSettings kPlain;

// A sheet or a heap with a profile of its own.
clouds::CloudForm formOf(const glm::dvec4& profile, const glm::dvec3& stretch = glm::dvec3(1)) {
  clouds::CloudForm form;
  form.profile = profile;
  form.own = 1;
  form.stretch = stretch;
  return form;
}

// A thundercloud: walls that the map draws, noise that only roughens them, an anvil over the uppermost fifth.
clouds::CloudForm towerWithAnvil() {
  clouds::CloudForm form = formOf({0, 0.02, 0.92, 1}, {1, 0.8, 1});
  form.anvilBase = 0.85;
  form.spread = 1;  // of the map's reach, which is what spreads
  form.anvilThreshold = -0.6;
  form.taper = 0.1;
  form.contrast = 6;
  return form;
}

// Order of weather::Genus. Figures: docs/cloud-layers.md#genera.
const GenusLook& lookOf(weather::Genus genus) {
  static const std::array<GenusLook, 10> kLooks{
      {{0, 0.4, 0.15, 0, 2.5, 0.03, 20, 0.02, formOf({0, 0.3, 0.8, 1})},
       {0, 0.9, 0.3, 0.35, 1.4, 0.05, 20, 0.02, formOf({0, 0.25, 0.5, 1}, {0.5, 1, 1})},
       {kPlain.typeShift,
        kPlain.scale,
        kPlain.erosion,
        kPlain.densityThreshold,
        1,
        kPlain.extinction,
        kPlain.higherScale,
        kPlain.weatherScale,
        {}},
       {0, 0.25, 0.1, 0, 2.5, 0.003, 10, 0.02, formOf({0, 0.4, 0.7, 1}, {1, 0.5, 1})},
       {0, 2, 0.3, 0.42, 1.3, 0.03, 30, 0.02, formOf({0, 0.35, 0.5, 1}, {1, 0.5, 1})},
       {-0.8, 0.8, 0.6, kPlain.densityThreshold, 1, 0.002, 20, 0.02, {}},
       {-1, 0.2, 0.1, kPlain.densityThreshold, 1, 0.002, 20, 0.02, {}},
       {-0.4, 2, 0.3, kPlain.densityThreshold, 1, 0.002, 20, 0.02, {}},
       {0, 0.25, 0.15, 0, 2.5, 0.012, 20, 0.02, formOf({0, 0.12, 0.8, 1})},
       {0, 0.45, 0.28, -0.35, 0.52, 0.1, 12, 0.01, towerWithAnvil()}}};
  return kLooks[static_cast<std::size_t>(genus)];
}

void applyLook(clouds::CloudLayerSettings& s, const weather::LayerLook& look) {
  s.densityThreshold = std::clamp(s.densityThreshold + look.threshold, -0.95, 0.95);
  s.scale = std::clamp(s.scale * look.scale, 0.1, 4.0);
  s.anisotropy = std::clamp(s.anisotropy + look.anisotropy, -0.9, 0.95);
  s.extinction = std::clamp(s.extinction * look.extinction, 0.0, 1.0);
  s.higherScale = std::clamp(s.higherScale * look.higherScale, 2.0, 80.0);
  s.weatherScale = std::clamp(s.weatherScale * look.weatherScale, 0.005, 0.1);
  s.typeShift = std::clamp(s.typeShift + look.typeShift, -1.0, 1.0);
  s.erosion = std::clamp(s.erosion * look.erosion, 0.0, 0.9);
  s.forwardShare = std::clamp(s.forwardShare + look.forwardShare, 0.0, 1.0);
}

}  // namespace

bool isVolume(weather::Genus genus) {
  return genus != weather::Genus::cirrus && genus != weather::Genus::cirrostratus &&
         genus != weather::Genus::cirrocumulus;
}

weather::LayerLook lookOf(const clouds::CloudLayerSettings& s) {
  weather::LayerLook look;
  look.base = s.cloudHeight / kPlain.cloudHeight;
  look.thickness = s.thickness / kPlain.thickness;
  look.cover = s.coverage / kPlain.coverage;
  look.scale = s.scale / kPlain.scale;
  look.extinction = s.extinction / kPlain.extinction;
  look.higherScale = s.higherScale / kPlain.higherScale;
  look.weatherScale = s.weatherScale / kPlain.weatherScale;
  look.erosion = s.erosion / kPlain.erosion;
  look.threshold = s.densityThreshold - kPlain.densityThreshold;
  look.typeShift = s.typeShift - kPlain.typeShift;
  look.anisotropy = s.anisotropy - kPlain.anisotropy;
  look.forwardShare = s.forwardShare - kPlain.forwardShare;
  return look;
}

clouds::LayerMedium cloudLayerOf(const weather::Layer& layer) {
  clouds::LayerMedium out;
  const GenusLook& look = lookOf(layer.genus);
  out.form = look.form;
  out.layer.typeShift = look.typeShift;
  out.layer.scale = look.scale;
  out.layer.erosion = look.erosion;
  out.layer.densityThreshold = look.threshold;
  out.layer.higherScale = look.higherScale;
  out.layer.weatherScale = look.weatherScale;
  out.layer.cloudHeight = layer.baseM;
  out.layer.thickness = layer.topM - layer.baseM;
  out.layer.coverage = layer.cover * look.cover;
  out.layer.extinction = look.extinction * layer.density;
  applyLook(out.layer, layer.look);
  return out;
}

clouds::CloudField FlownClouds::fieldOf(const weather::Layer& layer, double seconds) const {
  clouds::CloudField field(noise_, cloudLayerOf(layer));
  field.setDrift(core::windDrift(drift_, seconds));
  return field;
}

double FlownClouds::density(const weather::Layer& layer, const glm::dvec3& position, double seconds) const {
  if (!(layer.cover > 0) || position.y <= layer.baseM || position.y >= layer.topM) return 0;
  if (const auto ice = iceLayerOf(layer, iceWind_))
    return std::min(clouds::IceField(*ice, core::windDrift(drift_, seconds)).density(position), 1.0);
  if (!noise_) return 0;
  return fieldOf(layer, seconds).density(position);
}

double FlownClouds::column(const weather::Layer& layer, const glm::dvec3& position, double seconds) const {
  if (!(layer.cover > 0)) return 0;
  if (const auto ice = iceLayerOf(layer, iceWind_)) {
    const clouds::IceField field(*ice, core::windDrift(drift_, seconds));
    return std::min(field.depthAbove({position.x, layer.baseM, position.z}, kIceSamples), 1.0);
  }
  if (!noise_) return 0;
  const clouds::CloudField field = fieldOf(layer, seconds);
  double densest = 0;
  for (const double share : {0.12, 0.25, 0.45}) {
    const double height = layer.baseM + share * (layer.topM - layer.baseM);
    densest = std::max(densest, field.density({position.x, height, position.z}));
  }
  return std::min(densest / kFullColumn, 1.0);
}

double FlownClouds::density(const weather::State& state, const glm::dvec3& position, double seconds) const {
  double sum = 0;
  for (const weather::Layer& layer : state.layers) sum += density(layer, position, seconds);
  return std::min(sum, 1.0);
}

}  // namespace skydrop::game
