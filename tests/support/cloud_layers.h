// Fixture of frames with weather: the clouds that are drawn are its layers.
#pragma once

#include <array>
#include <memory>
#include <utility>

#include "skydrop/game/flown_clouds.h"
#include "skydrop/weather/weather_settings.h"
#include "support/cloud_rows.h"

namespace skydrop::test {

class CloudLayersGLTest : public CloudRowsGLTest {
 protected:
  using Layers = std::vector<weather::WeatherLayerSettings>;

  static constexpr weather::WeatherLayerSettings kCumulus{weather::Genus::cumulus, 1555, 3355, 0.5, 1};
  static constexpr weather::WeatherLayerSettings kAltocumulus{weather::Genus::altocumulus, 4200, 4700, 0.5,
                                                              1};
  static constexpr weather::WeatherLayerSettings kNimbostratus{weather::Genus::nimbostratus, 2200, 6500, 0.8,
                                                               1};
  static constexpr weather::WeatherLayerSettings kTower{weather::Genus::cumulonimbus, 1055, 11000, 0.5, 1};

  // One site's, without wander, from the next frame on.
  void setWeather(const Layers& layers) {
    weather::WeatherSettings settings;
    settings.variability = 0;
    for (std::size_t i = 0; i < layers.size(); ++i) settings.sites[0].layers.at(i) = layers[i];
    setWeather(std::move(settings));
  }
  void setWeather(weather::WeatherSettings settings) {
    snapshot_.weather = {std::make_shared<const weather::WeatherSettings>(std::move(settings)), 1, 0};
  }
  static weather::Layer stateOf(const weather::WeatherLayerSettings& s) {
    return {s.genus, s.base, s.top, s.cover, s.density};
  }
  std::optional<std::string> skipReasonOf(const render::View& view) {
    return system_->skipReason(render::gameFrame(snapshot_, view, features_));
  }
};

}  // namespace skydrop::test
