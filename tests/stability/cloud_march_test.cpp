// Light through clouds on the processor: the functions of shaders/shared/cloud_light.glsl and the reference
// march. C02, C03, C04, C09, C11, C21, C23, C24, C30; what a shader makes of them is judged in tests/gl.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vector_relational.hpp>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "skydrop/clouds/reference_march.h"
#include "skydrop/core/error.h"
#include "skydrop/core/hash.h"
#include "skydrop/core/shared.h"
#include "support/cloud_noise.h"
#include "support/margin.h"

namespace skydrop::clouds {
namespace {

namespace f32 = core::shared::f32;
namespace f64 = core::shared::f64;

using test::cloudySettings, test::quickNoise;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kFarMarker = 1e30;

MarchMedium slab(double extinction, double baseM = 1500, double topM = 2500) {
  return {[extinction](const glm::dvec3&) { return extinction; }, baseM, topM};
}

// A ray from below through the slab, 30 degrees above the horizon.
MarchRay slantedRay() { return {{40, 1000, -70}, glm::normalize(glm::dvec3(1.2, 1, -1.25))}; }

MarchLight afternoon() { return {glm::normalize(glm::dvec3(-0.5, 0.8, 0.3)), 0.2, 0.15}; }

void expectBackground(const MarchResult& result) {
  EXPECT_EQ(result.sun, 0);
  EXPECT_EQ(result.sky, 0);
  EXPECT_EQ(result.ground, 0);
  EXPECT_EQ(result.transmittance, 1);
  EXPECT_EQ(result.distanceM, kFarMarker);
}

bool isFinite(const MarchResult& result) {
  return std::isfinite(result.sun) && std::isfinite(result.sky) && std::isfinite(result.ground) &&
         std::isfinite(result.transmittance) && std::isfinite(result.distanceM);
}

// Adaptive Simpson quadrature (Lyness 1969): the march's own rule is nowhere in it.
template <class Function>
double integral(const Function& f, double a, double b, double tolerance) {
  const auto simpson = [](double fa, double fm, double fb, double width) {
    return width / 6 * (fa + 4 * fm + fb);
  };
  const auto halved = [&](const auto& self, double low, double high, double fl, double fm, double fh,
                          double whole, double allowed, int depth) -> double {
    const double middle = (low + high) / 2;
    const double fq = f((low + middle) / 2), fr = f((middle + high) / 2);
    const double left = simpson(fl, fq, fm, middle - low), right = simpson(fm, fr, fh, high - middle);
    const double change = left + right - whole;
    if (depth == 0 || std::abs(change) <= 15 * allowed) return left + right + change / 15;
    return self(self, low, middle, fl, fq, fm, left, allowed / 2, depth - 1) +
           self(self, middle, high, fm, fr, fh, right, allowed / 2, depth - 1);
  };
  const double fa = f(a), fm = f((a + b) / 2), fb = f(b);
  return halved(halved, a, b, fa, fm, fb, simpson(fa, fm, fb, b - a), tolerance, 40);
}

// Sun's light along a homogeneous segment that begins at `begin`, with the way out of it towards the sun.
template <class Way>
double sunThrough(double extinction, const MarchLight& light, const MarchRay& ray, double begin, double end,
                  const Way& wayToSun) {
  const f64::Vec4 phases =
      f64::cloudPhases(glm::dot(ray.direction, light.toSun), light.anisotropy, light.forwardShare);
  const auto source = [&](double t) {
    return extinction * std::exp(-extinction * (t - begin)) *
           f64::scatteredSun(phases, extinction * wayToSun(ray.origin + ray.direction * t));
  };
  return integral(source, begin, end, 1e-12);
}

TEST(Stability, C02_noExtinctionLeavesTheBackground) {
  // Exactly, from anywhere and for any number of steps.
  test::noFaults("C02", "violations");
  for (const int steps : {1, 16, 2048}) {
    expectBackground(referenceMarch(slab(0), afternoon(), slantedRay(), {steps, 4}));
    expectBackground(referenceMarch(slab(0), afternoon(), {{0, 2000, 0}, {1, 0, 0}, 0, 1e5}, {steps, 4}));
  }
}

TEST(Stability, C03_opacityOfAStepDoesNotCancel) {
  // Within 1e-5 relative of expm1 in double, from 1e-9 to 1e4: the series' own error is 2e-7, that of a float
  // exponential at 0.5 is 3e-6 on Mesa.
  EXPECT_TRUE(test::holdsLive("C03"));
}

TEST(Stability, C04_extinctionWithoutBoundTendsToTheSource) {
  // The ray sees the light where it enters, whatever the number of steps; none comes through.
  for (const double extinction : {1e30, kInfinite}) {
    EXPECT_EQ(f32::stepOpacity(static_cast<float>(extinction)), 1.0f);
    for (const int steps : {1, 7, 64, 1024}) {
      const MarchRay along{{0, 2100, 0}, {1, 0, 0}, 0, 5000};  // height fraction 0.6 all the way
      const MarchResult result = referenceMarch(slab(extinction), afternoon(), along, {steps, 16});
      ASSERT_TRUE(isFinite(result));
      EXPECT_EQ(result.transmittance, 0);
      EXPECT_TRUE(test::holds("C04", test::apart(result.sky / f64::scatteredSky(0.6), 1), test::atMost(1e-4),
                              "relative"))
          << steps;
      EXPECT_TRUE(test::holds("C04", test::apart(result.ground / f64::scatteredGround(0.6), 1),
                              test::atMost(1e-4), "relative"))
          << steps;
      EXPECT_TRUE(test::holds("C04", test::apart(result.sun, 0), test::atMost(1e-12), "light"))
          << "light through an opaque layer";
      EXPECT_TRUE(test::holds("C04", test::apart(result.distanceM, 2500.0 / steps), test::atMost(1e-9), "m"))
          << "not in the first step";
    }
    // Level with the sun's way out nothing is in between: the source is all of the sun.
    const MarchMedium sheet{[=](const glm::dvec3& place) { return place.y > 2499.9 ? 0 : extinction; }, 1500,
                            2500};
    const MarchLight zenith{{0, 1, 0}, 0.2, 0.15};
    const MarchRay grazing{{0, 2499.9, 0}, {1, 0, 0}, 0, 5000};
    const f64::Vec4 phases = f64::cloudPhases(0, zenith.anisotropy, zenith.forwardShare);
    EXPECT_TRUE(test::holds(
        "C04",
        test::apart(referenceMarch(sheet, zenith, grazing, {3, 8}).sun / f64::scatteredSun(phases, 0), 1),
        test::atMost(1e-4), "relative"));
  }
}

// The interval of a ray in a closed box, by looking at the middle of every piece between crossings of planes.
struct LightSegment {
  double begin = 0, end = 0;
  bool isHit() const { return end > begin; }
};

LightSegment searchedStretch(const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3& low,
                             const glm::dvec3& high) {
  std::vector<double> crossings{0};
  for (int axis = 0; axis < 3; ++axis) {
    for (const double plane : {low[axis], high[axis]}) {
      const double t = (plane - origin[axis]) / direction[axis];
      if (std::isfinite(t) && t > 0) crossings.push_back(t);
    }
  }
  std::ranges::sort(crossings);
  LightSegment found;
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
    const glm::dvec3 middle = origin + direction * ((crossings[i] + crossings[i + 1]) / 2);
    const bool isInside =
        glm::all(glm::lessThanEqual(low, middle)) && glm::all(glm::lessThanEqual(middle, high));
    if (!isInside || crossings[i] == crossings[i + 1]) continue;
    if (!found.isHit()) found.begin = crossings[i];
    found.end = crossings[i + 1];
  }
  return found;
}

// Whether the box is hit; the interval in floats is held to the one searched for.
bool hitOf(const glm::vec3& origin, const glm::vec3& direction, const glm::vec3& low, const glm::vec3& high,
           float scale) {
  const f32::RaySpan span = f32::raySpanOfBox(origin, direction, low, high);
  const LightSegment exact =
      searchedStretch(glm::dvec3(origin), glm::dvec3(direction), glm::dvec3(low), glm::dvec3(high));
  const auto where = [&] {
    std::ostringstream text;
    for (const glm::vec3& v : {origin, direction, low, high}) text << v.x << ' ' << v.y << ' ' << v.z << "; ";
    return text.str();
  };
  EXPECT_EQ(span.end > span.begin, exact.isHit()) << where();
  if (!exact.isHit()) return false;
  EXPECT_NEAR(span.begin, exact.begin, 1e-4 * scale) << where();
  EXPECT_NEAR(span.end, exact.end, 1e-4 * scale) << where();
  return true;
}

TEST(Stability, C09_intervalInABoxIsThatOfASearchInDoubles) {
  // A million random rays at scales from a metre to a hundred kilometres; floats.
  test::noFaults("C09", "violations");
  core::RandomStream random{1, 0};
  const auto unit = [&] { return static_cast<float>(2 * random.nextUnit() - 1); };
  const auto vector = [&] { return glm::vec3(unit(), unit(), unit()); };
  int hits = 0;
  for (int i = 0; i < 1000000; ++i) {
    const float scale = std::array{1.0f, 37.0f, 1e3f, 1e5f}[static_cast<std::size_t>(i % 4)];
    const glm::vec3 a = vector() * scale, b = vector() * scale, origin = vector() * (2 * scale);
    // Aimed at a place in the box or a little beside it.
    const glm::vec3 aim = (a + b) * 0.5f + vector() * (a - b) * 0.7f;
    const glm::vec3 direction = f32::directionOf(aim - origin, {0, 1, 0});
    hits += hitOf(origin, direction, glm::min(a, b), glm::max(a, b), scale);
    if (HasFailure()) return;
  }
  EXPECT_TRUE(hits > 300000 && hits < 900000) << hits;
}

TEST(Stability, C09_raysAlongFacesEdgesAndThroughCornersAreNoLuck) {
  // Every ray from a lattice that holds the faces, edges and corners of the box, inside and out, in every
  // direction between lattice points: parallel to faces, in faces, along edges, through corners. All numbers
  // are exact in 32 bits. A box without thickness is a sheet, one turned inside out is empty.
  test::noFaults("C09", "violations");
  const std::array<float, 7> lattice = {-2, -1, -0.5f, 0, 0.5f, 1, 2};
  const std::array<float, 5> steps = {-2, -1, 0, 1, 2};
  const auto points = [](const auto& values, const auto& visit) {
    for (const float x : values) {
      for (const float y : values) {
        for (const float z : values) visit(glm::vec3(x, y, z));
      }
    }
  };
  const glm::vec3 one(1);
  int hits = 0;
  for (const glm::vec3& thickness : {one, glm::vec3(1, 0, 1)}) {
    points(lattice, [&](const glm::vec3& origin) {
      points(steps, [&](const glm::vec3& direction) {
        if (direction == glm::vec3(0)) return;
        hits += hitOf(origin, direction, -thickness, thickness, 1);
        const f32::RaySpan none = f32::raySpanOfBox(origin, direction, one, -one);
        ASSERT_FALSE(none.end > none.begin);
      });
    });
  }
  EXPECT_GT(hits, 5000);
  // From a corner along an edge: the whole edge; away from it: nothing; touching a corner: nothing.
  const f32::RaySpan edge = f32::raySpanOfBox(-one, {1, 0, 0}, -one, one);
  EXPECT_TRUE(edge.begin == 0 && edge.end == 2);
  const f32::RaySpan touch = f32::raySpanOfBox({-2, 0, 1}, {1, 1, 0}, -one, one);
  EXPECT_FALSE(touch.end > touch.begin);
}

TEST(Stability, C11_noStepsOrNoLengthLeaveTheBackground) {
  test::noFaults("C11", "violations");
  const MarchMedium medium = slab(0.05);
  expectBackground(referenceMarch(medium, afternoon(), slantedRay(), {0, 16}));
  expectBackground(referenceMarch(medium, afternoon(), slantedRay(), {-3, 16}));
  MarchRay ray = slantedRay();
  for (const auto& [begin, end] :
       {std::array{1200.0, 1200.0}, {1500.0, 1200.0}, {0.0, 0.0}, {0.0, -5.0}, {0.0, 999.0}, {1e6, 1e30}}) {
    ray.beginM = begin;
    ray.endM = end;
    expectBackground(referenceMarch(medium, afternoon(), ray));
  }
  // No samples towards the sun: nothing is in its way.
  const MarchResult open = referenceMarch(medium, afternoon(), slantedRay(), {64, 0});
  EXPECT_TRUE(isFinite(open) && open.sun > 0);
}

TEST(Stability, C21_sunBelowTheHorizonLightsNothingAndTheZenithIsNoSpecialCase) {
  const MarchMedium medium = slab(0.004);
  const MarchSteps steps{64, 16};
  for (const glm::dvec3& toSun :
       {glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::normalize(glm::dvec3(1, -0.3, 2))}) {
    const MarchResult result = referenceMarch(medium, {toSun, 0.2, 0.15}, slantedRay(), steps);
    EXPECT_EQ(result.sun, 0);
    EXPECT_TRUE(isFinite(result) && result.sky > 0 && result.ground > 0);
  }
  for (const glm::dvec3& view : {glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0), glm::dvec3(1, 0, 0)}) {
    const MarchResult result =
        referenceMarch(medium, {{0, 1, 0}, 0.95, 1}, {{0, 2000, 0}, view, 0, 4000}, steps);
    EXPECT_TRUE(isFinite(result) && result.sun > 0 && result.transmittance < 0.2);
  }
  // A grazing sun is worked out at 2 degrees, from its own compass direction.
  const glm::dvec3 place(0, 2400, 0);
  const double grazing = sunDepth(medium, glm::normalize(glm::dvec3(-1, 1e-6, 1)), place, 8);
  EXPECT_TRUE(test::holds("C21", test::apart(grazing, 0.004 * 100 / f64::kLeastSunSine), test::atMost(1e-9),
                          "of optical depth"));
  const MarchMedium westOnly{[](const glm::dvec3& at) { return at.x < 0 ? 0.004 : 0.0; }, 1500, 2500};
  EXPECT_GT(sunDepth(westOnly, glm::dvec3(-1, 0, 0), place, 8), 10);
  EXPECT_EQ(sunDepth(westOnly, glm::dvec3(1, 0, 0), place, 8), 0);

