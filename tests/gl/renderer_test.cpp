#include "skydrop/render/frame/renderer.h"

#include <gmock/gmock.h>

#include <cstring>

#include "skydrop/core/error.h"
#include "skydrop/render/frame/tone_map_pass.h"
#include "skydrop/render/overlay/imgui_pass.h"
#include "skydrop/render/sky/sky_pass.h"
#include "support/frame_test.h"
#include "support/image_compare.h"
#include "support/margin.h"
#include "support/plains_pass.h"

namespace skydrop::render {
namespace {

using test::FrameTest;

// Notes when it runs; draws nothing.
class NotingPass final : public Pass {
 public:
  NotingPass(std::string name, RenderStage stage, std::vector<std::string>& log, std::string idle = {})
      : name_(std::move(name)), stage_(stage), log_(log), idle_(std::move(idle)) {}
  std::string_view name() const override { return name_; }
  RenderStage stage() const override { return stage_; }
  std::optional<std::string> skipReason(const FrameInput&) const override {
    return idle_.empty() ? std::nullopt : std::optional(idle_);
  }
  void draw(FrameContext&) override { log_.push_back(name_); }

 private:
  std::string name_;
  RenderStage stage_;
  std::vector<std::string>& log_;
  std::string idle_;
};

TEST_F(FrameTest, passesRunByTheirSlots) {
  // However they were added; those that say why they have nothing to do are not asked, and the reason is
  // kept.
  std::vector<std::string> log;
  renderer().add(std::make_unique<NotingPass>("menu", RenderStage::menu, log));
  renderer().add(std::make_unique<NotingPass>("sky", RenderStage::sky, log));
  renderer().add(std::make_unique<NotingPass>("terrain", RenderStage::terrain, log));
  renderer().add(std::make_unique<NotingPass>("clouds", RenderStage::clouds, log, "no layer in view"));
  renderer().add(std::make_unique<NotingPass>("models", RenderStage::models, log));
  renderer().add(std::make_unique<NotingPass>("models2", RenderStage::models, log));
  draw(pose({0, 0, 0}, 0, 0, 0));
  EXPECT_THAT(log, ::testing::ElementsAre("terrain", "sky", "models", "models2", "menu"));
  core::FrameStatistics statistics;
  renderer().fillStatistics(statistics);
  ASSERT_EQ(statistics.passes.size(), 7u);  // with the layer that models are drawn into
  EXPECT_EQ(statistics.passes[4].first, "clouds");
  EXPECT_EQ(statistics.passes[4].second.skipped, "no layer in view");
  EXPECT_EQ(statistics.passes[0].second.skipped, "");
}

// Stands for what an earlier pass makes for later ones.
struct Footprint {
  int depth = 0;
};

class FootprintPass final : public Pass {
 public:
  explicit FootprintPass(const bool& idle) : idle_(idle) {}
  std::string_view name() const override { return "footprint"; }
  RenderStage stage() const override { return RenderStage::shadows; }
  std::optional<std::string> skipReason(const FrameInput&) const override {
    return idle_ ? std::optional<std::string>("idle") : std::nullopt;
  }
  void draw(FrameContext& context) override {
    ++footprint_.depth;
    context.resources.publish(footprint_);
  }

 private:
  const bool& idle_;
  Footprint footprint_;
};

// Notes the depth of the frame's footprint, -1 without one.
class FootprintReader final : public Pass {
 public:
  FootprintReader(RenderStage stage, std::vector<int>& depths) : stage_(stage), depths_(depths) {}
  std::string_view name() const override { return "reader"; }
  RenderStage stage() const override { return stage_; }
  void draw(FrameContext& context) override {
    const Footprint* footprint = context.resources.find<Footprint>();
    depths_.push_back(footprint ? footprint->depth : -1);
  }

