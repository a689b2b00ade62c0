// The shadows of mountains in frames: against geometry, on models, when they are left out, and what they
// cost.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "skydrop/render/frame/fullscreen_triangle.h"
#include "skydrop/render/frame/sky_light.h"
#include "skydrop/render/shadows/land_shadow_pass.h"
#include "skydrop/render/terrain/terrain_pass.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "skydrop/terrain/endless_terrain.h"
#include "support/frame_test.h"
#include "support/hills_source.h"
#include "support/light_probe.h"
#include "support/paths.h"

namespace skydrop::render {
namespace {

constexpr double kCrestM = 1500, kFootM = 1000;  // snow: no trees

// Keeps what models would be lit by at a place, and what land is, as the GPU filters it, on a row of places.
class ShareProbe final : public Pass {
 public:
  ShareProbe(gl::Context& context, const glm::dvec3& place, double& share)
      : triangle_(context), place_(place), share_(share) {}
  std::string_view name() const override { return "shares"; }
  RenderStage stage() const override { return RenderStage::weatherEffects; }
  void draw(FrameContext& context) override {
    share_ = lightAt(context.resources, place_).sun;
    const auto* map = context.resources.find<LandShadowMap>();
    if (!map) return;
    gl::Shader& shader =
        context.shaders.shader("fullscreen.vert", test::sourceDir() + "/tests/gl/shaders/land_shade.frag");
    shader.use();
    const View& view = context.frame.view;
    shader.setVec3("corner", relativeToEye(view, {0, 0, 0}));
    shader.setFloat("spacing", 4);
    map->bind(shader, {view.position.x, view.position.z});
    context.gl.api().Disable(GL_DEPTH_TEST);
    triangle_.draw();
  }

 private:
  FullscreenTriangle triangle_;
  glm::dvec3 place_;
  double& share_;
};

class LandShadowsGLTest : public test::FrameTest {
 protected:
  void SetUp() override {
    FrameTest::SetUp();
    if (IsSkipped()) return;
    renderer().add(std::make_unique<test::LightProbe>(light_));
    features_ = {.haze = false, .landShadows = true};
    settings_.sun = {10, 90};
  }
  void build(std::shared_ptr<const terrain::HeightSource> source) {
    source_ = std::move(source);
    land_ = std::make_unique<terrain::EndlessTerrain>(source_, pool_, terrain::TerrainStreamingSettings{});
    auto land = std::make_unique<TerrainPass>(context());
    landPass_ = land.get();
    renderer().add(std::move(land));
    auto shadows = std::make_unique<LandShadowPass>(source_, LandShadowSettings{LandShadowDetail::coarse});
    shadows_ = shadows.get();
    renderer().add(std::move(shadows));
  }
  std::vector<glm::vec4> lightOf(const View& view) {
    landPass_->take(land_->settle(viewVolume(view)));
    draw(view);
    return light_;
  }
  std::string whySkipped(const View& view) {
    FrameInput input = gameFrame(snapshot_, view, features_);
    input.toSun = directionToSun(settings_.sun);
    return shadows_->skipReason(input).value_or("");
  }
  core::PassStatistics statisticsOf(std::string_view pass) {
    core::FrameStatistics statistics;
    renderer().fillStatistics(statistics);
    for (const auto& [name, row] : statistics.passes) {
      if (name == pass) return row;
    }
    return {};
  }

