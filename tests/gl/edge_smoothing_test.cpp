// Edges of what is drawn with one sample a pixel (render.picture.smoothEdges).
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "app/measure/bill.h"
#include "skydrop/core/assets.h"
#include "skydrop/core/shared.h"
#include "skydrop/render/edges/edge_smoothing_pass.h"
#include "skydrop/render/frame/land_ground.h"
#include "skydrop/render/frame/tone_map_pass.h"
#include "skydrop/render/models/aircraft_pass.h"
#include "support/frame_test.h"
#include "support/light_probe.h"
#include "support/margin.h"
#include "support/scene_gl_test.h"

namespace skydrop::render {
namespace {

namespace shared = core::shared::f64;

// Whether the near side covers the centre of a pixel.
using Shape = std::function<bool(double x, double y)>;

// A land of one distance, as a shape says, before an empty sky. Both have a light each.
class ShapePass final : public Pass, public LandGround {
 public:
  explicit ShapePass(const Shape& shape) : shape_(shape) {}
  std::string_view name() const override { return "shape"; }
  RenderStage stage() const override { return RenderStage::terrain; }
  void draw(FrameContext& context) override {
    const gl::Functions& api = context.gl.api();
    const int width = context.frame.view.width, height = context.frame.view.height;
    const auto clear = [&](int x, int y, int count, float light, float depth) {
      api.Scissor(x, y, count, 1);
      api.ClearColor(light, light, light, 1);
      api.ClearDepthf(depth);
      api.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    };
    api.Enable(GL_SCISSOR_TEST);
    api.DepthMask(GL_TRUE);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width;) {
        const bool covers = shape_(x + 0.5, y + 0.5);
        int end = x;
        while (end < width && shape_(end + 0.5, y + 0.5) == covers) ++end;
        clear(x, y, end - x, covers ? nearLight : farLight, covers ? 0.001f : 0.0f);
        x = end;
      }
    }
    api.Disable(GL_SCISSOR_TEST);
    context.resources.publish<LandGround>(*this);
  }
  void setGround(gl::ShaderProgram&, const View&) const override {}
  void setSurface(gl::ShaderProgram&, const View&) const override {}
  glm::dvec2 base() const override { return {}; }
  bool hasAlpineBelts() const override { return false; }

  float nearLight = 0.05f, farLight = 2;

 private:
  const Shape& shape_;
};

class EdgeSmoothingGLTest : public test::FrameTest {
 protected:
  void SetUp() override {
    FrameTest::SetUp();
    if (IsSkipped()) return;
    auto land = std::make_unique<ShapePass>(shape_);
    land_ = land.get();
    renderer().add(std::move(land));
    renderer().add(std::make_unique<EdgeSmoothingPass>());
    renderer().add(std::make_unique<test::LightProbe>(light_));
    renderer().add(std::make_unique<ToneMapPass>(context()));
    features_ = {};
  }
  // How much of the far side each pixel shows, bottom row first.
  std::vector<double> shares(int width, int height) {
    draw(pose({0, 100, 0}, 0, 0, 0, width, height));
    const auto shown = [](double light) { return shared::toneMap(shared::Vec3(light)).y; };
    const double nearest = shown(static_cast<double>(land_->nearLight));
    const double farthest = shown(static_cast<double>(land_->farLight));
    std::vector<double> all;
    for (const glm::vec4& pixel : light_)
      all.push_back((shown(static_cast<double>(pixel.y)) - nearest) / (farthest - nearest));
    return all;
  }
  // Of a pixel, by 64 x 64 points.
  double trueShare(int x, int y) const {
    int far = 0;
    for (int i = 0; i < 64 * 64; ++i) far += shape_(x + (i % 64 + 0.5) / 64, y + (i / 64 + 0.5) / 64) ? 0 : 1;
    return far / (64.0 * 64.0);
  }
  struct Errors {
    double rmse = 0, largest = 0, unsmoothed = 0;
  };
  // Of the pixels that an edge goes through, but for those nearer to the picture's border than its steps are
  // long: how a step goes on beyond it nobody knows.
  Errors errors(int width, int height, int border = 2) {
    const std::vector<double> shown = shares(width, height);
    Errors errors;
    double count = 0;
    for (int y = border; y < height - border; ++y) {
      for (int x = border; x < width - border; ++x) {
        const double expected = trueShare(x, y);
        const double is = shown[static_cast<std::size_t>(y * width + x)];
        const double hard = shape_(x + 0.5, y + 0.5) ? 0 : 1;
        if (expected == hard) {
          EXPECT_NEAR(is, hard, 0.26) << x << ", " << y;
          continue;
        }
        ++count;
        errors.rmse += (is - expected) * (is - expected);
        errors.unsmoothed += (hard - expected) * (hard - expected);
        errors.largest = std::max(errors.largest, std::abs(is - expected));
      }
    }
    errors.rmse = std::sqrt(errors.rmse / count), errors.unsmoothed = std::sqrt(errors.unsmoothed / count);
    return errors;
  }

