// Every shader variant that the program draws with, judged by the reference compiler: what one driver lets
// pass, another may not.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "app/session/run_config.h"
#include "app/session/scene_renderer.h"
#include "skydrop/core/assets.h"
#include "skydrop/lab/page.h"
#include "skydrop/render/gl/shader_source.h"
#include "skydrop/render/lab/page_picture.h"
#include "support/gl_test.h"
#include "support/process.h"
#include "support/shared_noise.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

class ShaderVariantsGLTest : public test::GLTest {
 protected:
  // Draws what warms a flight up, and keeps the stages of the programs that it needed.
  void draw(const std::string& scene, const std::vector<std::string>& set,
            const std::vector<std::filesystem::path>& images = {}) {
    CommandLine line;
    line.verb = Verb::render;
    line.scene = scene;
    // Land that is soon made: what is compiled hangs on no land in particular.
    line.set = {"streaming.farDistanceM=5000", "streaming.viewDistanceM=1000", "landShadows.detail=coarse"};
    line.set.insert(line.set.end(), set.begin(), set.end());
    line.imageFiles = images;
    const auto run = prepareRun(line);
    Simulation simulation(run->setup, run->settings, run->table);
    SceneRenderer sceneRenderer(context(),
                                {.effects = simulation.effects(),
                                 .ground = simulation.ground(),
                                 .workers = 1,
                                 .prepared = PreparedResources(test::sharedNoise()),
                                 .framesFollow = true,
                                 .images = simulation.images()},
                                run->settings);
    sceneRenderer.warmUp(simulation.world().now(), {64, 36});
    for (const render::gl::ShaderProgram* program : sceneRenderer.renderer().shaders().programs()) {
      for (const render::gl::ShaderProgram::File& file : program->files())
        note(file.name, program->defines());
    }
  }

  // The loops of a graphics card too, which a software renderer draws nothing with.
  void note(const std::string& entry, std::span<const std::string> defines) {
    seen_.insert(entry);
    texts_.emplace(render::gl::ShaderSource(entry, defines).text(), entry);
    std::vector<std::string> others(defines.begin(), defines.end());
    if (std::erase(others, "FLAT_LOOPS") > 0)
      texts_.emplace(render::gl::ShaderSource(entry, others).text(), entry);
  }

  std::map<std::string, std::string> texts_;  // to the entry file
  std::set<std::string> seen_;
};

// Entry files that no scene draws with.
constexpr const char* kOfTools[] = {"clouds/noise.comp",         "imgui/imgui.frag",  "imgui/imgui.vert",
                                    "noise/gradient_noise.comp", "noise/volume.comp", "split/split.frag"};

TEST_F(ShaderVariantsGLTest, passTheReferenceCompiler) {
  // Of the scene with everything, in each tier and quality, and of those that lack what the others rest on.
  // Each entry file must have been among them.
  draw("stress", {});
  draw("stress", {"quality=low"});
  draw("stress",
       {"clouds.tier=reference", "effects.haze=false", "effects.terrain=false", "effects.targets=false",
        "render.picture.smoothModels=false", "render.picture.guardMarks=true"});
  draw("plane3", {"effects.haze=false", "cloudPlanes.resolution=quarter"});
  draw("fair", {"render.land.terrainNormals=true", "render.land.wireframe=true",
                "clouds.march.resolution=half", "clouds.march.detail=false"});
  draw("woodland", {});
  draw("woodland", {"quality=low", "effects.clouds=false", "effects.landShadows=false"});
  draw("airstrip", {"effects.vegetation=true"});
  draw("airstrip", {"effects.groundDetail=true"});
  draw("airstrip", {"effects.groundDetail=true", "effects.vegetation=true", "quality=low"});
  draw("afterRain", {"effects.groundDetail=true"});
  draw("cirrus", {"effects.vegetation=true"});
  draw("lagoon", {"effects.vegetation=true"});
  draw("village", {});
  draw("village", {"quality=low", "effects.clouds=false", "effects.landShadows=false"});
  draw("airstrip", {"effects.places=true", "effects.vegetation=true"});
  draw("cirrus", {"effects.places=true"});
  draw("lagoon", {"effects.places=true"});
  draw("thunderstorm", {"effects.waterDetail=true", "effects.dustAndSpray=true"});
  draw("lagoon", {"effects.vegetation=true", "effects.places=true", "waterDetail.mirror=plane"});
  draw("thunderstorm", {"effects.waterDetail=true", "effects.vegetation=true", "waterDetail.mirror=plane"});
  draw("plane3", {"effects.dustAndSpray=true", "effects.haze=false"});
  draw("terrain", {"effects.groundCover=true"});
  draw("village", {"effects.groundCover=true"});
  draw("cirrus", {"effects.groundCover=true", "effects.haze=false"});
  draw("thunderstorm", {"effects.groundCover=true"});
  draw("coldFront", {});
  draw("thunderstorm", {});
  draw("fair", {"clouds.march.history=quarter"});
  draw("warmFront", {});
  draw("bern", {});
  draw("bern", {}, {core::assetPath("elevation/mittelland_aerial.tif")});
  draw("bern", {"render.land.detail=plain"}, {core::assetPath("elevation/mittelland_aerial.tif")});
  draw("afterRain", {"clouds.march.history=quarter"});
  draw("afterRain", {"clouds.tier=reference"});
  draw("fair", {"clouds.march.history=sixteenth", "clouds.march.resolution=full"});
  draw("fair", {"clouds.light=volume"});
  draw("afterRain", {"clouds.light=volume"});
  draw("afterRain", {"clouds.light=volume", "clouds.tier=reference"});
  draw("cirrus", {"effects.clouds=true", "effects.halo=true"});
  draw("cirrus", {"iceClouds.resolution=quarter", "effects.haze=false"});
  for (const char* entry : kOfTools) note(entry, {});
  for (const lab::Page& page : lab::pages())
    note(render::shaderOf(page), render::definesOf(page, page.makeKnobs()->table()));
  for (const auto& file : std::filesystem::recursive_directory_iterator(core::shaderPath(""))) {
    const std::string name = std::filesystem::relative(file.path(), core::shaderPath("")).generic_string();
    if (file.is_regular_file() && file.path().extension() != ".glsl" &&
        file.path().filename() != ".gitkeep") {
      EXPECT_TRUE(seen_.contains(name)) << name;
    }
  }
  const test::TemporaryFolder folder;
  std::vector<std::string> words = {"/usr/bin/env", "glslangValidator"};
  int number = 0;
  for (const auto& [text, entry] : texts_) {
    std::string name = entry;
    std::ranges::replace(name, '/', '_');
    words.push_back((folder.path() / (std::to_string(++number) + '_' + name)).string());
    folder.write(words.back(), text);
  }
  const test::ProcessResult result = test::runProcess(words);
  EXPECT_EQ(result.exitCode, 0) << result.out << result.err;
}

}  // namespace
}  // namespace skydrop::app
