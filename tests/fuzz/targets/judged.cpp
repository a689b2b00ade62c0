// The judged light of a cloud scene.
#include "app/studies/light_scenes.h"
#include "fuzz/fuzz_input.h"

using namespace skydrop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const app::LightScene& scene = app::lightScenes().front();
  static const std::size_t views = app::lightViews(scene).size();
  const std::filesystem::path file = fuzz::inputFile("a.json", data, size);
  fuzz::accepts("a.json", [&] {
    fuzz::require(app::readJudged(scene, file).views.size() == views, "each view has its light");
  });
  return 0;
}