  for (const glm::dvec3& wrong : {glm::dvec3(0), glm::dvec3(0, 2, 0), glm::dvec3(0, std::nan(""), 0)}) {
    EXPECT_THROW(referenceMarch(medium, {wrong, 0, 0}, slantedRay(), steps), core::RangeError);
    EXPECT_THROW(referenceMarch(medium, afternoon(), {{0, 0, 0}, wrong}, steps), core::RangeError);
    EXPECT_THROW(sunDepth(medium, wrong, place, 8), core::RangeError);
  }
}

TEST(Stability, C23_deepAndDenormalDepthsNeitherStallNorGrow) {
  // An optical depth of 200 lets at most 1e-38 through; no exponent is positive, so no light is more than its
  // phases; denormals count as little as they are.
  for (const int steps : {1, 10, 2048}) {
    const MarchResult deep = referenceMarch(slab(0.2), afternoon(), {{0, 1500, 0}, {0, 1, 0}}, {steps, 64});
    EXPECT_LE(deep.transmittance, 1e-38);
    EXPECT_TRUE(test::holds("C23", test::apart(deep.transmittance / std::exp(-200), 1), test::atMost(1e-9),
                            "relative"));
    EXPECT_TRUE(isFinite(deep));
  }
  const f32::Vec4 phases = f32::cloudPhases(0.7f, 0.3f, 0.2f);
  const float all = phases.x + phases.y + phases.z + phases.w;
  for (const float depth : {-1e30f, -1.0f, -1e-40f, 0.0f, 1e-40f, 1e-45f, 200.0f, 1e30f}) {
    const float opacity = f32::stepOpacity(depth), light = f32::scatteredSun(phases, depth);
    EXPECT_TRUE(opacity >= 0 && opacity <= 1) << depth;
    EXPECT_TRUE(light >= 0 && light <= all) << depth;
  }
  EXPECT_EQ(f32::stepOpacity(std::numeric_limits<float>::quiet_NaN()), 0);
  for (const double extinction : {5e-324, 1e-310, 1e-300}) {
    const MarchResult thin = referenceMarch(slab(extinction), afternoon(), slantedRay(), {64, 16});
    EXPECT_EQ(thin.transmittance, 1);
    EXPECT_TRUE(isFinite(thin) && thin.sun < 1e-290);
    EXPECT_TRUE(thin.distanceM > 800 && thin.distanceM < 4000) << thin.distanceM;
  }
}

