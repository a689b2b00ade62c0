#include "app/window/noise_sky.h"

#include <algorithm>
#include <string>

#include "app/settings/settings.h"
#include "skydrop/core/settings_table.h"

namespace skydrop::app {

CommandLine flightUnder(const noise::NoiseRecipe& recipe, bool isVolume, const CommandLine& tool) {
  CommandLine line;
  line.verb = Verb::fly;
  line.size = tool.size;
  line.scene = isVolume ? "dome" : "plane1";
  Settings settings;
  const core::SettingsTable table(settings);
  const std::string group = isVolume ? "cloudDome." : "cloudPlanes.layers.0.";
  const auto take = [&](const std::string& name, double value) {
    const core::Field& field = table.at(group + name);
    field.set(std::clamp(value, field.min, field.max));
    line.set.push_back(field.path + "=" + core::fieldText(field));
  };
  take("octaves", static_cast<double>(recipe.settings.octaves));
  take("frequency", static_cast<double>(recipe.settings.frequency));
  take("amplitude", recipe.settings.amplitude);
  take("persistence", recipe.settings.persistence);
  take("seed", static_cast<double>(recipe.settings.seed));
  if (recipe.postProcess) {
    take("cutoff", recipe.postProcess->cutoff);
    take(isVolume ? "exponent" : "density", recipe.postProcess->density);
  }
  return line;
}

}  // namespace skydrop::app