  std::shared_ptr<const terrain::HeightSource> source_;
  core::JobPool pool_{2};
  std::unique_ptr<terrain::EndlessTerrain> land_;
  TerrainPass* landPass_ = nullptr;
  LandShadowPass* shadows_ = nullptr;
  std::vector<glm::vec4> light_;
};

TEST_F(LandShadowsGLTest, theShadowOfARidgeEndsWhereTheSunsRayMeetsTheGround) {
  // The sun stands east of a ridge along z, 500 m over the plain: seen from above, the plain is dark from the
  // ridge to 500 m / tan(elevation) behind its crest, and as bright as ever beyond. The edge, where the
  // middle of the disc is hidden, is within a texel (32 m).
  build(terrain::makeRidgeSource(0, kCrestM, 3, kFootM));
  for (const double elevation : {10.0, 20.0}) {
    settings_.sun = {elevation, 90};
    const double end = (kCrestM - kFootM) / std::tan(glm::radians(elevation));
    const View view = pose({-end, kFootM + 700, 40}, 0, -90, 0, 128, 128);
    const std::vector<glm::vec4> shaded = lightOf(view);
    EXPECT_EQ(statisticsOf("landShadows").skipped, "");
    settings_.sun = {elevation, 270};  // the same light on level land, but from the other side
    const std::vector<glm::vec4> lit = lightOf(view);
    // Share of each of the columns of places with the same way from the crest.
    std::vector<double> ratio(200, 0), count(200, 0);
    for (int y = 0; y < 128; ++y) {
      for (int x = 0; x < 128; ++x) {
        const glm::dvec3 ray = rayDirection(view, {x + 0.5, y + 0.5});
        const double beyond = -(view.position.x + ray.x * (-700 / ray.y)) - end;
        const auto bin = static_cast<std::size_t>(std::clamp(beyond / 10 + 100, 0.0, 199.0));
        const auto i = static_cast<std::size_t>(y * 128 + x);
        ratio[bin] += static_cast<double>(shaded[i].y / lit[i].y);
        ++count[bin];
      }
    }
    // The shadow's area over its width: bumps of the land, which the two suns light from either side, cancel.
    const auto meanOf = [&](std::size_t from, std::size_t to) {
      double sum = 0, n = 0;
      for (std::size_t bin = from; bin < to; ++bin) sum += ratio[bin], n += count[bin];
      return sum / n;
    };
    const double darkest = meanOf(70, 85), brightest = meanOf(115, 130);
    double edge = 300;
    for (std::size_t bin = 70; bin < 130; ++bin)
      edge -= 10 * (ratio[bin] / count[bin] - darkest) / (brightest - darkest);
    EXPECT_LT(darkest, 0.6) << "the sky alone";
    EXPECT_NEAR(brightest, 1, 0.02);
    EXPECT_LE(std::abs(edge), 32) << elevation;
  }
}

TEST_F(LandShadowsGLTest, theGpuFiltersTheShadeThatTheProcessorHas) {
  // Along 64 places in steps of 4 m across the end of a ridge's shadow: the shader's share on the plain is
  // that of the same place on the processor within what filtering of the clearance allows (a texel of the
  // edge).
  build(terrain::makeRidgeSource(1088, kCrestM, 3, kFootM));
  double unused = 0;
  renderer().add(std::make_unique<ShareProbe>(context(), glm::dvec3(0), unused));
  settings_.sun = {27.3, 90};  // 500 m of ridge hide the sun from x = 119 on
  const View view = pose({30, kFootM + 500, 40}, 0, -90, 0, 64, 36);
  const std::vector<glm::vec4> shares = lightOf(view);
  double crossing = 0;
  for (int x = 1; x < 64; ++x) {
    const double share = static_cast<double>(shares[static_cast<std::size_t>(x)].x);
    EXPECT_TRUE(share >= 0 && share <= 1) << share;
    EXPECT_LE(share, static_cast<double>(shares[static_cast<std::size_t>(x - 1)].x) + 1e-3) << x;
    if (crossing == 0 && share < 0.5) crossing = 4 * x;
  }
  EXPECT_EQ(shares[0].x, 1);
  EXPECT_EQ(shares[63].x, 0);
  EXPECT_NEAR(crossing, 1088 - 500 / std::tan(glm::radians(27.3)), 32);
}

TEST_F(LandShadowsGLTest, whatFliesIsInTheShadeOfTheRidge) {
  // A place behind the ridge, below and above the shadow's upper edge, and before it.
  const double edge = kCrestM - 1500 * std::tan(glm::radians(10.0));
  build(terrain::makeRidgeSource(0, kCrestM, 3, kFootM));
  const View view = pose({-1500, edge + 300, 0}, 270, -30, 0, 64, 36);
  for (const auto& [place, share] :
       {std::pair(glm::dvec3(-1500, edge - 30, 0), 0.0), std::pair(glm::dvec3(-1500, edge + 30, 0), 1.0),
        std::pair(glm::dvec3(1500, kFootM + 2, 0), 1.0), std::pair(glm::dvec3(-1500, edge, 0), 0.5)}) {
    double seen = -1;
    renderer().setGroup({"probe"});
    renderer().add(std::make_unique<ShareProbe>(context(), place, seen));
    renderer().setGroup({});
    lightOf(view);
    EXPECT_NEAR(seen, share, share == 0.5 ? 0.1 : 1e-6) << place.y - edge;
    renderer().removeGroup("probe");
  }
}

TEST_F(LandShadowsGLTest, nothingIsDoneWhereNoLandCanBeShaded) {
  // Each reason, and that such a frame has neither the texture nor the programs of one with shadows.
  build(terrain::makeRidgeSource(0, kCrestM, 0.5, kFootM));  // slopes of 27 degrees
  const View view = pose({-1500, kFootM + 400, 0}, 90, -30, 0, 64, 36);
  settings_.sun = {-0.3, 90};
  EXPECT_EQ(whySkipped(view), "the sun is below the horizon");
  settings_.sun = {30, 90};
  EXPECT_EQ(whySkipped(view), "the sun stands above every slope");
  const auto textures = [&] { return context().resources().live(gl::ObjectKind::texture); };
  const auto programs = [&] { return context().resources().live(gl::ObjectKind::program); };
  lightOf(view);
  const auto idleTextures = textures(), idlePrograms = programs();
  const auto idleDraws = statisticsOf("terrain").draws;
  settings_.sun = {20, 90};
  EXPECT_EQ(whySkipped(view), "");
  lightOf(view);
  EXPECT_EQ(textures(), idleTextures + 1);
  EXPECT_EQ(programs(), idlePrograms + 2);  // other ones of land and sea
  EXPECT_EQ(statisticsOf("terrain").draws, idleDraws);
  EXPECT_EQ(whySkipped(pose({-1500, 3000, 0}, 90, 40, 0, 64, 36)), "no shaded land is in view");
  LandShadowPass plain(terrain::makeFlatSource(100), {});
  FrameInput input = gameFrame(snapshot_, view, features_);
  input.toSun = directionToSun({2, 90});
  EXPECT_EQ(plain.skipReason(input), "no land rises above other land");
}

TEST_F(LandShadowsGLTest, aFrameThatFollowsDoesNotWait) {
  // It says so until the shade is there, and then keeps it for a sun that has hardly moved.
  build(test::makeHillsSource());
  const View view = pose({0, 900, 0}, 90, -30, 0, 64, 36);
  FrameInput input = gameFrame(snapshot_, view, features_);
  input.followsLast = true;
  input.toSun = directionToSun({5, 90});
  EXPECT_EQ(shadows_->skipReason(input), "the shade is being worked out");
  while (shadows_->skipReason(input)) std::this_thread::yield();
  const terrain::LandShade* first = shadows_->shade();
  input.toSun = directionToSun({5.02, 90});
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(shadows_->skipReason(input));
  EXPECT_EQ(shadows_->shade(), first);
  input.toSun = directionToSun({5.2, 90});
  while (shadows_->shade() == first) shadows_->skipReason(input);
  EXPECT_EQ(shadows_->shade()->key().toSun, input.toSun);
  input.followsLast = false;  // waits for its own
  input.toSun = directionToSun({5.201, 90});
  shadows_->skipReason(input);
  EXPECT_EQ(shadows_->shade()->key().toSun, input.toSun);
}

TEST_F(LandShadowsGLTest, eachStepOfDetailChangesThePicture) {
  build(test::makeHillsSource());
  settings_.sun = {6, 200};
  const View view = pose({0, 1200, 0}, 90, -40, 0, 128, 72);
  std::vector<std::vector<glm::vec4>> pictures;
  for (const auto detail : {LandShadowDetail::coarse, LandShadowDetail::medium, LandShadowDetail::fine,
                            LandShadowDetail::finest}) {
    shadows_->apply({detail});
    pictures.push_back(lightOf(view));
  }
  EXPECT_NE(pictures[0], pictures[1]);
  EXPECT_NE(pictures[1], pictures[2]);
  EXPECT_NE(pictures[2], pictures[3]);
}

}  // namespace
}  // namespace skydrop::render
