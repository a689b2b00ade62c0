// The shader's march against integrals in double: the reference tier against clouds::referenceMarch(), a
// medium that depends on the height alone against quadrature; and how much of it one dispatch does.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "render/clouds/light_volumes.h"
#include "skydrop/clouds/light_volume.h"
#include "skydrop/clouds/reference_march.h"
#include "skydrop/core/shared.h"
#include "support/cloud_frame_test.h"
#include "support/margin.h"
#include "support/shared_noise.h"
#include "support/temporary_folder.h"

namespace skydrop::render {
namespace {

namespace f64 = core::shared::f64;

class CloudReferenceGLTest : public test::CloudFrameTest {
 protected:
  static constexpr int kWidth = 48, kHeight = 27;

  View small(const glm::dvec3& position, double yaw, double pitch) const {
    return pose(position, yaw, pitch, 0, kWidth, kHeight);
  }
  clouds::MarchLight marchLight() const {
    return {directionToSun(settings_.sun), clouds_.layers[0].anisotropy, clouds_.layers[0].forwardShare};
  }
  // Radiance and transmittance of a ray: what a march gathers, in the light of the frame.
  glm::dvec4 litBy(const clouds::MarchResult& gathered, double eyeHeight) {
    const SkyLight light = skyLight(settings_, eyeHeight);
    const double middle = clouds_.layers[0].cloudHeight + 0.5 * clouds_.layers[0].thickness;
    const glm::dvec3 sun = sky::sunIlluminance(light, middle);
    return {
        (sun * gathered.sun + light.sky * gathered.sky + light.ground * (groundShare() * gathered.ground)) *
            light.exposure,
        gathered.transmittance};
  }

  std::array<View, 3> views() const {
    return {small({0, 600, 0}, 40, 14), small({3000, 2400, -2000}, 200, 2),
            small({-4000, 4500, 1000}, 300, -12)};
  }

