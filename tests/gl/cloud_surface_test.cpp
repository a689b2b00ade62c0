// Hard cases of the clouds' pass (tests/stability/cases.json): what stands before, behind and beside clouds,
// and what was in the targets before.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "skydrop/core/shared.h"
#include "support/cloud_rows.h"
#include "support/ground_pass.h"
#include "support/margin.h"
#include "support/shared_noise.h"

namespace skydrop::render {
namespace {

namespace f32 = core::shared::f32;
using test::CloudRowsGLTest;

constexpr int kHeight = test::kCloudRowsHeight;

// A level plate as dark as a scene in which nothing is.
class DarkPlate final : public Pass {
 public:
  static constexpr double kSide = 1500;  // m

  DarkPlate(gl::Context& context, const test::TemporaryFolder& folder, const glm::dvec3& middle)
      : plane_(context, planeMesh(kSide, kSide, 1, 1), "plate"),
        vertex_(folder.write("plate.vert",
                             "#include \"frame.glsl\"\nlayout(location = 0) in vec3 position;\n"
                             "uniform vec3 place;\nvoid main() { gl_Position = frame.viewProjection * "
                             "vec4(position + place, 1.0); }\n")),
        fragment_(folder.write("plate.frag", "out vec4 color;\nvoid main() { color = vec4(0.0); }\n")),
        middle_(middle) {}

  std::string_view name() const override { return "plate"; }
  RenderStage stage() const override { return RenderStage::terrain; }
  std::optional<std::string> skipReason(const FrameInput&) const override {
    return isShown ? std::nullopt : std::optional<std::string>("put away");
  }
  void draw(FrameContext& context) override {
    gl::Shader& shader = context.shaders.shader(vertex_, fragment_);
    shader.use();
    shader.setVec3("place", relativeToEye(context.frame.view, middle_));
    plane_.draw();
  }

  bool isShown = true;

