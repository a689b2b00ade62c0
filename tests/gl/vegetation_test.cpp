// Trees in frames: those of the CPU, on the land that is drawn, without pops, bent by the wind.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "render/vegetation/tree_meshes.h"
#include "skydrop/core/hash.h"
#include "skydrop/render/terrain/terrain_pass.h"
#include "skydrop/render/vegetation/vegetation_pass.h"
#include "support/margin.h"
#include "support/row_steps.h"
#include "support/scene_gl_test.h"

namespace skydrop::app {
namespace {

constexpr Size kSize{192, 108};
constexpr double kDegree = std::numbers::pi / 180;

class VegetationGLTest : public test::SceneGLTest {
 protected:
  void begin(std::vector<std::string> set = {}) {
    beginScene(
        lineOf("woodland", {"effects.clouds=false", "effects.targets=false", "effects.hud=false"}, set), 1);
    snapshot_ = simulation_->world().now();
    snapshot_.aircraft.present = false;
    sceneRenderer_->camera().setMode(render::CameraMode::free);
  }

  // So high above the land at a place; yaw 0 looks along +x.
  void look(const glm::dvec2& at, double above, double yawDeg, double pitchDeg) {
    const double ground = simulation_->ground()->height(at);
    sceneRenderer_->camera().setPose({at.x, ground + above, at.y}, yawDeg * kDegree, pitchDeg * kDegree, 0);
  }
  core::Image frame() {
    sceneRenderer_->draw(snapshot_, kSize, Streaming::settled);
    return sceneRenderer_->renderer().readBack();
  }
  // Of the land alone, reversed, the lowest row first.
  std::vector<float> depthsOfLand() {
    const render::gl::Texture& depth = sceneRenderer_->renderer().find<render::TerrainPass>()->landDepth();
    std::vector<float> values(static_cast<std::size_t>(depth.width()) *
                              static_cast<std::size_t>(depth.height()));
    depth.read(GL_DEPTH_COMPONENT, GL_FLOAT, std::as_writable_bytes(std::span(values)));
    return values;
  }
  const render::VegetationPass& pass() { return *sceneRenderer_->renderer().find<render::VegetationPass>(); }
  terrain::Woods woods() const { return {simulation_->ground(), run_->settings.woods.density, false}; }

  static double meanDifference(const core::Image& a, const core::Image& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i)
      sum += std::abs(static_cast<int>(a.rgba[i]) - static_cast<int>(b.rgba[i]));
    return sum / static_cast<double>(a.rgba.size());
  }

