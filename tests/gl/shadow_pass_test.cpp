// Shadows of aircraft and packages on level land, against where and how dark geometry wants them.
#include "skydrop/render/shadows/shadow_pass.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <optional>

#include "skydrop/core/assets.h"
#include "skydrop/render/frame/sky_light.h"
#include "skydrop/render/models/aircraft_pass.h"
#include "skydrop/render/models/package_pass.h"
#include "skydrop/render/terrain/terrain_pass.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "skydrop/terrain/endless_terrain.h"
#include "support/frame_test.h"
#include "support/light_probe.h"
#include "support/margin.h"

namespace skydrop::render {
namespace {

constexpr double kGroundM = 1300;  // snow: no trees, whose far sides the sun does not reach anyway

// What is hidden of the sun at each pixel of a frame, and where its piece of ground is.
struct Shadow {
  double area = 0;       // m^2 of ground times hidden share
  glm::dvec2 middle{0};  // x, z: mean place, weighted by the hidden share
  double deepest = 0;
  glm::dvec2 low{1e300}, high{-1e300};  // of what is more than half hidden
  std::vector<double> hidden;
};

class ShadowGLTest : public test::FrameTest {
 protected:
  void SetUp() override {
    FrameTest::SetUp();
    if (IsSkipped()) return;
    auto land = std::make_unique<TerrainPass>(context());
    landPass_ = land.get();
    auto shadows = std::make_unique<ShadowPass>();
    shadowPass_ = shadows.get();
    renderer().add(std::move(land));
    renderer().add(std::move(shadows));
    renderer().add(std::make_unique<test::LightProbe>(light_));
    ModelData data;
    data.nodes = {{"cover", -1, glm::mat4(1), {0}}};
    data.meshes = {{"cover", sphereMesh(kCoverM, 96, 48), 0}};
    data.materials = {{"plain", {}, {}}};
    cover_ = std::make_shared<const Model>(context(), data, "cover");
    this->shadows().add("box", [this](const FrameInput&, std::vector<ShadowCaster>& casters) {
      if (!coverAt_) return;
      const auto parts = [model = cover_, at = *coverAt_](const View& view, const DrawPart& draw) {
        draw(*model, bodyMatrix(view, at, glm::dquat(1, 0, 0, 0)), ModelPose(*model));
      };
      casters.push_back({*coverAt_, kCoverM, std::numbers::pi * kCoverM * kCoverM, parts});
    });
    features_ = {};
    settings_.sun = {35, 200};
  }

  ShadowPass& shadows() { return *shadowPass_; }
  void castBall(const glm::dvec3& middle, double radius) {
    ModelData data;
    data.nodes = {{"ball", -1, glm::mat4(1), {0}}};
    data.meshes = {{"ball", sphereMesh(radius, 96, 48), 0}};
    data.materials = {{"plain", {}, {}}};
    const auto model = std::make_shared<const Model>(context(), data, "ball");
    shadows().add("box", [=, this](const FrameInput&, std::vector<ShadowCaster>& casters) {
      if (!castsShadows_) return;
      const auto parts = [=](const View& view, const DrawPart& draw) {
        draw(*model, bodyMatrix(view, middle, glm::dquat(1, 0, 0, 0)), ModelPose(*model));
      };
      casters.push_back({middle, radius, std::numbers::pi * radius * radius, parts});
    });
  }
  std::vector<glm::vec4> lightOf(const View& view) {
    landPass_->take(land_.settle(viewVolume(view)));
    draw(view);
    return light_;
  }
  // Straight down from a height over the ground, 256 pixels a side.
  View above(const glm::dvec2& place, double heightM) const {
    return pose({place.x, kGroundM + heightM, place.y}, 0, -90, 0, 256, 256);
  }
  Shadow shadowIn(const View& view) {
    const std::vector<glm::vec4> shaded = lightOf(view);
    const game::Snapshot kept = snapshot_;
    snapshot_.aircraft.present = castsShadows_ = false;
    const std::vector<glm::vec4> lit = lightOf(view);
    // Once more with everything in the shadow of a large ball: what is left is the sky's light, pixel by
    // pixel, because the ground is rough.
    coverAt_ = glm::dvec3(view.position.x, kGroundM, view.position.z) + toSun() * 1500.0;
    const std::vector<glm::vec4> dark = lightOf(view);
    coverAt_.reset();
    snapshot_ = kept;
    castsShadows_ = true;
    const double pixelM = 2 * std::tan(view.fovYRad / 2) * (view.position.y - kGroundM) / view.height;
    Shadow shadow;
    for (int y = 0; y < view.height; ++y) {
      for (int x = 0; x < view.width; ++x) {
        const auto i = static_cast<std::size_t>(y * view.width + x);
        const double hidden = (static_cast<double>(lit[i].y) - static_cast<double>(shaded[i].y)) /
                              (static_cast<double>(lit[i].y) - static_cast<double>(dark[i].y));
        const glm::dvec3 ray = rayDirection(view, {x + 0.5, y + 0.5});
        const glm::dvec3 place = view.position + ray * ((kGroundM - view.position.y) / ray.y);
        shadow.hidden.push_back(hidden);
        shadow.area += hidden * pixelM * pixelM;
        shadow.middle += glm::dvec2(place.x, place.z) * hidden * pixelM * pixelM;
        shadow.deepest = std::max(shadow.deepest, hidden);
        if (hidden < 0.5) continue;
        shadow.low = glm::min(shadow.low, glm::dvec2(place.x, place.z));
        shadow.high = glm::max(shadow.high, glm::dvec2(place.x, place.z));
      }
    }
    shadow.middle /= shadow.area;
    return shadow;
  }
  std::string whySkipped() {
    core::FrameStatistics statistics;
    renderer().fillStatistics(statistics);
    for (const auto& [name, row] : statistics.passes) {
      if (name == "shadows") return row.skipped;
    }
    return "not there";
  }
  glm::dvec3 toSun() const { return directionToSun(settings_.sun); }