 private:
  Mesh plane_;
  std::string vertex_, fragment_;
  glm::dvec3 middle_;
};

TEST_F(CloudRowsGLTest, C29_aCloudDoesNotTellWhatStandsBehindIt) {
  // A dark plate just under the layer, in front of nothing, seen from above. At full resolution the clouds
  // are the same with it and without it, across its edge and everywhere, to less than 2/255. At half
  // resolution a pixel is mixed of four rays by how alike their surfaces are, and gets a ray of its own where
  // they are not: within two pixels of the edge it may differ by what that ray sees and they do not (80/255
  // in a picture as coarse as this), on the plate by other shares of the four (8/255).
  addClouds(test::sharedNoise());
  constexpr int kColumns = 160, kRows = 90;
  const View view = pose({-4000, 4500, 1000}, 300, -50, 0, kColumns, kRows);
  const glm::dvec3 middle = view.position + view.forward() * ((1500 - view.position.y) / view.forward().y);
  auto pass = std::make_unique<DarkPlate>(context(), folder_, middle);
  DarkPlate& plate = *pass;
  renderer().add(std::move(pass));
  const auto isPlate = [&](int x, int y) {
    const glm::dvec3 ray = rayDirection(view, {x + 0.5, y + 0.5});
    const glm::dvec3 hit = view.position + ray * ((middle.y - view.position.y) / ray.y) - middle;
    return ray.y < 0 && std::abs(hit.x) < DarkPlate::kSide / 2 && std::abs(hit.z) < DarkPlate::kSide / 2;
  };
  const auto isNearEdge = [&](int x, int y) {
    for (int j = y - 2; j <= y + 2; ++j) {
      for (int i = x - 2; i <= x + 2; ++i) {
        if (isPlate(i, j) != isPlate(x, y)) return true;
      }
    }
    return false;
  };
  for (const auto resolution : {clouds::MarchResolution::full, clouds::MarchResolution::quarter}) {
    clouds_.march.resolution = resolution;
    plate.isShown = false;
    const std::vector<glm::vec4> open = sceneFrom(view);
    plate.isShown = true;
    const std::vector<glm::vec4> covered = sceneFrom(view);
    double nearEdge = 0, elsewhere = 0;
    int edge = 0;
    for (int y = 0; y < kRows; ++y) {
      for (int x = 0; x < kColumns; ++x) {
        const auto i = static_cast<std::size_t>(y * kColumns + x);
        const double apart = difference({open[i]}, {covered[i]});
        double& worst = isNearEdge(x, y) ? nearEdge : elsewhere;
        worst = std::max(worst, apart);
        edge += isNearEdge(x, y) && open[i].x > 0.1f;
      }
    }
    EXPECT_GT(edge, 100) << "no cloud at the edge";
    const bool isFull = resolution == clouds::MarchResolution::full;
    EXPECT_TRUE(test::holds("C29", elsewhere, test::below(isFull ? 2 : 8), "of 255"));
    EXPECT_TRUE(test::holds("C29", nearEdge, test::below(isFull ? 2 : 80), "of 255"));
    RecordProperty(isFull ? "full" : "half", std::to_string(nearEdge));
  }
}

TEST_F(CloudRowsGLTest, C29_samplesDoNotJumpWithTheDepthBehind) {
  // A plate deep inside an opaque layer: what is in front of it is cut at the same distances whether a ray
  // ends at the plate or goes on, so it cannot be seen at all, at full resolution (2/255) and at half.
  addClouds(test::plainNoise());
  clouds_ = test::plainSettings();
  clouds_.layers[0].extinction = 0.02;
  const View view = small({-4000, 4500, 1000}, 300, -50);
  const glm::dvec3 middle = view.position + view.forward() * ((2200 - view.position.y) / view.forward().y);
  auto pass = std::make_unique<DarkPlate>(context(), folder_, middle);
  DarkPlate& plate = *pass;
  renderer().add(std::move(pass));
  for (const auto resolution : {clouds::MarchResolution::full, clouds::MarchResolution::quarter}) {
    clouds_.march.resolution = resolution;
    plate.isShown = false;
    const std::vector<glm::vec4> open = sceneFrom(view);
    plate.isShown = true;
    EXPECT_TRUE(test::holds("C29", difference(open, sceneFrom(view)), test::below(2), "of 255"));
    EXPECT_GT(open[0].x, 0.1f) << "nothing to be seen";
  }
}

TEST_F(CloudRowsGLTest, C29_aSurfaceThatHidesTilesDoesNotThinTheCloudsBesideIt) {
  // A plate overhead whose edge is that of a row of tiles: those that it hides are not marched, and what was
  // not marched is no part of the pixels beside it, however much the tier tolerates. In the mean over the row
  // the light beside the edge is that of a ray for each pixel to 5/255 at half resolution, 12/255 at a
  // quarter.
  addClouds(test::sharedNoise());
  constexpr int kColumns = 160, kRows = 90, kCovered = 64;  // from this row on: two tiles of half resolution
  const View view = pose({0, 600, 0}, 0, 0, 0, kColumns, kRows);
  const double reach = 10 / ((2.0 * kCovered / kRows - 1) * std::tan(view.fovYRad / 2));
  const glm::dvec3 middle = view.position + glm::dvec3(reach - DarkPlate::kSide / 2, 10, 0);
  renderer().add(std::make_unique<DarkPlate>(context(), folder_, middle));
  const auto besideEdge = [&](clouds::MarchResolution resolution) {
    clouds_.march.resolution = resolution;
    const std::vector<glm::vec4> scene = sceneFrom(view);
    double sum = 0;
    for (std::size_t x = 0; x < kColumns; ++x) sum += shown(scene[(kCovered - 1) * kColumns + x]).y;
    return sum / kColumns * 255;
  };
  clouds_.march.coarseTolerance = clouds_.march.fineTolerance = 10;
  const double exact = besideEdge(clouds::MarchResolution::full);
  EXPECT_GT(exact, 50) << "no cloud beside the edge";
  EXPECT_TRUE(test::holds("C29", test::apart(besideEdge(clouds::MarchResolution::half), exact),
                          test::atMost(5), "of 255"));
  EXPECT_TRUE(test::holds("C29", test::apart(besideEdge(clouds::MarchResolution::quarter), exact),
                          test::atMost(12), "of 255"));
}

// Overwrites what the clouds' pass left behind: its pictures of rays with NaN, its lists with all bits set.
// Image and buffer bindings are those that it ended with.
class PoisonPass final : public Pass {
 public:
  PoisonPass(const CloudSystem& system, const test::TemporaryFolder& folder)
      : system_(system), file_(folder.write("poison.comp", R"(
layout(local_size_x = 8, local_size_y = 8) in;
#ifdef MULTI_DISPATCH
layout(binding = 2, rgba32f) uniform writeonly image2D rayLight;
layout(binding = 3, rgba32f) uniform writeonly image2D rayState;
#else
layout(std430, binding = 3) buffer Rays { uint words[]; } rays;
#endif
layout(std430, binding = 0) buffer Tiles { uint words[]; } tiles;
layout(std430, binding = 1) buffer Spans { uint words[]; } spans;
uniform float poison;
void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  int index = at.y * 64 + at.x;
#ifdef MULTI_DISPATCH
  imageStore(rayLight, at, vec4(poison));
  imageStore(rayState, at, vec4(poison));
#else
  if (index < rays.words.length()) rays.words[index] = 0xffffffffu;
#endif
  if (index < tiles.words.length()) tiles.words[index] = 0xffffffffu;
  if (index < spans.words.length()) spans.words[index] = 0xffffffffu;
}
)")) {}