  struct Allowed {
    double transmittance;
    double ofItself, ofBrightest;  // of light: shares
  };
  struct Worst {
    int clouded = 0;  // rays that were compared and met cloud
    double transmittance = 0;
    double light = 0;  // as a share of what is allowed
  };
  static double brightestOf(const std::vector<glm::vec4>& rays) {
    float brightest = 0;
    for (const glm::vec4& ray : rays) brightest = std::max({brightest, ray.x, ray.y, ray.z});
    return brightest;
  }
  static void expectNear(const glm::dvec4& found, const glm::dvec4& exact, double brightest,
                         const Allowed& allowed, Worst& worst) {
    worst.clouded += exact.w < 0.999;
    worst.transmittance = std::max(worst.transmittance, std::abs(found.w - exact.w));
    EXPECT_NEAR(found.w, exact.w, allowed.transmittance);
    for (int c = 0; c < 3; ++c) {
      const double light = allowed.ofItself * exact[c] + allowed.ofBrightest * brightest;
      worst.light = std::max(worst.light, std::abs(found[c] - exact[c]) / light);
      EXPECT_NEAR(found[c], exact[c], light);
    }
  }
  void compare(const View& view, const clouds::MarchSteps& steps, const Allowed& allowed, Worst& worst,
               const clouds::ScatteredLight& scattered = clouds::octavesOfLight) {
    const clouds::CloudField field(test::sharedNoise(), clouds_);
    const clouds::MarchMedium medium = clouds::mediumOf(field);
    const std::vector<glm::vec4> found = cloudsFrom(view);
    const double brightest = brightestOf(found);
    for (int y = 2; y < kHeight; y += 6) {
      for (int x = 3; x < kWidth; x += 8) {
        SCOPED_TRACE("pixel " + std::to_string(x) + ' ' + std::to_string(y));
        const clouds::MarchRay ray{view.position, rayDirection(view, {x + 0.5, y + 0.5})};
        const clouds::MarchResult exact = clouds::referenceMarch(medium, marchLight(), ray, steps, scattered);
        expectNear(glm::dvec4(found[static_cast<std::size_t>(y * kWidth + x)]), litBy(exact, view.position.y),
                   brightest, allowed, worst);
      }
    }
  }
  void record(const Worst& worst) {
    RecordProperty("worstTransmittance", std::to_string(worst.transmittance));
    RecordProperty("worstLightOfAllowed", std::to_string(worst.light));
  }
};

TEST_F(CloudReferenceGLTest, theReferenceTierIsTheMarchInDoubles) {
  // From below, inside and above, by day, in the evening and at night: every ray of a grid.
  // Transmittance within 1e-3: a half float near 1 is cut by up to 4.9e-4, steps of 4 m to 24 m (and those of
  // the double, by its own header 5e-4 of light) take the rest. Light within 2e-3 of itself (half of that is
  // the half float's, the rest that up to four steps share one place of light) and, where a cloud is thin, of
  // 1e-3 of the brightest ray: there light is off by what the transmittance is off, times a source as bright
  // as that.
  clouds_.fadeDistance = 24000;  // steps grow with the distance: C34 looks farther, with shorter ones
  addClouds(test::sharedNoise());
  clouds_.march = test::rowsOf(clouds::CloudTier::reference);
  Worst worst;
  for (const double elevation : {40.0, 15.0, -8.0}) {
    settings_.sun.elevationDegrees = elevation;
    for (const View& view : views()) compare(view, {8192, 128}, {1e-3, 2e-3, 1e-3}, worst);
  }
  EXPECT_GE(worst.clouded, 3 * 36) << "proves little";
  record(worst);
}

TEST_F(CloudReferenceGLTest, theReferenceTierReadsTheVolumeAsTheMarchInDoublesDoes) {
  // From below, inside and above: light within 1 % of itself and .5 % of the brightest ray. The volume has
  // half floats and is filtered between 256ths of a cell; the rest is as with octaves.
  clouds_.fadeDistance = 24000;
  clouds_.light = clouds::CloudLight::volume;
  addClouds(test::sharedNoise());
  clouds_.march = test::rowsOf(clouds::CloudTier::reference);
  settings_.sun.elevationDegrees = 25;
  const clouds::CloudField field(test::sharedNoise(), clouds_);
  const clouds::LightVolume volume(field, toRoundedSun(roundedSun(directionToSun(settings_.sun))));
  const clouds::CloudLayerSettings& layer = clouds_.layers[0];
  const double rowM = layer.thickness / clouds::LightVolume::kRows;
  const auto scattered = [&](const clouds::LitPlace& at) {
    const clouds::LightVolume::Texel texel = volume.at(at.place);
    return glm::dvec3(
        f64::scatteredSunOfVolume(f64::volumePhases(at.sunCosine, layer.anisotropy, layer.forwardShare),
                                  at.sunDepth, static_cast<double>(texel.sun), at.extinction, rowM),
        texel.sky, texel.ground());
  };
  Worst worst;
  for (const View& view : views()) compare(view, {4096, 128}, {1e-3, 1e-2, 5e-3}, worst, scattered);
  EXPECT_GE(worst.clouded, 36) << "proves little";
  record(worst);
}

TEST_F(CloudReferenceGLTest, aSunJustOverTheHorizonIsAsGoodAsItsSamples) {
  // At 4 degrees the way to the sun is 26 km long and its 128 samples stand up to 400 m apart: against 2048
  // of them light is within 1.5 % of the brightest ray. (With 128 the march in doubles is as far off.)
  clouds_.fadeDistance = 24000;  // steps grow with the distance: C34 looks farther, with shorter ones
  addClouds(test::sharedNoise());
  clouds_.march = test::rowsOf(clouds::CloudTier::reference);
  settings_.sun.elevationDegrees = 4;
  Worst worst;
  for (const View& view : views()) compare(view, {4096, 2048}, {1e-3, 2e-3, 0.015}, worst);
  EXPECT_GE(worst.clouded, 36) << "proves little";
  record(worst);
}

TEST_F(CloudReferenceGLTest, C34_theExactMarchBendsAsTheMarchInDoubles) {
  // Rays within two degrees of the horizon, from below, from just over the base (some leave the layer and
  // enter it again), from within and from just over the top, to 60 km: as near as those of the other views,
  // in steps that do not grow to more than 8 m. (The tier's own, 64 m long out there, are off by up to .006
  // of the transmittance of single rays.)
  test::noFaults("C34", "violations");
  addClouds(test::sharedNoise());
  clouds_.march = test::rowsOf(clouds::CloudTier::reference);
  clouds_.march.stepGrowth = 0.0002;
  settings_.camera.fovDegrees = 3;
  Worst worst;
  for (const double height : {900.0, 1600.0, 2400.0, 3500.0})
    compare(small({500, height, -300}, 40, 0), {16384, 128}, {1.5e-3, 2e-3, 2e-3}, worst);
  EXPECT_GE(worst.clouded, 30) << "proves little";
  record(worst);
}

// A medium of the profile of a cumulus alone: all that a ray gathers is an integral over the height.
class ProfileQuadrature {
 public:
  ProfileQuadrature(const clouds::CloudSettings& settings, const clouds::MarchLight& light)
      : settings_(settings), light_(light) {
    for (int i = 0; i < kParts; ++i) {
      below_[static_cast<std::size_t>(i) + 1] =
          below_[static_cast<std::size_t>(i)] + f64::cloudProfile((i + 0.5) / kParts, 1.0) / kParts;
    }
  }