 private:
  std::shared_ptr<const terrain::HeightSource> source_ = terrain::makeFlatSource(kGroundM);
  core::JobPool pool_{2};
  terrain::EndlessTerrain land_{source_, pool_, {}};
  TerrainPass* landPass_ = nullptr;
  ShadowPass* shadowPass_ = nullptr;
  std::vector<glm::vec4> light_;
  bool castsShadows_ = true;
  static constexpr double kCoverM = 600;
  std::optional<glm::dvec3> coverAt_;
  std::shared_ptr<const Model> cover_;
};

TEST_F(ShadowGLTest, shadowLiesWhereTheSunsRayMeetsTheGround) {
  // Of a ball of 4 m, 60 m up: its middle is where the ray through the ball's middle ends (a tenth of the
  // blur of 0.9 m), and it hides the sun from as much ground as the ball's disc covers (1.5 %, texels and
  // taps).
  const glm::dvec3 ball(30, kGroundM + 60, -20);
  castBall(ball, 4);
  const glm::dvec3 end = ball - toSun() * (60 / toSun().y);
  const Shadow shadow = shadowIn(above({end.x + 3, end.z - 2}, 40));
  EXPECT_NEAR(shadow.middle.x, end.x, 0.09);
  EXPECT_NEAR(shadow.middle.y, end.z, 0.09);
  const double disc = std::numbers::pi * 16;
  EXPECT_NEAR(shadow.area, disc / toSun().y, 0.015 * disc / toSun().y);
  EXPECT_NEAR(shadow.deepest, 1, 0.01);
}

TEST_F(ShadowGLTest, smallThingHighUpHidesItsShareOfTheSunsDisc) {
  // A ball of 1 m, 600 m below the sun: it is seen inside the sun's disc, of which it covers (1 / 2.8)^2
  // = 12.8 %. Taps leave the middle and the outside 0.02 off; what is hidden in all is the ball's disc again
  // (4 %).
  settings_.sun = {90, 0};
  castBall({0, kGroundM + 600, 0}, 1);
  const Shadow shadow = shadowIn(above({0, 0}, 20));
  const double blur = 600 * std::tan(kSunRadiusRad);
  EXPECT_NEAR(shadow.hidden[128 * 256 + 128], 1 / (blur * blur), 0.02);
  EXPECT_LT(shadow.deepest, 1 / (blur * blur) + 0.03);
  EXPECT_NEAR(shadow.area, std::numbers::pi, 0.04 * std::numbers::pi);
}

TEST_F(ShadowGLTest, T02_shadowsFarOutAreThoseAtTheOrigin) {
  // At 1e9 m every pixel hides as much of the sun as at the origin, to a step of 8 bits (the ground's noise
  // differs).
  const glm::dvec3 far(std::ldexp(960.0, 20), 0, -std::ldexp(960.0, 20));
  castBall({0, kGroundM + 60, 0}, 4);
  castBall(glm::dvec3(0, kGroundM + 60, 0) + far, 4);
  const glm::dvec3 end = -toSun() * (60 / toSun().y);
  const Shadow here = shadowIn(above({end.x, end.z}, 40));
  const Shadow there = shadowIn(above({end.x + far.x, end.z + far.z}, 40));
  ASSERT_NEAR(here.deepest, 1, 0.01);
  double worst = 0;
  for (std::size_t i = 0; i < here.hidden.size(); ++i)
    worst = std::max(worst, std::abs(here.hidden[i] - there.hidden[i]));
  EXPECT_TRUE(test::holds("T02", worst, test::below(1.0 / 255), "share of the sun"));
}

TEST_F(ShadowGLTest, aircraftsShadowIsAsWideAsItsWings) {
  // At noon 8 m above the ground, heading north: 10.8 m of span from west to east and 8.3 m of length, half a
  // pixel's 0.2 m and the 0.07 m of blur to each side.
  const auto model = std::make_shared<const Model>(
      context(), importModel(core::assetPath("models/airplane.glb")), "airplane");
  shadows().add("aircraft", aircraftShadow(model));
  settings_.sun = {90, 0};
  snapshot_.aircraft.present = true;
  snapshot_.aircraft.position = {0, kGroundM + 8, 0};
  const Shadow shadow = shadowIn(above({0, 0}, 20));
  EXPECT_NEAR(shadow.high.x - shadow.low.x, 10.8, 0.3);
  EXPECT_NEAR(shadow.high.y - shadow.low.y, 8.0, 0.4);
}

TEST_F(ShadowGLTest, shadowsOfSeveralCastersAreMultiplied) {
  // Two balls on one ray of the sun hide no more than the one; a third beside them has its own shadow (5 %:
  // in the half shade at the edge the product is a little darker than either).
  castBall({0, kGroundM + 30, 0}, 3);
  castBall(glm::dvec3(0, kGroundM + 30, 0) + toSun() * 20.0, 3);
  castBall({9, kGroundM + 30, 0}, 3);
  const glm::dvec3 end = -toSun() * (30 / toSun().y);
  const Shadow shadow = shadowIn(above({end.x + 4, end.z}, 40));
  EXPECT_NEAR(shadow.deepest, 1, 0.01);
  EXPECT_NEAR(shadow.area, 2 * std::numbers::pi * 9 / toSun().y, 0.05 * 2 * std::numbers::pi * 9 / toSun().y);
}

TEST_F(ShadowGLTest, nothingIsDrawnOrKeptWhereNoShadowCanBeSeen) {
  // Without a caster, after sunset and with the shadow beside the picture the pass gives its reason, and no
  // map has been made.
  const View view = above({0, 0}, 40);
  lightOf(view);
  EXPECT_EQ(whySkipped(), "nothing that casts a shadow");
  castBall({0, kGroundM + 30, 0}, 3);
  settings_.sun.elevationDegrees = -0.5;
  lightOf(view);
  EXPECT_EQ(whySkipped(), "the sun is below the horizon");
  settings_.sun.elevationDegrees = 60;
  lightOf(above({500, 500}, 40));
  EXPECT_EQ(whySkipped(), "no shadow falls into view");
  const auto textures = [&] {
    core::FrameStatistics statistics;
    renderer().fillStatistics(statistics);
    return statistics.gl.textures;
  };
  const auto before = textures();
  lightOf(view);
  EXPECT_EQ(whySkipped(), "");
  EXPECT_EQ(textures(), before + 1);
}

TEST_F(ShadowGLTest, nearestCastersHaveTheMaps) {
  // Six balls in view, the two farthest listed first: four maps, and their shadows, of pixels of 2.3 m, add
  // up to the discs of the nearest four around the mean of their places.
  for (const double x : {200.0, 160.0, 60.0, 40.0, 20.0, 0.0}) castBall({x, kGroundM + 10, 0}, 3);
  settings_.sun = {90, 0};
  const Shadow shadow = shadowIn(above({10, 0}, 500));
  EXPECT_NEAR(shadow.area, 4 * std::numbers::pi * 9, 0.05 * 4 * std::numbers::pi * 9);
  EXPECT_NEAR(shadow.middle.x, 30, 0.5);
}

}  // namespace
}  // namespace skydrop::render