  Shape shape_;
  ShapePass* land_ = nullptr;
  std::vector<glm::vec4> light_;
};

TEST_F(EdgeSmoothingGLTest, aStraightEdgeShowsWhatItCovers) {
  // In any direction, near enough to level for steps of up to 40 pixels: a quarter of the error of one
  // sample, and no pixel that is wrong by more than a fifth.
  for (const double slope : {0.025, 0.04, 0.11, 0.24, 0.37}) {
    for (const bool upright : {false, true}) {
      for (const double sign : {-1.0, 1.0}) {
        shape_ = [=](double x, double y) {
          const double along = upright ? y : x, across = upright ? x : y;
          return across < 90.3 + sign * slope * (along - 60);
        };
        const Errors e = errors(190, 180, static_cast<int>(1 / slope) + 2);
        EXPECT_LT(e.rmse, 0.27 * e.unsmoothed) << slope << (upright ? " upright" : " level");
        EXPECT_LT(e.largest, 0.2) << slope << (upright ? " upright" : " level");
      }
    }
  }
}

TEST_F(EdgeSmoothingGLTest, aSteepOrRoundEdgeIsBetterThanWithout) {
  shape_ = [](double x, double y) { return y < 40.3 + 0.83 * (x - 60); };
  Errors e = errors(130, 90);
  EXPECT_LT(e.rmse, 0.7 * e.unsmoothed) << "slope .83";
  shape_ = [](double x, double y) { return std::hypot(x - 64.2, y - 44.7) < 31.4; };
  e = errors(130, 90);
  EXPECT_LT(e.rmse, 0.6 * e.unsmoothed) << "a disc";
}

TEST_F(EdgeSmoothingGLTest, nothingChangesAwayFromEdges) {
  // Nor beside a straight one that lies between two rows, nor at a corner but in its pixels.
  shape_ = [](double, double y) { return y < 40; };
  std::vector<double> shown = shares(130, 90);
  for (std::size_t i = 0; i < shown.size(); ++i) ASSERT_NEAR(shown[i], i / 130 < 40 ? 0 : 1, 1e-3) << i;
  shape_ = [](double x, double y) { return y < 40.3 + 0.11 * (x - 60); };
  shown = shares(130, 90);
  for (int y = 0; y < 90; ++y) {
    for (int x = 0; x < 130; ++x) {
      const double fromEdge = std::abs(y + 0.5 - 40.3 - 0.11 * (x + 0.5 - 60));
      const double hard = shape_(x + 0.5, y + 0.5) ? 0 : 1;
      if (fromEdge < 1.1) continue;
      ASSERT_NEAR(shown[static_cast<std::size_t>(y * 130 + x)], hard, 1e-3) << x << ", " << y;
    }
  }
}

TEST_F(EdgeSmoothingGLTest, E01_lightOf65504BesideNone) {
  // The sun's disc beside a black hill: what is between is what the screen shows between the two.
  land_->nearLight = 0, land_->farLight = 65504;
  shape_ = [](double x, double y) { return y < 40.3 + 0.11 * (x - 60); };
  draw(pose({0, 100, 0}, 0, 0, 0, 130, 90));
  for (const glm::vec4& pixel : light_) {
    for (int c = 0; c < 3; ++c) ASSERT_TRUE(pixel[c] >= 0 && pixel[c] <= 65504) << pixel[c];
  }
  const Errors e = errors(130, 90, 12);
  EXPECT_TRUE(test::holds("E01", e.rmse, test::below(0.27 * e.unsmoothed), "of the step between the two"));
}

TEST_F(EdgeSmoothingGLTest, E02_picturesOfAnyWidthAreSmoothedToTheirBorders) {
  // Widths beside multiples of a word, and one of a pixel: every pixel of the edge, and no other.
  test::noFaults("E02", "pixels");
  shape_ = [](double x, double y) { return y < 20.3 + 0.2 * (x - 16); };
  for (const int width : {1, 31, 32, 33, 64, 95}) {
    const std::vector<double> shown = shares(width, 45);
    ASSERT_EQ(shown.size(), static_cast<std::size_t>(width) * 45);
    for (const double share : shown) ASSERT_TRUE(share > -1e-3 && share < 1 + 1e-3) << width;
    if (width < 31) continue;
    int between = 0;
    for (const double share : shown) between += share > 0.01 && share < 0.99 ? 1 : 0;
    EXPECT_GE(between, width / 2) << width;
  }
}

