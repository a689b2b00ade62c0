// Scene files, and their settings.
#include "skydrop/scene/scene.h"

#include "app/settings/settings.h"
#include "fuzz/fuzz_input.h"

using namespace skydrop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static app::Settings settings;
  static const core::SettingsTable table(settings);
  const std::string text = fuzz::textOf(data, size);
  fuzz::accepts("a.json", [&] {
    const scene::Scene scene = scene::parseScene(text, "a.json");
    fuzz::require(scene.start.speedMps >= 0 && scene.start.speedMps <= 300,
                  "the start's speed is in its range");
    scene::requiredEffects(scene);
    app::applyScene(table, scene);
  });
  return 0;
}
