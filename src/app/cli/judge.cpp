#include <filesystem>

#include "app/cli/verbs.h"
#include "app/console/progress.h"
#include "app/console/standard_output.h"
#include "app/studies/light_pictures.h"
#include "app/studies/light_scenes.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/image.h"
#include "skydrop/core/job_pool.h"

namespace skydrop::app {
namespace {

constexpr int kPaths = 2048, kQuickPaths = 64;
constexpr int kPicturePaths = 400, kQuickPicturePaths = 16;  // of pixels that nothing is measured by

}  // namespace

int judgeLight(const CommandLine& line) {
  namespace fs = std::filesystem;
  std::vector<const LightScene*> scenes;
  for (const std::string& name : line.scenes) {
    try {
      scenes.push_back(&lightScene(name));
    } catch (const core::RangeError& error) {
      throw core::UsageError(std::string("accuracy: ") + error.what());
    }
  }
  if (scenes.empty()) {
    for (const LightScene& scene : lightScenes()) scenes.push_back(&scene);
  }
  const fs::path folder = line.out.empty() ? "judged_clouds" : line.out;
  core::requireFolder(folder);
  core::makeFolder(folder);
  core::JobPool pool;
  Progress progress("accuracy", line.progress);
  for (const LightScene* scene : scenes) {
    const auto tell = [&](std::string_view view) { progress.show(scene->name + ": " + std::string(view)); };
    if (line.size) {
      const core::Image pictures =
          lightPictures(*scene, *line.size, line.quick ? kQuickPicturePaths : kPicturePaths, &pool, tell);
      progress.clear();
      const fs::path file = folder / (scene->name + ".png");
      core::writePng(file, pictures);
      print("%s\n", file.c_str());
      continue;
    }
    const JudgedLight judged = judge(*scene, line.quick ? kQuickPaths : kPaths, &pool, tell);
    progress.clear();
    const fs::path file = folder / (scene->name + ".json");
    core::writeFileAtomically(file, judgedText(*scene, judged));
    print("%s\n", file.c_str());
  }
  return 0;
}

}  // namespace skydrop::app