  std::string_view name() const override { return "poison"; }
  RenderStage stage() const override { return RenderStage::hud; }
  void draw(FrameContext& context) override {
    gl::ComputeShader& shader = context.shaders.computeShader(
        file_, isMultiDispatch ? std::vector<std::string>{"MULTI_DISPATCH"} : std::vector<std::string>{});
    shader.use();
    shader.setFloat("poison", poison);
    shader.dispatch(8, 8);
    const std::array<float, 4> none = {poison, poison, poison, poison};
    for (const CloudRays& rays : system_.rays()) {
      if (!rays.light) continue;
      context.gl.api().ClearTexImage(rays.light.id(), 0, GL_RGBA, GL_FLOAT, none.data());
      context.gl.api().ClearTexImage(rays.distances.id(), 0, GL_RED, GL_FLOAT, none.data());
    }
    context.gl.api().MemoryBarrier(GL_ALL_BARRIER_BITS);
  }

  bool isMultiDispatch = true;
  float poison = 0;

 private:
  const CloudSystem& system_;
  std::string file_;
};

TEST_F(CloudRowsGLTest, C10_nothingIsReadThatTheFrameDidNotWrite) {
  // Frames after all targets and lists were poisoned equal those before in every bit, at every resolution and
  // where marches are carried over several dispatches: with NaN, with something near and with something far.
  test::noFaults("C10", "violations");
  addSky();
  addClouds(test::sharedNoise());
  // Hides a row of tiles.
  const View view = small({0, 600, 0}, 0, 0);
  const double reach = 10 / ((2.0 * 32 / kHeight - 1) * std::tan(view.fovYRad / 2));
  renderer().add(std::make_unique<DarkPlate>(
      context(), folder_, view.position + glm::dvec3(reach - DarkPlate::kSide / 2, 10, 0)));
  auto pass = std::make_unique<PoisonPass>(*system_, folder_);
  PoisonPass& poison = *pass;
  using enum clouds::CloudTier;
  const std::array tiers = {low, high, ultra, reference};
  const auto viewOf = [&](clouds::CloudTier tier) {
    return tier == reference ? pose({0, 600, 0}, 40, 14, 0, 24, 14) : view;
  };
  std::vector<std::vector<glm::vec4>> clean;
  for (const auto tier : tiers) {
    clouds_.march = test::rowsOf(tier);
    clean.push_back(sceneFrom(viewOf(tier)));
    ASSERT_TRUE(areFinite(clean.back()));
  }
  renderer().add(std::move(pass));
  for (std::size_t i = 0; i < tiers.size(); ++i) {
    clouds_.march = test::rowsOf(tiers[i]);
    poison.isMultiDispatch = tiers[i] == reference;
    for (const float value : {std::numeric_limits<float>::quiet_NaN(), 1.0f, 65000.0f}) {
      poison.poison = value;
      sceneFrom(viewOf(tiers[i]));
      EXPECT_TRUE(sceneFrom(viewOf(tiers[i])) == clean[i]) << "tier " << i << ", poison " << value;
    }
  }
}

}  // namespace
}  // namespace skydrop::render