  // For a ray from below the layer or above it: the earth's curve makes it rise over the layer the steeper,
  // the higher it is above the eye.
  clouds::MarchResult along(const glm::dvec3& direction, double eyeHeight) const {
    const double depth = settings_.layers[0].extinction * settings_.layers[0].thickness;
    const f64::Vec4 phases =
        f64::cloudPhases(glm::dot(direction, light_.toSun), light_.anisotropy, light_.forwardShare);
    clouds::MarchResult result;
    const double bend = f64::rayBend(direction);
    double behind = 1, passed = 0;
    for (int i = 0; i < kParts; ++i) {
      const int part = direction.y > 0 ? i : kParts - 1 - i;
      const double height = (part + 0.5) / kParts;
      const double from = below_[static_cast<std::size_t>(part)],
                   to = below_[static_cast<std::size_t>(part) + 1];
      const double over =
          settings_.layers[0].cloudHeight + height * settings_.layers[0].thickness - eyeHeight;
      const double here = depth * (to - from) / std::sqrt(direction.y * direction.y + 4 * bend * over);
      const double share = behind * -std::expm1(-here);
      passed += here;
      const double above = below_.back() - 0.5 * (from + to);
      result.sun += share * f64::scatteredSun(phases, depth * above / light_.toSun.y);
      result.sky += share * f64::scatteredSky(height);
      result.ground += share * f64::scatteredGround(height);
      behind -= share;
    }
    result.transmittance = std::exp(-passed);
    return result;
  }

 private:
  static constexpr int kParts = 20000;  // a part's share of the profile is off by 1e-9

  clouds::CloudSettings settings_;
  clouds::MarchLight light_;
  std::vector<double> below_ = std::vector<double>(kParts + 1, 0.0);
};

TEST_F(CloudReferenceGLTest, aMediumOfTheHeightAloneHasItsQuadrature) {
  // Thin to thick, upwards and downwards, at the zenith and slanted: transmittance within 6e-4 (a half float
  // near 1 is cut by up to 4.9e-4), light within 1.5e-3 of itself and 1e-4 of the brightest ray: a half float
  // is cut by up to 1e-3, and 128 samples to the sun meet the profile's corners to 3e-4.
  addClouds(test::plainNoise());
  clouds_ = test::plainSettings();
  clouds_.march = test::rowsOf(clouds::CloudTier::reference);
  clouds_.fadeDistance = 60000;  // nothing within 36 km fades
  Worst worst;
  for (const double extinction : {2e-5, 2e-3, 0.02}) {
    clouds_.layers[0].extinction = extinction;
    const ProfileQuadrature quadrature(clouds_, marchLight());
    for (const View& view :
         {small({0, 900, 0}, 30, 90), small({0, 900, 0}, 250, 40), small({0, 4000, 0}, 120, -60)}) {
      const std::vector<glm::vec4> found = cloudsFrom(view);
      const double brightest = brightestOf(found);
      for (int y = 1; y < kHeight; y += 5) {
        for (int x = 1; x < kWidth; x += 9) {
          SCOPED_TRACE("pixel " + std::to_string(x) + ' ' + std::to_string(y));
          const glm::dvec3 direction = rayDirection(view, {x + 0.5, y + 0.5});
          ASSERT_GT(std::abs(direction.y), 0.1);
          expectNear(glm::dvec4(found[static_cast<std::size_t>(y * kWidth + x)]),
                     litBy(quadrature.along(direction, view.position.y), view.position.y), brightest,
                     {6e-4, 1.5e-3, 1e-4}, worst);
        }
      }
    }
  }
  record(worst);
}

// Counts what shaders/clouds/exact_march.glsl does in a dispatch: its own text, with the calls that stand for
// a step and for a segment replaced by ones that count. Behind the clouds' pass: what that bound is bound
// still.
class CountingPass final : public Pass {
 public:
  // Of a dispatch, by ray: steps before each evaluation of light, then those after the last.
  static constexpr std::size_t kMostSegments = 1024;
  struct Ray {
    std::array<GLuint, kMostSegments> steps;
    GLuint segments;
    float weight, distance;  // opacity so far, and what is kept of its distance
    GLuint unused;
  };