 private:
  RenderStage stage_;
  std::vector<int>& depths_;
};

TEST_F(FrameTest, resourcesAreFoundByLaterPassesOfTheSameFrameAlone) {
  // Two frames with a publishing pass, whose resource two stages after it find; then one in which the pass
  // has nothing to do: what it published before is gone.
  bool idle = false;
  std::vector<int> terrain, clouds;
  renderer().add(std::make_unique<FootprintReader>(RenderStage::clouds, clouds));
  renderer().add(std::make_unique<FootprintReader>(RenderStage::terrain, terrain));
  renderer().add(std::make_unique<FootprintPass>(idle));
  for (const bool isIdle : {false, false, true}) {
    idle = isIdle;
    draw(pose({0, 0, 0}, 0, 0, 0));
  }
  EXPECT_THAT(terrain, ::testing::ElementsAre(1, 2, -1));
  EXPECT_EQ(clouds, terrain);
}

TEST_F(FrameTest, aFrameThatNothingLightsMakesNoTablesOfTheSky) {
  // With the shell too, until a pass comes that may ask for its light.
  renderer().add(std::make_unique<ToneMapPass>(context()));
  ASSERT_EQ(settings_.sky.model, sky::SkyModel::shell);
  const auto textures = [&] {
    draw(pose({0, 100, 0}, 0, 0, 0));
    core::FrameStatistics statistics;
    renderer().fillStatistics(statistics);
    return statistics.gl.textures;
  };
  EXPECT_EQ(textures(), 3);
  renderer().add(std::make_unique<SkyPass>(context()));
  EXPECT_EQ(textures(), 5);
}

TEST_F(FrameTest, statisticsCountDrawsObjectsAndBytes) {
  // Two passes, one draw each; the targets of 320x180 are 8 + 4 + 4 bytes a pixel. The shell has two textures
  // of tables, of four floats a texel; the closed form has none, also after the shell was drawn.
  renderer().add(std::make_unique<SkyPass>(context()));
  renderer().add(std::make_unique<ToneMapPass>(context()));
  const auto expect = [&](sky::SkyModel model, int textures, std::size_t bytes) {
    settings_.sky.model = model;
    draw(pose({0, 100, 0}, 0, 0, 0));
    core::FrameStatistics statistics;
    renderer().fillStatistics(statistics);
    EXPECT_EQ(statistics.passes[0].second.draws, 1);
    EXPECT_EQ(statistics.passes[1].second.draws, 1);
    EXPECT_EQ(statistics.gl.textures, textures);
    EXPECT_EQ(statistics.gl.framebuffers, 2);
    EXPECT_EQ(statistics.gl.errors, 0);
    EXPECT_EQ(statistics.gl.bytes, static_cast<std::int64_t>(320 * 180 * 16 + sizeof(FrameUniforms) + bytes));
    EXPECT_EQ(statistics.clock, context().isSoftware() ? "none" : "timer query");
    return statistics.gl.programs;
  };
  namespace shared = core::shared::f32;
  // That of the air, and those of the sky with six times the columns and three times the rows.
  const std::size_t tables = (shared::kSkySlices * shared::kAirRows * shared::kAirColumns +
                              3 * (3 * shared::kSkyRows - 4) * (6 * shared::kSkyColumns - 5)) *
                             sizeof(glm::vec4);
  // The sky's program of each model, and the curve's.
  EXPECT_EQ(expect(sky::SkyModel::closedForm, 3, 0), 2);
  EXPECT_EQ(expect(sky::SkyModel::shell, 5, tables), 3);
  EXPECT_EQ(expect(sky::SkyModel::closedForm, 3, 0), 3);
}

TEST_F(FrameTest, framesAreAFunctionOfTheirInput) {
  // The same input draws the same bits, also after another picture of another size.
  renderer().add(std::make_unique<SkyPass>(context()));
  renderer().add(std::make_unique<ToneMapPass>(context()));
  const core::Image first = draw(pose({0, 700, 0}, 30, 10, 5));
  draw(pose({5, 20, 0}, 80, -10, 0, 200, 50));
  const core::Image second = draw(pose({0, 700, 0}, 30, 10, 5));
  EXPECT_EQ(first.rgba, second.rgba);
  EXPECT_EQ(first.width, 320);
  EXPECT_EQ(first.height, 180);
}

// Has a shader that does not compile.
class BrokenPass final : public Pass {
 public:
  explicit BrokenPass(std::string fragment) : fragment_(std::move(fragment)) {}
  std::string_view name() const override { return "broken"; }
  RenderStage stage() const override { return RenderStage::weatherEffects; }
  void draw(FrameContext& context) override { context.shaders.shader("fullscreen.vert", fragment_).use(); }