  game::Snapshot snapshot_;
};

constexpr glm::dvec2 kWood(-1600, -3300), kFarWood(1e7 + 400, -1e7 - 3600);

TEST_F(VegetationGLTest, V02_whatIsDrawnIsWhatIsFlownInto) {
  // Trees of a frame within 100 m are trees of the CPU: foot within 5 cm (a float beside the eye) and size
  // within 1.5 m for all but 2 % of them, which stand at the edge of woods where the stored normals round.
  // Near the origin and 1e7 m out.
  begin();
  for (const glm::dvec2& at : {kWood, glm::dvec2(-2400, -1600), kFarWood}) {
    look(at, 60, 30, -60);
    frame();
    const glm::dvec3 eye = sceneRenderer_->view(snapshot_, kSize).position;
    const std::vector<terrain::StandingTree> expected = woods().around(at, 130);
    int seen = 0, apart = 0;
    double farthest = 0;
    for (int list = 0; list < 3; ++list) {
      for (const glm::vec4& foot : pass().feet(list)) {
        const glm::dvec3 place = eye + glm::dvec3(foot);
        if (glm::length(glm::dvec2(foot.x, foot.z)) > 100) continue;
        ++seen;
        const auto nearest = std::ranges::min_element(expected, {}, [&](const terrain::StandingTree& t) {
          return glm::length(glm::dvec2(t.foot.x - place.x, t.foot.z - place.z));
        });
        if (nearest == expected.end()) {
          ++apart;
          continue;
        }
        const double away = glm::length(glm::dvec2(nearest->foot.x - place.x, nearest->foot.z - place.z));
        const bool isSame = away < 0.05 && std::abs(nearest->shape.heightM - foot.w) < 1.5;
        if (isSame) farthest = std::max(farthest, std::abs(nearest->foot.y - place.y));
        apart += !isSame;
      }
    }
    EXPECT_GT(seen, at == kFarWood ? -1 : 30);
    EXPECT_LE(apart, 0.02 * seen + 1) << seen;
    EXPECT_TRUE(test::holds("V02", farthest, test::below(0.5), "m"));  // feet against the land
    std::printf("[ woods ] %d trees, %d apart, feet within %.3f m\n", seen, apart, farthest);
  }
}

TEST_F(VegetationGLTest, snowLiesOnTreesWhereItLiesOnTheLand) {
  // A wood from above in snowfall, and in the rain that falls from the same clouds 14 degrees warmer. Pixels
  // that trees darken by a fifth of snowed land send back two to six times as much green light as in the
  // rain: branches hide under half of the snow that open land has (albedo .77 against about .05).
  const auto lightOf = [&](const char* temperature, const char* density) {
    beginScene(lineOf("snowfall", {"effects.hud=false", "effects.targets=false", "effects.clouds=false",
                                   std::string("weather.sites.0.temperature=") + temperature,
                                   std::string("woods.density=") + density}),
               1);
    snapshot_ = simulation_->world().now();
    sceneRenderer_->camera().setMode(render::CameraMode::free);
    look(kWood, 70, 30, -75);
    frame();
    std::vector<glm::vec4> light(static_cast<std::size_t>(kSize.width) * kSize.height);
    sceneRenderer_->renderer().sceneColor().read(GL_RGBA, GL_FLOAT, std::as_writable_bytes(std::span(light)));
    return light;
  };
  const auto bare = lightOf("-2", "0"), snowed = lightOf("-2", "1"), wet = lightOf("12", "1");
  double withSnow = 0, inRain = 0;
  int crowns = 0;
  for (std::size_t i = 0; i < bare.size(); ++i) {
    if (snowed[i].y > 0.8f * bare[i].y) continue;
    withSnow += static_cast<double>(snowed[i].y), inRain += static_cast<double>(wet[i].y);
    ++crowns;
  }
  std::printf("[ snow ] %d pixels of crowns: %.3f with snow, %.3f in the rain\n", crowns, withSnow / crowns,
              inRain / crowns);
  EXPECT_GT(crowns, 1000);
  EXPECT_GT(withSnow, 2 * inRain);
  EXPECT_LT(withSnow, 6 * inRain);
}

TEST_F(VegetationGLTest, V03_feetStandOnTheLandThatIsDrawn) {
  // Seen straight down, each foot lies at the depth of the land at its pixel: within 0.5 m and what the slope
  // makes of a pixel, near by and where the land is drawn coarse; 30 degrees steep and 1e7 m out.
  begin({"vegetation.meshM=400"});
  struct Look {
    glm::dvec2 at;
    double above;
  };
  for (const Look& l :
       {Look{kWood, 80}, Look{kWood, 320}, Look{{1600, -2800}, 120}, Look{{1200, -2800}, 300}}) {
    look(l.at, l.above, 0, -89.9);
    frame();
    const render::View view = sceneRenderer_->view(snapshot_, kSize);
    const std::vector<float> depths = depthsOfLand();
    int seen = 0, off = 0;
    double worst = 0;
    for (int list = 0; list < 4; ++list) {
      for (const glm::vec4& foot : pass().feet(list)) {
        const glm::dvec3 inView = view.worldToView * glm::dvec3(foot);
        const double z = -inView.z, scale = 0.5 * kSize.height / std::tan(view.fovYRad / 2);
        const int x = static_cast<int>(std::floor(kSize.width / 2.0 + inView.x / z * scale));
        const int y = static_cast<int>(std::floor(kSize.height / 2.0 + inView.y / z * scale));
        if (z <= 0 || x < 1 || y < 1 || x >= kSize.width - 1 || y >= kSize.height - 1) continue;
        const float depth = depths[static_cast<std::size_t>(y * kSize.width + x)];
        if (depth <= 0) continue;
        const double land = view.nearM / static_cast<double>(depth), pixel = z / scale;
        ++seen;
        const double error = std::abs(land - z);
        worst = std::max(worst, error - pixel);
        off += error > 0.5 + pixel;
      }
    }
    EXPECT_GT(seen, 10);
    EXPECT_TRUE(test::holds("V03", static_cast<double>(off) / seen, test::atMost(0.02), "of the feet"))
        << off << " of " << seen << ", worst " << worst << " m beyond a pixel";
  }
}

TEST_F(VegetationGLTest, V04_formsTurnIntoEachOtherWithoutPops) {
  // At 70 m/s and 60 frames a second a tree comes 1.17 m nearer in a frame: the same picture with all borders
  // between meshes, impostors and painted woods moved by as much differs by at most 1/255 in the mean.
  begin();
  for (const double above : {20.0, 50.0, 150.0}) {
    look(kWood, above, 200, -12);
    set("vegetation.meshM=130"), set("vegetation.farM=1200");
    const core::Image before = frame();
    set("vegetation.meshM=131.17"), set("vegetation.farM=1201.17");
    const double change = meanDifference(before, frame());
    std::printf("[ blend ] %.0f m: %.4f / 255 a frame\n", above, change);
    EXPECT_TRUE(test::holds("V04", change, test::atMost(1), "of 255"));
    EXPECT_GT(change, 0) << "nothing turned";
  }
}

TEST(TreeMeshes, noCrownIsWiderThanItsImpostor) {
  // Impostors are drawn 1.12 times as wide as the crown (kCrownMargin of shaders/vegetation/impostor.glsl):
  // all vertices are within that, and a hundredth is left for the filter.
  for (const render::TreeMesh& mesh : render::makeTreeMeshes()) {
    for (const render::TreeVertex& vertex : mesh.vertices)
      ASSERT_LE(std::hypot(vertex.place.x, vertex.place.z), 1.11f);
  }
}

TEST_F(VegetationGLTest, formsLookAlike) {
  // A wood of meshes, of impostors and of both has the same light within 8 % of its mean.
  begin({"vegetation.shadow=0.5"});
  look(kWood, 110, 200, -35);
  const auto mean = [&](const char* mesh) {
    set(mesh);
    const core::Image image = frame();
    double sum = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) sum += image.rgba[i + 1];
    return sum / static_cast<double>(image.rgba.size() / 4);
  };
  const double meshes = mean("vegetation.meshM=400"), impostors = mean("vegetation.meshM=0");
  std::printf("[ forms ] meshes %.1f impostors %.1f\n", meshes, impostors);
  EXPECT_NEAR(impostors / meshes, 1, 0.08);
}