TEST(Stability, C24_rayThatMeetsNothingHasTheFarMarker) {
  // Nothing is averaged over no samples.
  test::noFaults("C24", "violations");
  const MarchMedium medium = slab(0.05);
  for (const MarchRay& ray : {MarchRay{{0, 1000, 0}, {0, -1, 0}}, MarchRay{{0, 3000, 0}, {1, 0, 0}},
                              MarchRay{{0, 3000, 0}, {0, 1, 0}}, MarchRay{{1e7, 0, -1e7}, {0, 0, 1}}}) {
    expectBackground(referenceMarch(medium, afternoon(), ray, {64, 8}));
  }
  MarchMedium faded = medium;
  faded.fadeDistanceM = 900;  // the layer begins farther away
  expectBackground(referenceMarch(faded, afternoon(), slantedRay(), {64, 8}));
  faded.fadeDistanceM = 0;
  expectBackground(referenceMarch(faded, afternoon(), {{0, 2000, 0}, {1, 0, 0}}, {64, 8}));
}

TEST(Stability, C30_layersWithoutThicknessAreEmptyAndCoincidentOnesAddUp) {
  for (const double top : {1500.0, 1499.0, -1e9}) {
    expectBackground(referenceMarch(slab(0.05, 1500, top), afternoon(), slantedRay(), {64, 8}));
    expectBackground(referenceMarch(slab(0.05, 1500, top), afternoon(), {{0, 1500, 0}, {1, 0, 0}}, {64, 8}));
    EXPECT_EQ(sunDepth(slab(0.05, 1500, top), {0, 1, 0}, {0, 1500, 0}, 8), 0);
  }
  // Two layers of one place against one of the summed extinction: within 1e-4.
  CloudSettings thin = cloudySettings(), thick = cloudySettings(), both = cloudySettings();
  thin.layers[0].extinction = 0.01;
  thick.layers[0].extinction = 0.03;
  both.layers[0].extinction = 0.04;
  const CloudField first(quickNoise(), thin), second(quickNoise(), thick), sum(quickNoise(), both);
  MarchMedium overlapping = mediumOf(first);
  overlapping.extinction = [a = mediumOf(first).extinction, b = mediumOf(second).extinction](
                               const glm::dvec3& place) { return a(place) + b(place); };
  int clouds = 0;
  for (int i = 0; i < 40; ++i) {
    const MarchRay ray{{i * 977.0, 1000, i * -391.0}, glm::normalize(glm::dvec3(1, 0.7, 0.1 * i - 2))};
    const MarchResult a = referenceMarch(overlapping, afternoon(), ray, {256, 16});
    const MarchResult b = referenceMarch(mediumOf(sum), afternoon(), ray, {256, 16});
    ASSERT_TRUE(test::holds("C30", test::apart(a.sun, b.sun), test::atMost(1e-4), "of 1"));
    ASSERT_TRUE(test::holds("C30", test::apart(a.sky, b.sky), test::atMost(1e-4), "of 1"));
    ASSERT_TRUE(
        test::holds("C30", test::apart(a.transmittance, b.transmittance), test::atMost(1e-4), "of 1"));
    clouds += b.transmittance < 0.9;
  }
  EXPECT_GT(clouds, 5) << "proves little";
}

