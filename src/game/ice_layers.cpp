#include "skydrop/game/ice_layers.h"

#include <algorithm>

#include "skydrop/weather/wind_profile.h"

namespace skydrop::game {
namespace {

// A height above the ground at which the ground does not slow the wind.
constexpr double kFreeAirM = 1e4;

struct IceLook {
  clouds::IceGenus genus;
  double opticalDepth;
};

std::optional<IceLook> lookOf(weather::Genus genus) {
  switch (genus) {
    case weather::Genus::cirrus:
      return IceLook{clouds::IceGenus::cirrus, 0.15};
    case weather::Genus::cirrostratus:
      return IceLook{clouds::IceGenus::cirrostratus, 0.45};
    case weather::Genus::cirrocumulus:
      return IceLook{clouds::IceGenus::cirrocumulus, 0.25};
    default:
      return std::nullopt;
  }
}

}  // namespace

weather::Wind iceWindOf(const weather::WeatherSettings& settings, const weather::Forecast* forecast) {
  if (forecast) return weather::strandWind(*forecast);
  return weather::stateOf(settings.sites[0]).wind;
}

std::optional<clouds::IceLayer> iceLayerOf(const weather::Layer& layer, const weather::Wind& wind) {
  const std::optional<IceLook> look = lookOf(layer.genus);
  if (!look) return std::nullopt;
  clouds::IceLayer out;
  out.genus = look->genus;
  clouds::setLevels(out, layer.baseM, layer.topM);
  out.cover = layer.cover;
  out.opticalDepth = look->opticalDepth * layer.density;
  const weather::WindProfile profile(wind);
  const auto at = [&](double height) {
    const glm::dvec3 velocity = profile.at(height, kFreeAirM);
    return glm::dvec2(velocity.x, velocity.z);
  };
  const glm::dvec2 top = at(layer.topM), middle = at(0.5 * (layer.baseM + layer.topM)),
                   base = at(layer.baseM);
  const glm::dvec2 shear = top - base, lower = middle - base;
  clouds::setStreaks(out, shear, 0, top);
  // Across the axis; on it where the shear is the same all the way down.
  const double across = out.along.x * lower.y - out.along.y * lower.x;
  clouds::setStreaks(out, shear, 2 * across, top);
  return out;
}

std::vector<clouds::IceLayer> iceLayersAt(const weather::Moment& moment, const glm::dvec2& xz) {
  std::vector<clouds::IceLayer> layers;
  if (!moment) return layers;
  const weather::Wind wind = iceWindOf(*moment.settings, moment.forecast.get());
  for (const weather::Layer& layer : moment.at(xz).layers) {
    if (!(layer.cover > 0 && layer.density > 0)) continue;
    if (const auto ice = iceLayerOf(layer, wind)) layers.push_back(*ice);
  }
  return layers;
}

}  // namespace skydrop::game