TEST_F(VegetationGLTest, windBendsTreesAndCalmDoesNot) {
  // In wind a later moment is another picture, and the same moment the same one; in calm nothing moves:
  // meshes, and impostors alone.
  begin({"render.land.detail=plain"});
  look(kWood, 30, 200, -20);
  const auto at = [&](double wind, double seconds) {
    snapshot_.wind = {wind, 0, 0};
    snapshot_.simulatedSeconds = seconds;
    return frame();
  };
  for (const char* meshes : {"vegetation.meshM=130", "vegetation.meshM=0"}) {
    set(meshes);
    EXPECT_GT(meanDifference(at(12, 1), at(12, 1.6)), 0.2) << meshes;
    EXPECT_EQ(meanDifference(at(12, 1), at(12, 1)), 0) << meshes;
    EXPECT_LT(meanDifference(at(0, 1), at(0, 1.6)), 0.02) << meshes;
  }
}

TEST_F(VegetationGLTest, V05_densityAndReachOfNothingLeaveNothing) {
  // Density 0, or no reach: no draw, with the reason. Full density draws.
  begin();
  look(kWood, 60, 200, -20);
  frame();
  const auto trees = [&] {
    const auto drawn = pass().drawn();
    return drawn[0] + drawn[1] + drawn[2] + drawn[3];
  };
  EXPECT_GT(trees(), 200u);
  const auto reason = [&] {
    frame();
    core::FrameStatistics statistics;
    sceneRenderer_->writeTo(statistics);
    for (const auto& [name, row] : statistics.passes)
      if (name == "vegetation") return row.skipped;
    return std::string("none");
  };
  EXPECT_EQ(reason(), "");
  set("woods.density=0");
  EXPECT_EQ(reason(), "no trees stand");
  set("woods.density=1"), set("vegetation.farM=0");
  EXPECT_EQ(reason(), "trees are painted alone");
  set("vegetation.farM=300");
  sceneRenderer_->camera().setPose({kWood.x, 9000, kWood.y}, 0, -1, 0);
  EXPECT_EQ(reason(), "the view is too high for single trees");
  test::noFaults("V05", "trees");
}

TEST_F(VegetationGLTest, everyTenthOfEveryRowMakesADifference) {
  begin();
  snapshot_.wind = {9, 0, 4};
  snapshot_.simulatedSeconds = 3.3;
  const int rows = test::expectNoIdleSteps(run_->table, {"vegetation."}, [&] {
    sceneRenderer_->apply(SettingsChange::ofAll(run_->table));
    core::StateHasher h;
    for (const double above : {12.0, 90.0}) {
      look(kWood, above, 200, -15);
      for (const auto byte : frame().rgba) h.add(std::uint64_t{byte});
    }
    return h.value();
  });
  EXPECT_EQ(rows, 7);
}

}  // namespace
}  // namespace skydrop::app
