// Air that rises and sinks: under and in clouds, and at ridges. Simple models whose figures are those of the
// literature (docs/weather.md); pure functions, any thread, the same bits on every machine.
#pragma once

#include <glm/vec2.hpp>

#include "skydrop/weather/state.h"

namespace skydrop::weather {

// What a genus does to the air, per unit of density.
struct GenusAir {
  double updraughtMps;    // of the strongest column, at the base
  double downdraughtMps;  // of the air that heavy rain drags down below the base
  double turbulenceMps;   // standard deviation of the gusts in the densest cloud
};
GenusAir airOf(Genus genus);

// The vertical wind of a layer, m/s, upwards positive, at a height above the sea with the ground below it, m.
// `column`: density of the cloud that stands above or around, [0, 1]; `rain`: mm/h.
//
// Below the base a column of air rises as a thermal does, with the cube root of the share of the way from the
// ground to the base (Lenschow and Stephens 1980), in the cloud it fades as a parabola to the top; between
// the columns it sinks, so that as much air comes down as goes up where the cover is below a third. Under a
// cumulonimbus rain turns the column into a downdraught: wholly from 20 mm/h on.
double cloudDraught(const Layer& layer, double column, double heightM, double groundM, double rain);

// The vertical wind over a slope, m/s: the wind near the ground must follow it, u . grad h, and what it does
// fades with height as of the flow over a sinusoidal ridge of 2.5 km (linear theory without stratification:
// e^-kz; Lamb 1932). Slopes count up to about a half, where flow separates. In the lee it sinks.
double slopeDraught(const glm::dvec2& windMps, const glm::dvec2& gradient, double aboveGroundM);

}  // namespace skydrop::weather
