#include <string>

#include "app/cli/verbs.h"
#include "app/console/progress.h"
#include "app/console/standard_output.h"
#include "app/measure/stopwatch.h"
#include "app/session/noise_store.h"
#include "app/session/open_context.h"
#include "app/settings/quality_preset.h"
#include "app/studies/budget_calibration.h"
#include "skydrop/accuracy/budget_ladder.h"
#include "skydrop/core/error.h"

namespace skydrop::app {
namespace {

// What a window on this machine would draw with, and how large it would open.
struct Machine {
  std::string renderer;
  Quality quality = Quality::high;
  Size window;
};

Machine thisMachine() {
  const auto context = openContext(std::nullopt, {16, 16});
  Machine machine{context->renderer(), qualityFor(Quality::automatic, context->isSoftware()), {}};
  machine.window = readQualityPreset(machine.quality).window;
  return machine;
}

}  // namespace

int calibrateBudget(const CommandLine& line) {
  const std::filesystem::path cache = cacheFolder();
  if (cache.empty())
    throw core::DataError("calibrate", "", "there is no cache folder: set XDG_CACHE_HOME or HOME");
  const std::string name = line.scenes.empty() ? kDefaultScene : line.scenes.front();
  const scene::Scene scene = scene::loadScene(name);
  const Machine machine = thisMachine();
  Calibration calibration;
  calibration.scene = name;
  calibration.key = BudgetFrontKey::of(scene, machine.renderer, line.size.value_or(machine.window));
  calibration.set = {"quality=" + std::string(kQualityNames[static_cast<std::size_t>(machine.quality)])};
  const Stopwatch watch;
  Progress progress("accuracy", line.progress);
  const accuracy::Results results =
      calibrated(budgetStudy(), calibration, [&](std::size_t done, std::size_t all) {
        if (progress.isDue())
          progress.show("calibrate, " + std::to_string(done) + " of " + std::to_string(all));
      });
  progress.clear();
  print("%s, %s, %.0f s\n", scene.name.c_str(), calibration.key.machine().c_str(), watch.ms() / 1000);
  for (const accuracy::BudgetRung& rung : accuracy::budgetLadder(results))
    print("%8.1f ms  relative RMSE %.4f  %s\n", rung.ms, rung.error, rung.label.c_str());
  print("%s\n", keepBudgetFronts(results, calibration.key, cache).string().c_str());
  return 0;
}

}  // namespace skydrop::app
