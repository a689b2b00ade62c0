// Every row of the picture does something over all that its slider covers, a tenth at a time: those of the
// weather by what a ray sees of the clouds, and by where there is cloud; the others by whole frames of the
// game. Other rows: tests/app/settings_effect_test.cpp.
#include <algorithm>
#include <functional>
#include <glm/trigonometric.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/session/run_config.h"
#include "app/session/scene_renderer.h"
#include "app/settings/settings.h"
#include "skydrop/core/hash.h"
#include "skydrop/render/clouds/cloud_dome.h"
#include "skydrop/render/clouds/cloud_plane.h"
#include "support/cloud_rows.h"
#include "support/row_steps.h"
#include "support/shared_noise.h"

namespace skydrop::app {
namespace {

using core::StateHasher;

class CloudRowsEffectGLTest : public test::CloudRowsGLTest {
 protected:
  std::uint64_t observe() {
    StateHasher h;
    for (const render::View& view : {below(), inside(), above()}) {
      for (const glm::vec4& texel : sceneFrom(view))
        for (int c = 0; c < 3; ++c) h.add(static_cast<double>(texel[c]));
    }
    clouds::CloudField field(noise_, clouds_);
    field.setDrift(core::windDrift(wind_, snapshot_.simulatedSeconds));
    core::RandomStream random{1, 0};
    for (int i = 0; i < 20000; ++i) {
      const double x = 2 * random.nextUnit() - 1, y = random.nextUnit(), z = 2 * random.nextUnit() - 1;
      h.add(field.density({x * 20000, y * 6000, z * 20000}));
    }
    return h.value();
  }

  std::shared_ptr<const clouds::PackedCloudNoise> noise_ = test::sharedNoise();
};

TEST_F(CloudRowsEffectGLTest, everyTenthOfEveryRowOfTheWeatherMakesADifference) {
  Settings settings;
  const core::SettingsTable table(settings);
  addSky();
  addClouds(noise_);
  snapshot_.simulatedSeconds = 100;
  int rows = 0;
  for (const core::Field& field : table.fields()) {
    const bool isOfTheWeather = field.path == "clouds.fadeDistance" ||
                                field.group.starts_with("clouds.layers.") ||
                                (field.group == "wind" && field.kind == core::FieldKind::number);
    if (!isOfTheWeather) continue;
    ++rows;
    settings.clouds = clouds::CloudSettings();
    settings.clouds.march.lightCells = clouds::LightCells::coarse;  // quick to solve
    settings.clouds.light = clouds::CloudLight::octaves;
    settings.clouds.march.resolution =
        clouds::MarchResolution::full;  // few clouds fit between rays so far apart
    settings.wind = core::WindSettings();
    const auto look = [&] {
      clouds_ = settings.clouds;
      wind_ = settings.wind;
      return observe();
    };
    for (const std::string& line : test::idleSteps(field, {}, look)) ADD_FAILURE() << line;
    if (field.group == "wind") continue;  // moves the field and its light
    settings.clouds.light = clouds::CloudLight::volume;
    for (const std::string& line : test::idleSteps(field, {}, look, test::fewRowSteps(field)))
      ADD_FAILURE() << line << " (volume)";
  }
  EXPECT_GE(rows, 15);
}

TEST_F(CloudRowsEffectGLTest, onlyTheTierOffDrawsNoClouds) {
  // The other tiers are told apart by their rows.
  addSky();
  addClouds(noise_);
  const std::vector<glm::vec4> background = withoutClouds(below());
  for (std::size_t tier = 1; tier < clouds::kCloudTierNames.size(); ++tier) {
    clouds_.tier = static_cast<clouds::CloudTier>(tier);
    EXPECT_GT(difference(sceneFrom(below()), background), 20) << tier;
  }
}

// Lattice cells of these octaves are whole texels, where the noise is 0.
constexpr test::IdlePart kIdle[] = {
    {"cloudPlanes.layers.1.octaves", 9, 10, "finer than the texels"},
    {"cloudPlanes.layers.2.octaves", 6, 10, "finer than the texels"},
};

// Clouds without thickness, on small textures: planes from below with their rim in view, the dome above.
class CloudSheetRowsEffectGLTest : public test::CloudRowsGLTest {
 protected:
  void SetUp() override {
    CloudRowsGLTest::SetUp();
    if (IsSkipped()) return;
    renderer().add(std::make_unique<test::LightProbe>(light_));
    addSky();
    features_.haze = true;
    snapshot_.simulatedSeconds = 100;
  }