 private:
  std::string fragment_;
};

TEST_F(FrameTest, brokenShaderIsThrownAndTheNextFrameIsWhole) {
  // The error names the file and comes when all other passes have drawn; mended, the same renderer draws on,
  // and its times and counts are not out of step.
  const test::TemporaryFolder folder;
  const std::string file = folder.write("broken.frag", "void main() { nonsense; }\n");
  renderer().add(std::make_unique<SkyPass>(context()));
  renderer().add(std::make_unique<BrokenPass>(file));
  renderer().add(std::make_unique<ToneMapPass>(context()));
  EXPECT_THROW(draw(pose({0, 100, 0}, 0, 30, 0)), core::DataError);
  EXPECT_GT(renderer().readBack().pixel(160, 90)[2], 50) << "the sky is there";
  EXPECT_EQ(context().resources().passes().at("toneMap").draws, 1u);
  core::FrameStatistics statistics;
  renderer().fillStatistics(statistics);
  EXPECT_THAT(statistics.passes[1].second.skipped, ::testing::HasSubstr("broken.frag"));
  folder.write("broken.frag", "void main() {}\n");
  renderer().reloadShaders();
  const core::Image image = draw(pose({0, 100, 0}, 0, 30, 0));
  EXPECT_GT(image.pixel(160, 90)[2], 50);
  EXPECT_EQ(context().resources().passes().at("toneMap").draws, 1u);
}

TEST_F(FrameTest, viewsThatAreNotValidDrawNothing) {
  // The renderer refuses them before it touches the GPU.
  View view = pose({0, 0, 0}, 0, 0, 0);
  view.position.x = std::nan("");
  EXPECT_THROW(draw(view), core::RangeError);
  EXPECT_EQ(context().resources().total().draws, 0u);
}

TEST_F(FrameTest, uniformBlockHasTheSameOffsetsOnBothSides) {
  // What C++ writes at an offset the shader reads at the same one, for every member.
  renderer().add(std::make_unique<SkyPass>(context()));
  draw(pose({0, 0, 0}, 0, 0, 0));
  const GLuint program =
      renderer().shaders().shader("fullscreen.vert", "sky/sky.frag", definesOf(features_)).id();
#define MEMBER(name) \
  { "Frame." #name, offsetof(FrameUniforms, name) }
  const std::vector<std::pair<std::string, std::size_t>> members = {
      MEMBER(viewProjection),  MEMBER(ndcToRay),    MEMBER(eye),
      MEMBER(viewport),        MEMBER(toSun),       MEMBER(sunLight),
      MEMBER(skyLight),        MEMBER(groundLight), MEMBER(sunDisc),
      MEMBER(nightRadiance),   MEMBER(airRayleigh), MEMBER(airHaze),
      MEMBER(columnDepth),     MEMBER(columnHere),  MEMBER(airLight),
      MEMBER(hazeLight),       MEMBER(overhead),    MEMBER(depthToSea),
      MEMBER(horizonRayleigh), MEMBER(horizonHaze), MEMBER(horizonIsotropic),
      MEMBER(skySun),          MEMBER(skyTable),    MEMBER(skyGlow)};
#undef MEMBER
  for (const auto& [name, offset] : members) {
    const char* text = name.c_str();
    GLuint index = GL_INVALID_INDEX;
    api().GetUniformIndices(program, 1, &text, &index);
    ASSERT_NE(index, GL_INVALID_INDEX) << name;
    GLint found = -1;
    api().GetActiveUniformsiv(program, 1, &index, GL_UNIFORM_OFFSET, &found);
    EXPECT_EQ(static_cast<std::size_t>(found), offset) << name;
  }
  const GLuint block = api().GetUniformBlockIndex(program, "Frame");
  GLint size = 0;
  api().GetActiveUniformBlockiv(program, block, GL_UNIFORM_BLOCK_DATA_SIZE, &size);
  EXPECT_EQ(static_cast<std::size_t>(size), sizeof(FrameUniforms));
}

const test::Plain kLower{0.0, {1, 0, 0}}, kUpper{0.5, {0, 1, 0}};

TEST_F(FrameTest, T18_halfAMetreIsResolvedTenKilometresAway) {
  // Two planes 0.5 m apart, 10 km below the eye: the upper one is seen everywhere, whichever is drawn first.
  test::noFaults("T18", "violations");
  for (const bool upperFirst : {true, false}) {
    const test::TemporaryFolder folder;
    const std::vector<test::Plain> plains =
        upperFirst ? std::vector{kUpper, kLower} : std::vector{kLower, kUpper};
    Renderer renderer(context(), settings_, false);
    renderer.add(std::make_unique<test::PlainsPass>(context(), folder, plains));
    renderer.add(std::make_unique<ToneMapPass>(context()));
    renderer.draw({.view = pose({0, 10000.5, 0}, 0, -90, 0)});
    const core::Image image = renderer.readBack();
    int wrong = 0;
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) wrong += image.pixel(x, y)[1] < 100;
    }
    EXPECT_EQ(wrong, 0) << (upperFirst ? "upper first" : "lower first");
  }
}

TEST_F(FrameTest, framesDoNotShowTheOneBefore) {
  // Land fills one frame; the next looks up and equals the first frame of a fresh renderer, in every bit.
  const test::TemporaryFolder folder;
  const std::vector<test::Plain> plains = {kUpper, kLower};
  const auto lookUp = [&](bool afterLand) {
    Renderer renderer(context(), settings_, false);
    renderer.add(std::make_unique<test::PlainsPass>(context(), folder, plains));
    renderer.add(std::make_unique<SkyPass>(context()));
    renderer.add(std::make_unique<ToneMapPass>(context()));
    if (afterLand) renderer.draw({.view = pose({0, 50, 0}, 0, -90, 0)});
    renderer.draw({.view = pose({0, 50, 0}, 0, 60, 0)});
    return renderer.readBack().rgba;
  };
  EXPECT_EQ(lookUp(true), lookUp(false));
}

// Leaves every state that a pass may change as no other pass expects it.
class UntidyPass final : public Pass {
 public:
  std::string_view name() const override { return "untidy"; }
  RenderStage stage() const override { return RenderStage::terrain; }
  void draw(FrameContext& context) override {
    const gl::Functions& gl = context.gl.api();
    gl.DepthFunc(GL_NEVER);
    gl.DepthMask(GL_FALSE);
    gl.ColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ZERO, GL_ZERO);
    gl.Enable(GL_CULL_FACE);
    gl.CullFace(GL_FRONT_AND_BACK);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(0, 0, 1, 1);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    gl.ClipControl(GL_UPPER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
  }
};

TEST_F(FrameTest, passesMayLeaveAnyStateBehind) {
  // A pass that turns everything upside down changes no pixel of this frame or the next.
  const auto drawTwice = [&](bool untidy) {
    Renderer renderer(context(), settings_, false);
    if (untidy) renderer.add(std::make_unique<UntidyPass>());
    renderer.add(std::make_unique<SkyPass>(context()));
    renderer.add(std::make_unique<ToneMapPass>(context()));
    renderer.draw({.view = pose({0, 50, 0}, 0, -20, 0)});
    renderer.draw({.view = pose({0, 50, 0}, 0, 20, 0)});
    return renderer.readBack().rgba;
  };
  EXPECT_EQ(drawTwice(true), drawTwice(false));
}

}  // namespace
}  // namespace skydrop::render
