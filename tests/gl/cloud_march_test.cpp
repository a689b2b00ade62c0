// The march of the tiers to play with: how near it comes to the reference, what rays between rays do, and
// that surfaces before, behind and in the clouds cost no more than they have to.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "skydrop/core/shared.h"
#include "support/cloud_rows.h"
#include "support/ground_pass.h"
#include "support/shared_noise.h"

namespace skydrop::render {
namespace {

using clouds::CloudTier, clouds::MarchResolution;

constexpr int kColumns = 200, kRows = 150;

class CloudMarchGLTest : public test::CloudRowsGLTest {
 protected:
  View picture(const glm::dvec3& position, double yaw, double pitch) const {
    return pose(position, yaw, pitch, 0, kColumns, kRows);
  }
  std::array<View, 3> views() const {
    return {picture({0, 600, 0}, 40, 12), picture({600, 2300, 600}, 40, 0), picture({0, 4500, 0}, 40, -15)};
  }

  struct Error {
    double relative;  // RMSE of radiance over its RMS, where the reference has an opacity above .01
    double bias;      // of the sum of radiance
    double holes;     // share of rays that lose more than half of their light
  };
  static Error errorOf(const std::vector<glm::vec4>& rays, const std::vector<glm::vec4>& reference) {
    double error = 0, whole = 0, sum = 0, expected = 0;
    int holes = 0, count = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (reference[i].w > 0.99f) continue;
      const glm::dvec3 a(rays[i]), b(reference[i]);
      error += glm::dot(a - b, a - b);
      whole += glm::dot(b, b);
      const double light = a.x + a.y + a.z, right = b.x + b.y + b.z;
      sum += light;
      expected += right;
      holes += light < 0.5 * right;
      ++count;
    }
    EXPECT_GT(count, kColumns * kRows / 10) << "proves little";
    return {std::sqrt(error / whole), sum / expected - 1, holes / static_cast<double>(count)};
  }
};

TEST_F(CloudMarchGLTest, tiersToPlayWithAreNearTheReference) {
  // From below, inside and above, in a picture so coarse that hardly anything is smooth (the bench has the
  // figures at 800 x 600): relative error, bias and holes of each tier.
  // Within 24 km and without a far field: that is judged in cloud_far_test.cpp.
  clouds_.fadeDistance = 24000;
  addClouds(test::sharedNoise());
  struct Limit {
    CloudTier tier;
    double error, bias, holes;
  };
  for (const View& view : views()) {
    clouds_.march = test::rowsOf(CloudTier::reference);
    const std::vector<glm::vec4> reference = cloudsFrom(view);
    for (const Limit& limit :
         {Limit{CloudTier::low, 0.25, 0.03, 0.05}, Limit{CloudTier::medium, 0.125, 0.008, 0.026},
          Limit{CloudTier::high, 0.04, 0.004, 0.008}, Limit{CloudTier::ultra, 0.012, 0.003, 0.001}}) {
      clouds_.march = test::rowsOf(limit.tier);
      clouds_.march.farStartM = 60000;
      const Error error = errorOf(cloudsFrom(view), reference);
      const std::string who = "tier " + std::to_string(static_cast<int>(limit.tier)) + ": " +
                              std::to_string(error.relative) + ' ' + std::to_string(error.bias) + ' ' +
                              std::to_string(error.holes);
      EXPECT_LT(error.relative, limit.error) << who;
      EXPECT_LT(std::abs(error.bias), limit.bias) << who;
      EXPECT_LE(error.holes, limit.holes) << who;
    }
  }
}

TEST_F(CloudMarchGLTest, bothFormsOfTheLoopsGiveTheSamePicture) {
  // The loops that a graphics card is given and those for a software renderer: every bit, at every tier that
  // has them.
  addClouds(test::sharedNoise());
  for (const CloudTier tier : {CloudTier::low, CloudTier::medium, CloudTier::high, CloudTier::ultra}) {
    clouds_.march = test::rowsOf(tier);
    for (const View& view : views()) {
      system_->setFlatLoops(true);
      const std::vector<glm::vec4> flat = cloudsFrom(view);
      system_->setFlatLoops(false);
      EXPECT_EQ(cloudsFrom(view), flat) << "tier " << static_cast<int>(tier);
    }
  }
}

TEST_F(CloudMarchGLTest, whatIsNotMarchedIsClearWhateverWasThere) {
  // A picture full of clouds, then one that has them in a part of it: every ray of the rest sees nothing, in
  // the pictures of all spacings.
  addClouds(test::sharedNoise());
  clouds_.march = test::rowsOf(CloudTier::high);
  clouds_.layers[0].coverage = 1;
  cloudsFrom(picture({0, 600, 0}, 40, 40));
  clouds_.layers[0].coverage = 0.3;
  const View view = picture({0, 600, 0}, 40, 10);
  const std::vector<glm::vec4> after = cloudsFrom(view);
  EXPECT_LT(system_->lastWork().tiles, 100u) << "proves little";  // of 130
  cloudsFrom(pose({0, 600, 0}, 40, 40, 0, 64, 36));               // another size: pictures are made again
  EXPECT_EQ(after, cloudsFrom(view));
}

TEST_F(CloudMarchGLTest, raysThatAreNotMarchedAreNearThoseThatAre) {
  // Against a ray for each pixel the pictures of rays two and four pixels apart differ by less, the less is
  // tolerated; where nothing is, by nothing.
  addClouds(test::sharedNoise());
  clouds_.march = test::rowsOf(CloudTier::high);
  for (const View& view : views()) {
    clouds_.march.resolution = MarchResolution::full;
    const std::vector<glm::vec4> all = cloudsFrom(view);
    for (const MarchResolution resolution : {MarchResolution::half, MarchResolution::quarter}) {
      clouds_.march.resolution = resolution;
      double before = 1;
      for (const double tolerance : {1.0, 0.1, 0.002}) {
        clouds_.march.coarseTolerance = clouds_.march.fineTolerance = tolerance;
        const std::vector<glm::vec4> some = cloudsFrom(view);
        const double error = errorOf(some, all).relative;
        EXPECT_LT(error, before) << tolerance;
        before = error;
      }
      EXPECT_LT(before, 0.003);
    }
  }
}

TEST_F(CloudMarchGLTest, aPictureOfAnySizeIsWholeToItsEdges) {
  // Sizes that are no multiple of anything: at the edges, which have rays beyond them, the picture of a
  // quarter of the rays is as near to that of all of them as elsewhere.
  addClouds(test::plainNoise());
  clouds_ = test::plainSettings();
  for (const glm::ivec2& size : {glm::ivec2(1, 1), {3, 2}, {5, 7}, {17, 33}, {63, 31}, {66, 35}}) {
    settings_.camera.fovDegrees = 0.4 * size.y;  // pixels of an angle as in the window
    const View view = pose({0, 900, 0}, 30, 50, 0, size.x, size.y);
    clouds_.march.resolution = MarchResolution::full;
    const std::vector<glm::vec4> all = cloudsFrom(view);
    clouds_.march.resolution = MarchResolution::quarter;
    EXPECT_LT(difference(all, cloudsFrom(view)), 2) << size.x << 'x' << size.y;
  }
}

TEST_F(CloudMarchGLTest, landBehindTheCloudsListsNoPictures) {
  // Seen from above, a plain that meets the clouds nowhere lets no more rays be marched than no land does, by
  // a twentieth; one that cuts through the layer lists no more than half of the picture.
  addClouds(test::sharedNoise());
  addPlains();
  clouds_.march = test::rowsOf(CloudTier::high);
  const View view = picture({0, 4500, 0}, 40, -15);
  const auto raysWith = [&](double plainM) {
    plains_.clear();
    if (plainM > 0) plains_ = {{plainM, {0.2f, 0.3f, 0.1f}}};
    sceneFrom(view);
    const CloudSystem::Work work = system_->lastWork();
    return work.raysBetween + work.finestRays;
  };
  const unsigned open = raysWith(0);
  EXPECT_GT(open, 1000u) << "proves little";
  EXPECT_LE(raysWith(10), 1.05 * open);
  EXPECT_LE(raysWith(1500), 1.05 * open);
  EXPECT_LE(raysWith(2400), kColumns * kRows / 2);
}

TEST_F(CloudMarchGLTest, somethingSmallerThanTheRaysAreApartIsSeenInFrontOfCloud) {
  // A bar two pixels wide, close by and before opaque cloud: no ray that a quarter of the rays leave out
  // shows cloud where the bar is.
  addClouds(test::sharedNoise());
  const View view = pose({0, 600, 0}, 40, 30, 0, kColumns, kRows);
  clouds_.march = test::rowsOf(CloudTier::high);
  clouds_.march.resolution = MarchResolution::full;
  const std::vector<glm::vec4> open = cloudsFrom(view);
  const glm::dvec3 ahead = rayDirection(view, {0.5 * kColumns, 0.5 * kRows});
  renderer().add(
      std::make_unique<test::GroundPass>(context(), planeMesh(0.5, 60, 1, 1), view.position + 30.0 * ahead));
  const std::vector<glm::vec4> all = cloudsFrom(view);
  clouds_.march.resolution = MarchResolution::quarter;
  const std::vector<glm::vec4> some = cloudsFrom(view);
  int bar = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (open[i].w > 0.5f || all[i].w < 1) continue;
    ++bar;
    ASSERT_TRUE(some[i] == glm::vec4(0, 0, 0, 1)) << i % kColumns << ' ' << i / kColumns;
  }
  EXPECT_GT(bar, 30) << "no bar in the picture";
}

