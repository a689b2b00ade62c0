#include "skydrop/game/flown_clouds.h"

#include <algorithm>
#include <array>

#include "skydrop/game/ice_layers.h"

namespace skydrop::game {
namespace {

// Density from which on a column counts as a full one: what the core of a cumulus of the default layer has.
constexpr double kFullColumn = 0.3;
constexpr int kIceSamples = 3;

// What of a layer's look follows from the genus: towards stratus or cumulus, size of the billows, erosion.
struct GenusLook {
  double typeShift, scale, erosion;
};

GenusLook lookOf(weather::Genus genus) {
  static constexpr clouds::CloudLayerSettings kDefault;
  // Order of weather::Genus.
  static constexpr std::array<GenusLook, 10> kLooks{{{-1, 0.4, 0.1},
                                                     {-0.5, 0.595, 0.3},
                                                     {kDefault.typeShift, kDefault.scale, kDefault.erosion},
                                                     {-1, 0.3, 0.1},
                                                     {-0.4, 1.2, 0.3},
                                                     {-0.8, 0.8, 0.6},
                                                     {-1, 0.2, 0.1},
                                                     {-0.4, 2, 0.3},
                                                     {-1, 0.3, 0.05},
                                                     {1, 0.3, 0.3}}};
  return kLooks[static_cast<std::size_t>(genus)];
}

}  // namespace

clouds::CloudLayerSettings cloudLayerOf(const weather::Layer& layer) {
  clouds::CloudLayerSettings out;
  const GenusLook look = lookOf(layer.genus);
  out.typeShift = look.typeShift;
  out.scale = look.scale;
  out.erosion = look.erosion;
  out.cloudHeight = layer.baseM;
  out.thickness = layer.topM - layer.baseM;
  out.coverage = layer.cover;
  out.extinction *= layer.density;
  return out;
}

clouds::CloudField FlownClouds::fieldOf(const weather::Layer& layer, double seconds) const {
  clouds::CloudSettings settings;
  settings.layers[0] = cloudLayerOf(layer);
  clouds::CloudField field(noise_, settings);
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
