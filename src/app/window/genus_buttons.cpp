#include "app/window/genus_buttons.h"

#include <string>

#include "skydrop/weather/usual_layer.h"

namespace skydrop::app {

std::vector<ui::GenusButton> genusButtons() {
  std::vector<ui::GenusButton> all;
  for (std::size_t i = 0; i < weather::kGenusNames.size(); ++i) {
    const auto genus = static_cast<weather::Genus>(i);
    const weather::Layer layer = weather::usualLayer(genus);
    const std::string at = "weather.sites.0.layers." + std::to_string(weather::usualPlace(genus)) + ".";
    ui::GenusButton button{weather::kGenusNames[i],
                           {{at + "genus", static_cast<double>(i)},
                            {at + "base", layer.baseM},
                            {at + "top", layer.topM},
                            {at + "cover", layer.cover},
                            {at + "density", layer.density}},
                           {{at + "cover", 0}}};
    all.push_back(std::move(button));
  }
  return all;
}

}  // namespace skydrop::app