TEST(CloudMarch, aHomogeneousSlabHasItsClosedForm) {
  // Transmittance to 1e-12; the sun's octaves against adaptive quadrature, in which the way to the sun is
  // exact: the midpoint rule's own error with 2048 steps is 1e-6.
  for (const double extinction : {1e-5, 0.001, 0.01}) {
    const MarchRay ray = slantedRay();
    const MarchLight light = afternoon();
    const MarchResult result = referenceMarch(slab(extinction), light, ray);
    const double begin = 500 / ray.direction.y, end = 1500 / ray.direction.y;
    EXPECT_NEAR(result.transmittance, std::exp(-extinction * (end - begin)), 1e-12);
    const double sun = sunThrough(extinction, light, ray, begin, end,
                                  [&](const glm::dvec3& place) { return (2500 - place.y) / light.toSun.y; });
    EXPECT_NEAR(result.sun / sun, 1, 2e-6) << extinction;
    const double sky = integral(
        [&](double t) {
          return extinction * std::exp(-extinction * (t - begin)) *
                 f64::scatteredSky((ray.direction.y * t - 500) / 1000);
        },
        begin, end, 1e-13);
    EXPECT_NEAR(result.sky / sky, 1, 2e-6) << extinction;
    EXPECT_GT(result.distanceM, begin);
    EXPECT_LT(result.distanceM, (begin + end) / 2);
  }
}

