// From settings to the weather that the world flies in.
#pragma once

#include <memory>
#include <optional>

#include "app/settings/settings.h"
#include "skydrop/clouds/cloud_field.h"
#include "skydrop/game/world.h"

namespace skydrop::app {

// The noise that the clouds are made of, as the simulation asks it: from the cache folder, or made on this
// thread (1.5 s) and put there. The same bits on every machine: textures that a graphics card has made, which
// differ in a few texels, are not taken, and those of the processor are kept in a folder beside them.
std::shared_ptr<const clouds::PackedCloudNoise> readFlownNoise();

// None without the effect. `noise` is read when there are clouds and it is null, and kept there. The forecast
// of weather files, or null.
std::optional<game::WeatherSetup> flownWeather(const scene::EffectSet& effects, const Settings& settings,
                                               std::shared_ptr<const clouds::PackedCloudNoise>& noise,
                                               const std::shared_ptr<const weather::Forecast>& forecast);

// The clock of a forecast as the clock of the sky has it, where that moves the sun and the settings let it be
// followed; else that of the settings.
weather::ForecastClock forecastClock(const Settings& settings, const weather::Forecast& forecast);

}  // namespace skydrop::app