  // Every row of the group, from defaults with more cloud and smaller textures.
  int tryRows(std::string_view group, const std::function<std::uint64_t(const Settings&)>& observe) {
    Settings settings;
    const core::SettingsTable table(settings);
    int rows = 0;
    for (const core::Field& field : table.fields()) {
      if (!field.path.starts_with(group)) continue;
      ++rows;
      settings = Settings();
      for (clouds::CloudPlaneSettings& layer : settings.cloudPlanes.layers) {
        layer.textureSide = 128;
        layer.cutoff = 0.5;
      }
      settings.cloudDome.textureSide = 32;
      settings.cloudDome.cutoff = 0.5;
      // Fine octaves need fine texels.
      if (field.path.ends_with(".octaves")) {
        for (clouds::CloudPlaneSettings& layer : settings.cloudPlanes.layers) layer.textureSide = 1024;
        settings.cloudDome.textureSide = 128;
      }
      for (const std::string& line : test::idleSteps(field, kIdle, [&] { return observe(settings); }))
        ADD_FAILURE() << line;
    }
    return rows;
  }
  void add(StateHasher& h) const {
    for (const glm::vec4& texel : light_)
      for (int c = 0; c < 3; ++c) h.add(static_cast<double>(texel[c]));
  }

  std::vector<glm::vec4> light_;
};

TEST_F(CloudSheetRowsEffectGLTest, everyTenthOfEveryRowOfThePlanesMakesADifference) {
  auto pass = std::make_unique<render::CloudPlanes>(context(), nullptr, Settings().cloudPlanes, wind_);
  render::CloudPlanes& planes = *pass;
  renderer().add(std::move(pass));
  EXPECT_GE(
      tryRows("cloudPlanes.",
              [&](const Settings& settings) {
                planes.apply(settings.cloudPlanes, settings.wind);
                planes.waitForNoise();
                StateHasher h;
                for (const render::View& view : {small({0, 300, 0}, 40, 14), small({0, 7000, 0}, 40, -4)}) {
                  draw(view);
                  add(h);
                }
                return h.value();
              }),
      30);
}

TEST_F(CloudSheetRowsEffectGLTest, everyTenthOfEveryRowOfTheDomeMakesADifference) {
  auto pass = std::make_unique<render::CloudDome>(context(), nullptr, Settings().cloudDome);
  render::CloudDome& dome = *pass;
  renderer().add(std::move(pass));
  EXPECT_GE(tryRows("cloudDome.",
                    [&](const Settings& settings) {
                      dome.apply(settings.cloudDome);
                      dome.waitForNoise();
                      StateHasher h;
                      draw(small({0, 300, 0}, 40, 45));
                      add(h);
                      return h.value();
                    }),
            17);
}

// What a row needs before it means anything.
struct Given {
  std::string_view row;
  std::vector<std::string_view> settings = {};
  Size size = {64, 36};
};

// Frames of the default scene.
class PictureRowsEffectGLTest : public test::GLTest {
 protected:
  void SetUp() override {
    GLTest::SetUp();
    if (IsSkipped()) return;
    CommandLine line;
    line.verb = Verb::render;
    // Quick, and the clouds fill the frames. A light volume would be solved anew for every sun, and villages be
    // planned anew, because all rows are applied each time.
    line.set = {"clouds.tier=low", "clouds.march.resolution=full", "clouds.light=octaves",
                "effects.places=false"};
    run_ = prepareRun(line);
    simulation_ = std::make_unique<Simulation>(run_->setup, run_->settings, run_->table);
    const SceneRenderer::Setup setup{simulation_->effects(), simulation_->ground(), 2, false,
                                     PreparedResources(test::sharedNoise())};
    sceneRenderer_ = std::make_unique<SceneRenderer>(context(), setup, run_->settings);
    sceneRenderer_->camera().setMode(render::CameraMode::free);
    sceneRenderer_->renderer().add(std::make_unique<test::LightProbe>(light_));
  }
  void TearDown() override {
    sceneRenderer_.reset();
    GLTest::TearDown();
  }

