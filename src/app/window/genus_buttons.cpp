#include "app/window/genus_buttons.h"

#include <algorithm>
#include <string>

#include "app/settings/settings.h"
#include "skydrop/game/flown_clouds.h"
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
    if (weather::usualPlace(genus) == 0) {
      Settings settings;
      const core::SettingsTable table(settings);
      settings.clouds.layers[0] = game::cloudLayerOf(layer).layer;
      const std::string drawn = "clouds.layers.0.";
      for (const char* row :
           {"cloudHeight", "thickness", "coverage", "typeShift", "scale", "erosion", "extinction"}) {
        const core::Field& field = table.at(drawn + row);
        button.values.push_back({field.path, std::clamp(field.get(), field.min, field.max)});
      }
      button.away.push_back({drawn + "coverage", 0});
    }
    all.push_back(std::move(button));
  }
  return all;
}

}  // namespace skydrop::app
