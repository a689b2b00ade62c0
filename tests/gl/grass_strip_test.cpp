// The look of grass strips: where it is drawn, and that land without strips has nothing of it.
#include <memory>
#include <optional>
#include <string>

#include "app/session/start_camera.h"
#include "skydrop/terrain/strips.h"
#include "support/scene_gl_test.h"

namespace skydrop::app {
namespace {

constexpr Size kSize{64, 64};

class GrassStripGLTest : public test::SceneGLTest {
 protected:
  void begin(const std::vector<std::string>& set = {}, bool framesFollow = false) {
    beginScene(lineOf("airstrip",
                      {"effects.clouds=false", "effects.haze=false", "effects.landShadows=false",
                       "effects.targets=false", "effects.hud=false",

                       "streaming.viewDistanceM=4000", "render.sun.elevationDegrees=60"},
                      set),
               2, framesFollow);
  }
  terrain::Strip strip() { return simulation_->ground()->strips()->nearest({0, 0}, 30000).value(); }

  // Of the middle of a picture of what lies straight below: red, green, blue.
  glm::dvec3 seenAt(const glm::dvec2& xz, double heightM) {
    const double ground = simulation_->ground()->sample(xz).height;
    placeCamera(sceneRenderer_->camera(), Pose{{xz.x, ground + heightM, xz.y}, 0, -89.9, 0},
                *simulation_->ground());
    sceneRenderer_->draw(simulation_->world().now(), kSize, Streaming::settled);
    const core::Image picture = sceneRenderer_->renderer().readBack();
    glm::dvec3 sum(0);
    for (int y = 31; y < 33; ++y)
      for (int x = 31; x < 33; ++x)
        for (int c = 0; c < 3; ++c) sum[c] += picture.pixel(x, y)[c] / 4.0;
    return sum;
  }
  bool anyShaderKnowsOfStrips() {
    for (const render::gl::ShaderProgram* program : sceneRenderer_->renderer().shaders().programs())
      for (const std::string& define : program->defines())
        if (define == "GRASS_STRIP") return true;
    return false;
  }
};

TEST_F(GrassStripGLTest, marksAndTurfAreDrawnWhereItLies) {
  begin();
  const terrain::Strip strip = this->strip();
  for (const double end : {-1.0, 1.0}) {
    const double bars = end * (strip.halfLength - 12);
    const glm::dvec3 bar = seenAt(strip.world(bars, 2.5), 30);
    const glm::dvec3 between = seenAt(strip.world(bars, 0), 30);
    EXPECT_GT(bar.x, 1.5 * between.x) << "a bar of the threshold";
    EXPECT_GT(bar.z, 2 * between.z);
  }
  const glm::dvec3 board = seenAt(strip.world(50, strip.halfWidth), 30);
  const glm::dvec3 besideIt = seenAt(strip.world(60, strip.halfWidth - 3), 30);
  EXPECT_GT(board.z, 2 * besideIt.z);
  EXPECT_GT(besideIt.y, 1.2 * besideIt.x) << "turf is greener than the meadow around it";
  // Marks do not grow over the land when a pixel is wider than they are.
  const glm::dvec3 fromAbove = seenAt(strip.world(0, 0), 1500);
  EXPECT_LT(fromAbove.x, fromAbove.y);
}

TEST_F(GrassStripGLTest, landWithoutStripsHasNothingOfIt) {
  begin({"strips.density=0"});
  EXPECT_EQ(simulation_->ground()->strips(), nullptr);
  seenAt({0, 0}, 300);
  EXPECT_FALSE(anyShaderKnowsOfStrips());
}

TEST_F(GrassStripGLTest, bothVariantsAreCompiledWithTheFirstFrameOfAFlight) {
  // A picture alone, far from strips, has none of it.
  begin();
  seenAt(strip().middle + glm::dvec2(3000, 0), 100);
  EXPECT_FALSE(anyShaderKnowsOfStrips());
  sceneRenderer_.reset();
  begin({}, true);
  seenAt(strip().middle + glm::dvec2(3000, 0), 100);
  EXPECT_TRUE(anyShaderKnowsOfStrips()) << "or a frame would wait for it when the strip comes into view";
}

}  // namespace
}  // namespace skydrop::app
