// What weather made by hand and weather from files share: the way between two sites, and the wander.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

#include "skydrop/weather/weather_settings.h"

namespace skydrop::weather {

// siteShare() of two sites, x east, z south, m.
double shareAlong(const glm::dvec2& first, const glm::dvec2& second, double approachSeconds, double seconds,
                  const glm::dvec2& xz);

// Moves the state about its mean, as far and as fast as the settings say.
void letWander(State& state, const WeatherSettings& settings, std::uint64_t seed, double seconds);

}  // namespace skydrop::weather