  CountingPass(const CloudSystem& system, const test::TemporaryFolder& folder,
               const clouds::CloudSettings& clouds)
      : system_(system), clouds_(clouds), file_(folder.write("count.comp", R"(
#include "clouds/field.glsl"
#include "clouds/gathered.glsl"
#include "clouds/occupancy.glsl"
#include "clouds/steps.glsl"
#include "clouds/sun_depth.glsl"
#include "clouds/tiles.glsl"
#include "clouds/uniforms.glsl"
#include "clouds/view.glsl"
#include "frame.glsl"
#include "shared/cloud_light.glsl"
#include "shared/cloud_medium.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Tiles { uvec4 groups; uvec4 groupsOfFour; Task tasks[]; } tiles;
struct Count { uint steps[1024]; uint segments; float weight; float distance; uint unused; };
layout(std430, binding = 4) buffer Counts { Count counts[]; };
struct Carried { float sun, sky, ground, transmittance, weight, distance, at, clear; };
layout(std430, binding = 5) buffer CarriedMarches { Carried carried[]; };
layout(std430, binding = 6) buffer UnderWay { uint raysUnderWay; };
uniform bool isFirst;

uint steps = 0u;
uint segments = 0u;
float noteStep(ivec3 cell) { ++steps; return emptyCells(cell); }
float noteStretch(vec3 place, float height) {
  counts[gl_GlobalInvocationID.x].steps[min(segments, 1022u)] = steps;
  steps = 0u;
  ++segments;
  return sunDepth(place, height);
}
#define emptyCells noteStep
#define sunDepth noteStretch
#include "clouds/exact_march.glsl"
#include "clouds/resolve.glsl"

void main() {
  uint ray = gl_GlobalInvocationID.x;
  Task task = tiles.tasks[gl_WorkGroupID.x];
  ivec2 at = taskPlace(task) * 8 + placeInSquare(gl_LocalInvocationIndex, 8u);
  vec3 direction = normalize(rayThrough(vec2(at) + 0.5));
  RaySpan span = spanOfRay(direction, kFarMarker, task);
  March march = marchFrom(span.begin);
  if (!isFirst) {
    Carried c = carried[ray];
    march = March(Gathered(c.sun, c.sky, c.ground, c.transmittance, c.weight, c.distance), c.at, c.clear);
  }
  marchOn(march, direction, span);
  counts[ray].steps[min(segments, 1023u)] = steps;
  counts[ray].segments = segments;
  Gathered g = march.gathered;
  counts[ray].weight = g.weight;
  counts[ray].distance = seenDistance(g);
  carried[ray] = Carried(g.sun, g.sky, g.ground, g.transmittance, g.weight, g.distance, march.at, march.clear);
  if (isUnderWay(march, span)) atomicAdd(raysUnderWay, 1u);
}
)")) {}

  std::string_view name() const override { return "counting"; }
  RenderStage stage() const override { return RenderStage::clouds; }
  void draw(FrameContext& context) override {
    const unsigned tiles = system_.lastWork().tiles;
    const std::size_t rays = std::size_t{tiles} * 64;
    gl::Buffer counts(context.gl, rays * sizeof(Ray), gl::Buffer::Use::fixed, "counts");
    gl::Buffer carried(context.gl, rays * 32, gl::Buffer::Use::fixed, "carried");
    gl::Buffer underWay(context.gl, 16, gl::Buffer::Use::write, "under way");
    counts.bindBase(GL_SHADER_STORAGE_BUFFER, 4);
    carried.bindBase(GL_SHADER_STORAGE_BUFFER, 5);
    underWay.bindBase(GL_SHADER_STORAGE_BUFFER, 6);
    gl::ComputeShader& shader = context.shaders.computeShader(file_, std::array{std::string("DETAIL")});
    shader.use();
    shader.setInt("sunSamples", static_cast<int>(clouds_.march.sunSamples));
    dispatches.clear();
    GLuint left = 1;
    while (left > 0 && dispatches.size() < 64) {
      shader.setBool("isFirst", dispatches.empty());
      underWay.writeValue(0, GLuint{0});
      shader.dispatch(tiles, 1);
      context.gl.api().MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
      underWay.read(0, std::as_writable_bytes(std::span(&left, 1)));
      dispatches.emplace_back(rays);
      counts.read(0, std::as_writable_bytes(std::span(dispatches.back())));
    }
  }

  std::vector<std::vector<Ray>> dispatches;

 private:
  const CloudSystem& system_;
  const clouds::CloudSettings& clouds_;
  std::string file_;
};

class CloudCountGLTest : public CloudReferenceGLTest {
 protected:
  using Dispatches = std::vector<std::vector<CountingPass::Ray>>;

