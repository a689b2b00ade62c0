// Land that wears an aerial image: where its colours are drawn, and that there is nothing of it without one.
#include <cmath>
#include <memory>
#include <string>

#include "app/session/start_camera.h"
#include "skydrop/render/terrain/terrain_pass.h"
#include "support/scene_gl_test.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

constexpr Size kSize{64, 64};

class GroundPictureGLTest : public test::SceneGLTest {
 protected:
  // Red, but for a blue north-eastern quarter; 8 km around the world's origin.
  std::filesystem::path image() {
    core::Image picture(64, 64);
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) {
        picture.pixel(x, y)[x >= 32 && y < 32 ? 2 : 0] = 200;
        picture.pixel(x, y)[3] = 255;
      }
    }
    core::writePng(folder_.path() / "image.png", picture);
    folder_.write("image.pgw", "125\n0\n0\n-125\n2596062.5\n1203937.5\n");
    return folder_.path() / "image.png";
  }

  void begin(bool hasImage, const std::vector<std::string>& set = {}) {
    CommandLine line =
        lineOf("bern",
               {"effects.clouds=false", "effects.haze=false", "effects.weather=false",
                "effects.landShadows=false", "effects.aircraft=false", "effects.targets=false",
                "effects.hud=false", "streaming.viewDistanceM=8000", "render.sun.elevationDegrees=60",
                "elevation.latitude=46.9510827861504654", "elevation.longitude=7.4386324175389165"},
               set);
    if (hasImage) line.imageFiles = {image()};
    beginScene(line);
  }
  // From above a place of the world: how much more red than blue the middle of the picture is, -1 .. 1.
  double rednessAt(double x, double z, double height = 3500) {
    placeCamera(sceneRenderer_->camera(), Pose{{x, height, z}, 0, -89.9, 0}, *simulation_->ground());
    sceneRenderer_->draw(simulation_->world().now(), kSize, Streaming::settled);
    const core::Image picture = sceneRenderer_->renderer().readBack();
    double red = 0, blue = 0;
    for (int y = 28; y < 36; ++y) {
      for (int px = 28; px < 36; ++px) {
        red += picture.pixel(px, y)[0];
        blue += picture.pixel(px, y)[2];
      }
    }
    return (red - blue) / (red + blue);
  }
  bool usesPicture() {
    bool uses = false;
    for (const render::gl::ShaderProgram* program : sceneRenderer_->renderer().shaders().programs())
      for (const std::string& define : program->defines())
        uses = uses || define == render::GroundTexture::kDefine;
    return uses;
  }

  test::TemporaryFolder folder_;
};

TEST_F(GroundPictureGLTest, itsColoursAreDrawnWhereTheyLie) {
  begin(true);
  EXPECT_GT(rednessAt(-1500, -1500), 0.5) << "north-west";
  EXPECT_GT(rednessAt(1500, 1500), 0.5) << "south-east";
  EXPECT_LT(rednessAt(1500, -1500), -0.5) << "north-east is blue";
  EXPECT_LT(rednessAt(300, -300), -0.5) << "300 m from the corner of the four";
  EXPECT_GT(rednessAt(-300, -300), 0.5);
  EXPECT_LT(std::abs(rednessAt(7000, 7000)), 0.5) << "beyond its edge";
  EXPECT_TRUE(usesPicture());
}

TEST_F(GroundPictureGLTest, nearTheEyeMadeDetailTakesItsShare) {
  begin(true, {"aerialImage.nearShare=0", "aerialImage.nearM=50000"});
  EXPECT_LT(rednessAt(-1500, -1500), 0.5);
  core::setField(run_->table, "aerialImage.nearM=1");
  sceneRenderer_->apply({"aerialImage.nearM"});
  EXPECT_GT(rednessAt(-1500, -1500), 0.5);
  core::setField(run_->table, "aerialImage.share=0");
  sceneRenderer_->apply({"aerialImage.share"});
  EXPECT_LT(rednessAt(-1500, -1500), 0.4);
}

TEST_F(GroundPictureGLTest, withoutAnImageThereIsNothingOfIt) {
  begin(false);
  rednessAt(-1500, -1500);
  EXPECT_FALSE(usesPicture());
  EXPECT_EQ(sceneRenderer_->renderer().find<render::TerrainPass>()->groundTexture(), nullptr);
}

}  // namespace
}  // namespace skydrop::app
