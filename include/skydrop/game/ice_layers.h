// The weather's layers of ice as a medium: what flies asks it, and what draws them draws the same.
#pragma once

#include <optional>
#include <vector>

#include "skydrop/clouds/ice_clouds.h"
#include "skydrop/weather/moment.h"

namespace skydrop::game {

// The wind whose shear forms the strands: that of the first site, without its wander, or of the first hour
// of a forecast (weather::strandWind). Strands that turned with a wandering wind would sweep over the sky,
// the faster the farther from the origin.
weather::Wind iceWindOf(const weather::WeatherSettings& settings,
                        const weather::Forecast* forecast = nullptr);

// Nothing for genera of water. Density 1 is the genus's usual optical depth: cirrus .15, cirrostratus .45,
// cirrocumulus .25.
std::optional<clouds::IceLayer> iceLayerOf(const weather::Layer& layer, const weather::Wind& wind);

// All that have some cover at a place (east and south, m), in the state's order.
std::vector<clouds::IceLayer> iceLayersAt(const weather::Moment& moment, const glm::dvec2& xz);

}  // namespace skydrop::game