  // Metres and degrees; with the aircraft ahead on the left.
  void addFrame(StateHasher& h, const glm::dvec3& eye, double yaw, double pitch, Size size) {
    render::Camera& camera = sceneRenderer_->camera();
    camera.setPose(eye, glm::radians(yaw), glm::radians(pitch), 0);
    game::Snapshot shown = simulation_->world().now();
    shown.simulatedSeconds = 100;
    shown.aircraft.position = eye + 20.0 * camera.direction() + glm::dvec3(0, 1, 0);
    sceneRenderer_->draw(shown, size, Streaming::settled);
    for (const glm::vec4& texel : light_)
      for (int c = 0; c < 3; ++c) h.add(static_cast<double>(texel[c]));
    for (const std::uint8_t byte : sceneRenderer_->renderer().readBack().rgba) h.add(std::uint64_t{byte});
  }

  std::vector<std::string> idleSteps(const core::Field& field, const Given& given) {
    const Settings kept = run_->settings;
    for (const std::string_view row : given.settings) core::setField(run_->table, row);
    std::vector<std::string> lines = test::idleSteps(field, {}, [&] {
      sceneRenderer_->apply(SettingsChange::ofAll(run_->table));
      StateHasher h;
      addFrame(h, {0, 1500, 0}, 40, 2, given.size);
      return h.value();
    });
    run_->settings = kept;
    return lines;
  }

  std::unique_ptr<app::RunConfig> run_;
  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<SceneRenderer> sceneRenderer_;

 private:
  std::vector<glm::vec4> light_;  // of the last frame, before the tone map
};

TEST_F(PictureRowsEffectGLTest, everyTenthOfEveryRowOfThePictureMakesADifference) {
  const std::vector<Given> kGiven = {
      {"clouds.march.coarseTolerance", {"clouds.march.resolution=quarter"}, {240, 135}},
      {"clouds.march.fineTolerance", {"clouds.march.resolution=half"}, {240, 135}},
      {"clouds.march.farTolerance",
       {"clouds.march.resolution=quarter", "clouds.march.coarseTolerance=0.1",
        "clouds.march.fineTolerance=0.1", "clouds.march.farStartM=2000"},
       {240, 135}},
      {"clouds.march.lightCells", {"clouds.light=volume"}},
      {"clouds.march.stepGrowth", {"clouds.march.stepM=4"}},
      {"clouds.march.maxSegmentOpticalDepth", {"clouds.march.exact=true"}},
      {"clouds.march.sunSamples", {"clouds.march.exact=true"}},
      {"render.sun.utc", {"sky.sun=clock", "sky.longitude=180"}},  // its steps are at midnight UTC
      {"render.sun.shiftDays", {"sky.sun=clock"}},
      // So far north that it is never night in June.
      {"render.sun.shiftHours", {"sky.sun=clock", "sky.latitude=60"}},
      {"render.sun.timeScale", {"sky.sun=clock", "sky.latitude=60"}},
      {"render.sun.offsetSeconds", {"sky.sun=clock", "sky.latitude=60"}},
      {"render.sun.latitudeDegrees", {"sky.sun=clock"}},
      {"render.sun.longitudeDegrees", {"sky.sun=clock", "sky.latitude=60"}},
  };
  int rows = 0;
  for (const core::Field& field : run_->table.fields()) {
    const bool isOfThePicture =
        (field.path.starts_with("render.") && !field.path.starts_with("render.camera.")) ||
        field.path.starts_with("clouds.march.") || field.path == "streaming.farDistanceM";
    // Of frames that follow others alone: tests/gl/cloud_history_test.cpp.
    if (!isOfThePicture || field.path == "clouds.march.history") continue;
    if (field.path == "render.picture.interfaceAtNight") continue;  // tests/gl/night_flight_test.cpp
    ++rows;
    const auto given = std::ranges::find(kGiven, field.path, &Given::row);
    for (const std::string& line : idleSteps(field, given == kGiven.end() ? Given() : *given))
      ADD_FAILURE() << line;
  }
  EXPECT_GE(rows, 20);
}

}  // namespace
}  // namespace skydrop::app