TEST(CloudMarch, aHomogeneousBoxHasItsClosedForm) {
  // A block of cloud 800 m wide and deep inside the layer. With the sun overhead its light leaves through the
  // top; from the side through walls, where the last sample towards the sun is half in and half out: 128
  // samples find a wall to 1 % of the way.
  const glm::dvec3 low(-400, 1500, -400), high(400, 2500, 400);
  const double extinction = 0.004;
  const MarchMedium box{[=](const glm::dvec3& place) {
                          const bool isIn = std::abs(place.x) <= 400 && std::abs(place.z) <= 400;
                          return isIn ? extinction : 0.0;
                        },
                        low.y, high.y};
  for (const glm::dvec3& toSun : {glm::dvec3(0, 1, 0), afternoon().toSun}) {
    const MarchLight light{toSun, 0.2, 0.15};
    for (const glm::dvec3& aim :
         {glm::dvec3(0, 1900, 0), glm::dvec3(200, 2300, -100), glm::dvec3(-350, 1600, 300)}) {
      MarchRay ray{{-2000, 1200, 1500}, {}};
      ray.direction = glm::normalize(aim - ray.origin);
      const f64::RaySpan span = f64::raySpanOfBox(ray.origin, ray.direction, low, high);
      ASSERT_GT(span.end, span.begin);
      ray.beginM = span.begin;
      ray.endM = span.end;
      const MarchResult result = referenceMarch(box, light, ray);
      EXPECT_NEAR(result.transmittance, std::exp(-extinction * (span.end - span.begin)), 1e-12);
      const double sun =
          sunThrough(extinction, light, ray, span.begin, span.end, [&](const glm::dvec3& place) {
            double way = kInfinite;
            for (int axis = 0; axis < 3; ++axis) {
              const double wall = toSun[axis] > 0 ? high[axis] : low[axis];
              if (toSun[axis] != 0) way = std::min(way, (wall - place[axis]) / toSun[axis]);
            }
            return std::max(way, 0.0);
          });
      EXPECT_NEAR(result.sun / sun, 1, toSun.y == 1 ? 2e-6 : 2e-3);
    }
  }
}