TEST_F(EdgeSmoothingGLTest, E03_anEdgeThatCreepsDoesNotCrawl) {
  // By a sixteenth of a pixel a frame, steeper and less steep: no pixel changes by four tenths of the
  // step between the two sides; with one sample a pixel it changes by all of it.
  for (const double slope : {0.03, 0.11, 0.37}) {
    std::vector<double> before;
    double largest = 0;
    const int border = static_cast<int>(1 / slope) + 2;
    for (int frame = 0; frame <= 16; ++frame) {
      shape_ = [=](double x, double y) { return y < 60.2 + frame / 16.0 + slope * (x - 60); };
      const std::vector<double> shown = shares(190, 120);
      for (int y = 2; y < 118 && !before.empty(); ++y) {
        for (int x = border; x < 190 - border; ++x) {
          const auto i = static_cast<std::size_t>(y * 190 + x);
          largest = std::max(largest, std::abs(shown[i] - before[i]));
        }
      }
      before = shown;
    }
    EXPECT_TRUE(test::holds("E03", largest, test::below(0.4), "of the step between the two")) << slope;
  }
}

TEST_F(EdgeSmoothingGLTest, modelsKeepTheirFourSamples) {
  // An aircraft 30 m ahead of land without edges: smoothed or not the picture is the same. Drawn with one
  // sample it has edges like the land's.
  const auto model = std::make_shared<const Model>(
      context(), importModel(core::assetPath("models/airplane.glb")), "airplane");
  const auto lightOf = [&](bool smoothModels, bool smoothEdges) {
    std::vector<glm::vec4> light;
    Renderer renderer(context(), settings_, false);
    renderer.setLayer(std::make_unique<ModelLayer>());
    renderer.add(std::make_unique<ShapePass>(shape_));
    renderer.add(std::make_unique<AircraftPass>(model));
    if (smoothEdges) renderer.add(std::make_unique<EdgeSmoothingPass>());
    renderer.add(std::make_unique<test::LightProbe>(light));
    RenderSettings settings = settings_;
    settings.smoothModels = smoothModels;
    renderer.apply(settings);
    renderer.draw(gameFrame(snapshot_, pose({0, 100, 0}, 0, 0, 0), features_));
    return light;
  };
  shape_ = [](double, double) { return true; };
  snapshot_.aircraft.present = true;
  snapshot_.aircraft.position = {30, 98, 0};
  EXPECT_EQ(lightOf(true, true), lightOf(true, false));
  EXPECT_NE(lightOf(false, true), lightOf(false, false));
}

class EdgesOfSceneGLTest : public test::SceneGLTest {
 protected:
  core::Image draw() {
    sceneRenderer_->draw(simulation_->world().now(), {160, 90}, app::Streaming::settled);
    return sceneRenderer_->renderer().readBack();
  }
  std::uint64_t bytes() { return context().resources().ownedBy("edges").bytes; }
  std::string skipped() {
    core::FrameStatistics statistics;
    sceneRenderer_->writeTo(statistics);
    for (const auto& [name, row] : statistics.passes) {
      if (name == "edges") return row.skipped;
    }
    return "not there";
  }
};

TEST_F(EdgesOfSceneGLTest, switchedOffNothingOfItIsThere) {
  beginScene(lineOf("terrain", {"view.hud=false", "render.picture.smoothEdges=false"}));
  const core::Image without = draw();
  EXPECT_EQ(skipped(), "not there");
  EXPECT_EQ(context().resources().ownedBy("edges").objects, 0);
  set("render.picture.smoothEdges=true");
  const core::Image with = draw();
  EXPECT_EQ(skipped(), "");
  EXPECT_GT(bytes(), 0u);
  EXPECT_NE(with.rgba, without.rgba);
  set("render.picture.smoothEdges=false");
  EXPECT_EQ(draw().rgba, without.rgba);
  EXPECT_EQ(bytes(), 0u);
  set("render.picture.smoothEdges=true");
  EXPECT_EQ(draw().rgba, with.rgba);
}

TEST_F(EdgesOfSceneGLTest, withoutLandItDoesNothing) {
  beginScene(lineOf("terrain", {"view.hud=false", "effects.terrain=false", "effects.targets=false"}));
  draw();
  EXPECT_EQ(skipped(), "no land has been drawn");
  EXPECT_EQ(context().resources().ownedBy("edges").objects, 0);
}

TEST_F(EdgesOfSceneGLTest, itIsPaidForByTheFrame) {
  beginScene(lineOf("terrain", {"view.hud=false"}));
  draw();
  core::FrameStatistics statistics;
  sceneRenderer_->writeTo(statistics);
  const auto row = std::ranges::find(statistics.bill, app::kFrameRow, &core::EffectStatistics::name);
  ASSERT_NE(row, statistics.bill.end());
  EXPECT_GE(static_cast<std::uint64_t>(row->gpuBytes), bytes());
  EXPECT_GE(row->dispatches, 5);
}

}  // namespace
}  // namespace skydrop::render