  // Clouds that rays go through for 24 km.
  void fillWithMist() {
    clouds_.layers[0].extinction = 0.002;
    clouds_.layers[0].coverage = 1;
  }
  // What each dispatch of a tier's march does, with a ray for each pixel.
  const Dispatches& countFrom(const View& view, clouds::CloudTier tier = clouds::CloudTier::reference) {
    clouds_.march = test::rowsOf(tier);
    clouds_.march.resolution = clouds::MarchResolution::full;
    if (counting_) {
      cloudsFrom(view);
      return counting_->dispatches;
    }
    addClouds(test::sharedNoise());
    auto pass = std::make_unique<CountingPass>(*system_, folder_, clouds_);
    counting_ = pass.get();
    renderer().add(std::move(pass));
    cloudsFrom(view);
    return counting_->dispatches;
  }

 private:
  test::TemporaryFolder folder_;
  CountingPass* counting_ = nullptr;
};

TEST_F(CloudCountGLTest, noDispatchRunsMoreLoopsThanADriverAllows) {
  // In mist that rays go through for 60 km, several dispatches are needed. None runs a ray for more than 24
  // 000 turns of all its loops: steps, segments and samples to the sun. Rays that run together wait for the
  // slowest of them at each segment: 16 of them (what the widest software renderer runs at once) stay below
  // the 65 535 turns at which llvmpipe ends a loop.
  fillWithMist();
  const Dispatches& dispatches = countFrom(small({0, 2400, 0}, 40, 3));
  EXPECT_GT(dispatches.size(), 1u) << "proves little";
  const GLuint aSegment = static_cast<GLuint>(clouds_.march.sunSamples) + 1;
  GLuint mostOfRay = 0, mostOfGroup = 0;
  for (const std::vector<CountingPass::Ray>& rays : dispatches) {
    for (std::size_t first = 0; first < rays.size(); first += 16) {
      std::vector<GLuint> slowest;
      for (std::size_t i = first; i < first + 16; ++i) {
        const CountingPass::Ray& ray = rays[i];
        ASSERT_LT(ray.segments, CountingPass::kMostSegments - 1);
        GLuint turns = ray.segments * aSegment;
        if (slowest.size() <= ray.segments) slowest.resize(ray.segments + 1);
        for (std::size_t k = 0; k <= ray.segments; ++k) {
          turns += ray.steps[k];
          slowest[k] = std::max(slowest[k], ray.steps[k]);
        }
        mostOfRay = std::max(mostOfRay, turns);
      }
      GLuint turns = static_cast<GLuint>(slowest.size() - 1) * aSegment;
      for (const GLuint steps : slowest) turns += steps;
      mostOfGroup = std::max(mostOfGroup, turns);
    }
  }
  EXPECT_LE(mostOfRay, 24000u);
  EXPECT_GT(mostOfRay, 20000u) << "the bound was not met";
  EXPECT_LT(mostOfGroup, 65535u);
  RecordProperty("turnsOfARay", static_cast<int>(mostOfRay));
  RecordProperty("turnsOfAGroup", static_cast<int>(mostOfGroup));
}

TEST_F(CloudCountGLTest, theTiersToPlayWithNeedOneDispatch) {
  // Even in mist: so their marches need not be carried on, and the processor need not wait for the graphics
  // card.
  using enum clouds::CloudTier;
  fillWithMist();
  for (const clouds::CloudTier tier : {low, medium, high, ultra}) {
    EXPECT_EQ(countFrom(small({0, 2400, 0}, 40, 3), tier).size(), 1u) << static_cast<int>(tier);
  }
}

TEST_F(CloudCountGLTest, C24_aRayThatMeetsNothingKeepsTheFarMarker) {
  // The mean distance of light that is not there is 65 km, which a half float keeps; of light that is there
  // it lies where the clouds are.
  test::noFaults("C24", "violations");
  const Dispatches& dispatches = countFrom(small({0, 600, 0}, 40, 14));
  int met = 0, clear = 0;
  for (const CountingPass::Ray& ray : dispatches.back()) {
    if (ray.weight > 0) {
      ++met;
      ASSERT_TRUE(ray.distance > 900 && ray.distance < 60000) << ray.distance;
    } else {
      ++clear;
      ASSERT_EQ(ray.distance, 65000.0f);
    }
  }
  EXPECT_TRUE(met > 100 && clear > 100) << met << ' ' << clear;
}

}  // namespace
}  // namespace skydrop::render