TEST(CloudMarch, theMidpointMarchIsOfSecondOrder) {
  // Halving the steps divides the error by four: in a smooth medium, along the view ray with the samples to
  // the sun held, and along the way to the sun alone.
  const MarchMedium smooth{[](const glm::dvec3& place) {
                             const double height = (place.y - 1500) / 1000;
                             return 0.004 * (0.2 + height) * (1.3 - height) *
                                    (2 + std::sin(place.x / 310) * std::cos(place.z / 270));
                           },
                           1500, 2500};
  const MarchRay ray = slantedRay();
  const MarchResult exact = referenceMarch(smooth, afternoon(), ray, {16384, 24});
  const auto errors = [&](int steps) {
    const MarchResult result = referenceMarch(smooth, afternoon(), ray, {steps, 24});
    return std::array{std::abs(result.sun - exact.sun), std::abs(result.sky - exact.sky),
                      std::abs(result.transmittance - exact.transmittance),
                      std::abs(result.distanceM - exact.distanceM)};
  };
  const auto coarse = errors(64), fine = errors(256);
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    const double order = std::log2(coarse[i] / fine[i]) / 2;
    EXPECT_GE(order, 1.9) << i;
    RecordProperty("order" + std::to_string(i), std::to_string(order));
  }
  const auto sunError = [&](int samples) {
    const glm::dvec3 place(100, 1700, 50);
    return std::abs(sunDepth(smooth, afternoon().toSun, place, samples) -
                    sunDepth(smooth, afternoon().toSun, place, 1 << 16));
  };
  EXPECT_GE(std::log2(sunError(16) / sunError(64)) / 2, 1.9);
}

