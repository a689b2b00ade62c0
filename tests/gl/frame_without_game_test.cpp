// Frames that no game is behind: everything but aircraft, packages, the target's mark and shadows is drawn.
#include <gmock/gmock.h>

#include <memory>

#include "skydrop/core/assets.h"
#include "skydrop/core/job_pool.h"
#include "skydrop/render/frame/tone_map_pass.h"
#include "skydrop/render/models/aircraft_pass.h"
#include "skydrop/render/models/marker_pass.h"
#include "skydrop/render/models/package_pass.h"
#include "skydrop/render/shadows/shadow_pass.h"
#include "skydrop/render/sky/sky_pass.h"
#include "skydrop/render/terrain/terrain_pass.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "skydrop/terrain/endless_terrain.h"
#include "support/cloud_frame_test.h"
#include "support/shared_noise.h"

namespace skydrop::render {
namespace {

constexpr double kGroundM = 400;

// Every pass of a scene, over level land.
class FrameWithoutGameGLTest : public test::FrameTest {
 protected:
  void SetUp() override {
    FrameTest::SetUp();
    if (IsSkipped()) return;
    const auto airplane = std::make_shared<const Model>(
        context(), importModel(core::assetPath("models/airplane.glb")), "airplane");
    const auto packages = std::make_shared<const PackageModels>(context());
    auto land = std::make_unique<TerrainPass>(context());
    landPass_ = land.get();
    auto shadows = std::make_unique<ShadowPass>();
    shadows->add("aircraft", aircraftShadow(airplane));
    shadows->add("targets", packageShadows(packages));
    renderer().add(std::move(shadows));
    renderer().add(std::move(land));
    renderer().add(std::make_unique<SkyPass>(context()));
    renderer().add(std::make_unique<AircraftPass>(airplane));
    renderer().add(std::make_unique<PropellerPass>(airplane));
    renderer().add(std::make_unique<PackagePass>(packages));
    renderer().add(std::make_unique<MarkerPass>(context()));
    renderer().add(std::make_unique<ToneMapPass>(context()));
    settings_.sun = {60, 135};
  }

  core::PassStatistics statisticsOf(std::string_view pass) {
    core::FrameStatistics statistics;
    renderer().fillStatistics(statistics);
    for (const auto& [name, row] : statistics.passes) {
      if (name == pass) return row;
    }
    ADD_FAILURE() << "no pass " << pass;
    return {};
  }

  core::JobPool pool_{1};
  terrain::EndlessTerrain land_{terrain::makeFlatSource(kGroundM), pool_, {}};
  TerrainPass* landPass_ = nullptr;
};

TEST_F(FrameWithoutGameGLTest, skyAndLandAreDrawnAndPassesOfTheGameAreSkipped) {
  // Land below and sky above fill the picture; each pass of the game gives a reason. With a game in which the
  // aircraft flies ahead the same passes draw, so it is the lack of one that silences them; with a game in
  // which nothing is there the picture has the same bits as without one.
  const View view = pose({0, kGroundM + 100, 0}, 0, -10, 0);
  landPass_->take(land_.settle(viewVolume(view)));
  const core::Image picture = draw(FrameInput{.view = view, .features = features_});
  EXPECT_GT(statisticsOf("terrain").draws, 0);
  EXPECT_GT(statisticsOf("sky").draws, 0);
  const auto brightness = [&](int x, int y) {
    const std::uint8_t* pixel = picture.pixel(x, y);
    return pixel[0] + pixel[1] + pixel[2];
  };
  EXPECT_GT(brightness(160, 5), 100) << "no sky";
  EXPECT_GT(brightness(160, 175), 30) << "no land";
  EXPECT_GT(picture.pixel(160, 5)[2], picture.pixel(160, 5)[0]) << "the sky is not blue";
  EXPECT_LT(picture.pixel(160, 175)[2], picture.pixel(160, 175)[1]) << "the land is not green";
  const std::vector<std::pair<const char*, const char*>> skipped = {
      {"aircraft", "no aircraft"},
      {"propeller", "no aircraft"},
      {"packages", "no package has been dropped"},
      {"marker", "no target"},
      {"shadows", "nothing that casts a shadow"},
      {"modelLayer", "no model in view"}};
  for (const auto& [pass, reason] : skipped) EXPECT_EQ(statisticsOf(pass).skipped, reason) << pass;

  EXPECT_EQ(draw(view).rgba, picture.rgba);
  snapshot_.aircraft.present = true;
  snapshot_.aircraft.position = view.position + glm::dvec3(40, -10, 0);
  snapshot_.packages.resize(1);
  snapshot_.packages[0].position = view.position + glm::dvec3(40, -10, 10);
  snapshot_.target = {.present = true, .position = {300, kGroundM, 0}, .radius = 50};
  EXPECT_NE(draw(view).rgba, picture.rgba);
  for (const auto& [pass, reason] : skipped) EXPECT_EQ(statisticsOf(pass).skipped, "") << pass;
}

using CloudsWithoutGameGLTest = test::CloudFrameTest;

TEST_F(CloudsWithoutGameGLTest, cloudsDriftByTheSecondsOfTheFrame) {
  // Ten minutes of wind change the picture, and a snapshot of the same second changes nothing more.
  clouds_.march = test::quickRows();
  addClouds(test::sharedNoise());
  renderer().add(std::make_unique<ToneMapPass>(context()));
  const View view = pose({0, 600, 0}, 40, 14, 0, 64, 36);
  const core::Image now = draw(FrameInput{.view = view, .features = features_});
  const core::Image later = draw(FrameInput{.view = view, .features = features_, .simulatedSeconds = 600});
  EXPECT_NE(now.rgba, later.rgba);
  snapshot_.simulatedSeconds = 600;
  EXPECT_EQ(draw(view).rgba, later.rgba);
}

}  // namespace
}  // namespace skydrop::render