// Counts the turns of the loops of shaders/clouds/march.glsl, behind the clouds' pass: what that bound is
// bound still.
class TurnsPass final : public Pass {
 public:
  TurnsPass(const CloudSystem& system, const test::TemporaryFolder& folder)
      : system_(system), file_(folder.write("turns.comp", R"(
#include "clouds/field.glsl"
#include "clouds/gathered.glsl"
#include "clouds/steps.glsl"
#include "clouds/tiles.glsl"
#include "clouds/view.glsl"
#include "shared/cloud_march.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Tiles { uvec4 groups; uvec4 groupsOfFour; Task tasks[]; } tiles;
layout(std430, binding = 4) buffer Turns { uint most[4]; } turns;
uniform ivec2 tileCount;

uint samples = 0u;
MediumSample noteSample(vec3 place, float detailShare) { ++samples; return sampleAt(place, detailShare); }
MediumSample noteFarSample(vec3 place) { ++samples; return farSampleAt(place); }
#define sampleAt noteSample
#define farSampleAt noteFarSample
#include "clouds/march.glsl"
#undef sampleAt
#undef farSampleAt

void main() {
  Task task = tiles.tasks[gl_WorkGroupID.x];
  ivec2 tile = taskPlace(task);
  ivec2 pixel = tile * 16 + 2 * placeInSquare(gl_LocalInvocationIndex, 8u);
  vec3 direction = normalize(rayThrough(vec2(pixel) + 0.5));
  float transmittance;
  int count = gatherSegments(vec4(direction, rayBend(direction)), (tile.y * tileCount.x + tile.x) * kPlacesOfSpans, kFarMarker, transmittance);
  atomicMax(turns.most[0], samples);
  atomicMax(turns.most[1], uint(count));
  samples = 0u;
  marchRay(direction, (tile.y * tileCount.x + tile.x) * kPlacesOfSpans, kFarMarker);
  atomicMax(turns.most[2], samples);
}
)")) {}

  std::string_view name() const override { return "turns"; }
  RenderStage stage() const override { return RenderStage::clouds; }
  void draw(FrameContext& context) override {
    gl::Buffer turns(context.gl, sizeof most, gl::Buffer::Use::write, "turns");
    most = {};
    turns.writeValue(0, most);
    turns.bindBase(GL_SHADER_STORAGE_BUFFER, 4);
    gl::ComputeShader& shader = context.shaders.computeShader(file_, std::array{std::string("DETAIL")});
    shader.use();
    const View& view = context.frame.view;
    shader.setIvec2("tileCount",
                    glm::ivec2((view.width + 3) / 4 * 4 + 16, (view.height + 3) / 4 * 4 + 16) / 16);
    shader.dispatch(system_.lastWork().tiles, 1);
    context.gl.api().MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    turns.read(0, std::as_writable_bytes(std::span(most)));
  }

  std::array<GLuint, 4> most{};  // of a ray: samples of its own, segments, all samples

 private:
  const CloudSystem& system_;
  std::string file_;
};

TEST_F(CloudMarchGLTest, noRayRunsMoreLoopsThanADriverAllows) {
  // In mist that rays go through for 60 km, with the finest steps that can be set, and with those of each
  // tier: no ray has more segments than there is room for, and all its samples stay far below the 65 535
  // turns at which llvmpipe ends a loop: so one dispatch reaches the end of every ray.
  test::TemporaryFolder folder;
  addClouds(test::sharedNoise());
  auto pass = std::make_unique<TurnsPass>(*system_, folder);
  TurnsPass& turns = *pass;
  renderer().add(std::move(pass));
  clouds_.layers[0].extinction = 0.002;
  clouds_.layers[0].coverage = 1;
  for (const CloudTier tier : {CloudTier::low, CloudTier::medium, CloudTier::high, CloudTier::ultra}) {
    clouds_.march = test::rowsOf(tier);
    sceneFrom(small({0, 2400, 0}, 40, 3));
    EXPECT_LE(turns.most[1], static_cast<GLuint>(core::shared::f32::kMostSegments));
    EXPECT_GT(turns.most[1], 5u);
    EXPECT_LT(turns.most[0], 4000u);
    EXPECT_LT(turns.most[2], 12000u);
    RecordProperty("samples" + std::to_string(static_cast<int>(tier)), static_cast<int>(turns.most[2]));
  }
}

}  // namespace
}  // namespace skydrop::render