TEST(CloudMarch, fadingThinsTheViewAndNotTheShade) {
  // The optical depth of a level ray is that of the faded extinction; light on its way to the sun meets all.
  MarchMedium medium = slab(0.002);
  medium.fadeDistanceM = 4000;
  const MarchRay level{{0, 2000, 0}, {0, 0, -1}};
  const double depth = integral([](double t) { return 0.002 * f64::cloudFade(t, 4000); }, 0, 4000, 1e-13);
  const MarchLight zenith{{0, 1, 0}, 0, 0};
  const MarchResult result = referenceMarch(medium, zenith, level);
  EXPECT_NEAR(result.transmittance, std::exp(-depth), 1e-9);
  const f64::Vec4 phases = f64::cloudPhases(0, 0, 0);
  EXPECT_NEAR(result.sun, (1 - result.transmittance) * f64::scatteredSun(phases, 0.002 * 500), 1e-9);
}

TEST(CloudMarch, aFieldIsMarchedWithItsExtinctionAndItsHeights) {
  const CloudSettings settings = cloudySettings();
  const CloudField field(quickNoise(), settings);
  const MarchMedium medium = mediumOf(field);
  EXPECT_EQ(medium.baseM, settings.layers[0].cloudHeight);
  EXPECT_EQ(medium.topM, settings.layers[0].cloudHeight + settings.layers[0].thickness);
  EXPECT_EQ(medium.fadeDistanceM, settings.fadeDistance);
  core::RandomStream random{7, 0};
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 place(random.nextUnit() * 5e4, 1555 + random.nextUnit() * 1800, random.nextUnit() * 5e4);
    ASSERT_EQ(medium.extinction(place), field.density(place) * settings.layers[0].extinction);
  }
}

}  // namespace
}  // namespace skydrop::clouds
