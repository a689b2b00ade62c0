// The clouds of the weather's layers as a medium that can be asked at a point: what flies asks it, and what
// draws them makes its layers with the same function. A value; const functions may run on any thread.
#pragma once

#include <glm/vec3.hpp>
#include <memory>

#include "skydrop/clouds/cloud_field.h"
#include "skydrop/clouds/layer_medium.h"
#include "skydrop/core/wind.h"
#include "skydrop/weather/state.h"

namespace skydrop::game {

// The medium of a layer, for flight and picture: a cumulus between the default base and top at cover .5 is
// the default layer of clouds.layers.0; of the other genera docs/cloud-layers.md has a table. Density scales
// the extinction, not the field. What the layer's look makes of it is kept within the ranges of
// clouds::CloudLayerSettings.
clouds::LayerMedium cloudLayerOf(const weather::Layer& layer);

// What settings of a layer, by how they depart from their defaults, make of the look of a weather's low one:
// at defaults nothing. By ratio, and by difference what may be 0 in a genus (threshold, type's shift) or has
// a sign (mean cosine, forward share).
weather::LayerLook lookOf(const clouds::CloudLayerSettings& settings);

// Whether clouds of a genus are drawn as volumes: all but the high ones of ice, which are thin sheets.
bool isVolume(weather::Genus genus);

class FlownClouds {
 public:
  // Without noise (null) there is no cloud of water anywhere. The clouds drift with the wind that draws them;
  // ice trails in a wind of its own (iceWindOf(), ice_layers.h).
  FlownClouds(std::shared_ptr<const clouds::PackedCloudNoise> noise, const core::WindSettings& drift,
              const weather::Wind& iceWind = {})
      : noise_(std::move(noise)), drift_(drift), iceWind_(iceWind) {}

  // Density of one layer at a place and time (simulated seconds), [0, 1]; 0 where it has no cover.
  double density(const weather::Layer& layer, const glm::dvec3& position, double seconds) const;
  // How much of it stands above or below the place, [0, 1]: of the densest of three heights in its lower
  // half; of ice, by its optical depth.
  double column(const weather::Layer& layer, const glm::dvec3& position, double seconds) const;
  // Of all layers together, [0, 1].
  double density(const weather::State& state, const glm::dvec3& position, double seconds) const;

 private:
  clouds::CloudField fieldOf(const weather::Layer& layer, double seconds) const;

  std::shared_ptr<const clouds::PackedCloudNoise> noise_;
  core::WindSettings drift_;
  weather::Wind iceWind_;
};

}  // namespace skydrop::game
