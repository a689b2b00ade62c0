// The judge of light in clouds against what is known without it: closed forms, balances of energy. C81 to
// C85.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <limits>
#include <vector>

#include "skydrop/clouds/path_tracer.h"
#include "skydrop/core/error.h"
#include "skydrop/core/hash.h"
#include "skydrop/core/job_pool.h"
#include "skydrop/core/shared.h"
#include "support/cloud_noise.h"
#include "support/instrumented.h"
#include "support/margin.h"

namespace skydrop::clouds {
namespace {

namespace f64 = core::shared::f64;
using test::cloudySettings, test::quickNoise;

constexpr double kPi = glm::pi<double>();
constexpr double kBaseM = 1000, kTopM = 2000;
constexpr TracedPhase kEven{};
constexpr TracedPhase kTwoLobes{0.119, 0.15, 0.85, 1};

TracedMedium slab(double depth) { return homogeneousMedium(depth / (kTopM - kBaseM), kBaseM, kTopM); }

glm::dvec3 sunAt(double degrees) {
  return {std::cos(glm::radians(degrees)), std::sin(glm::radians(degrees)), 0};
}

MarchRay upwards(double sine, double x = 0, double z = 0) {
  return {{x, 0, z}, {0, sine, std::sqrt(1 - sine * sine)}};
}

// A direction about an axis, by the cosine law.
glm::dvec3 cosineLaw(const glm::dvec3& axis, core::RandomStream& random) {
  const double sineSquare = random.nextUnit(), turn = 2 * kPi * random.nextUnit();
  const glm::dvec3 u = glm::normalize(
                       glm::cross(axis, std::abs(axis.y) < 0.5 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0))),
                   v = glm::cross(axis, u);
  return glm::normalize(std::sqrt(sineSquare) * (std::cos(turn) * u + std::sin(turn) * v) +
                        std::sqrt(1 - sineSquare) * axis);
}

TracedLight meanOf(int paths, const std::function<TracedLight(core::RandomStream&)>& path) {
  TracedLight sum{0, 0, 0, 0};
  for (int i = 0; i < paths; ++i) {
    core::RandomStream random{core::hashCombine(11, static_cast<std::uint64_t>(i)), 0};
    const TracedLight light = path(random);
    sum.sun += light.sun / paths;
    sum.sky += light.sky / paths;
    sum.ground += light.ground / paths;
    sum.transmittance += light.transmittance / paths;
  }
  return sum;
}

// Light that leaves the layer upwards and downwards, W a square metre for W a square metre of each source,
// scattered; transmittance: that of the rays that it was asked along.
struct Leaving {
  TracedLight up, down;
};
Leaving leaving(const TracedMedium& medium, const TracedPhase& phase, const glm::dvec3& toSun, int paths,
                double sideM = 0) {
  const auto through = [&](double height, double normal) {
    const auto mean = meanOf(paths, [&](core::RandomStream& random) {
      const glm::dvec3 place(sideM * random.nextUnit(), height, sideM * random.nextUnit());
      const glm::dvec3 out = cosineLaw({0, normal, 0}, random);
      return tracePath(medium, phase, toSun, {place, -out}, random);
    });
    return TracedLight{mean.sun * kPi, mean.sky * kPi, mean.ground * kPi, mean.transmittance};
  };
  return {through(medium.topM, 1), through(medium.baseM, -1)};
}

TEST(CloudPathTracer, transmittanceOfASlabIsExact) {
  // Within 4 standard errors of exp(-depth / sine), for thin and thick slabs, straight up and slanted.
  for (const double depth : {0.01, 0.5, 3.0}) {
    for (const double sine : {1.0, 0.4}) {
      const MarchRay ray = upwards(sine);
      const auto pixel =
          traceRays(slab(depth), kEven, sunAt(40), {&ray, 1}, test::repetitions(40000), 3).front();
      EXPECT_NEAR(pixel.mean.transmittance, std::exp(-depth / sine), 4 * pixel.error.transmittance + 1e-9);
      core::RandomStream random{5, 0};
      double sum = 0;
      const int ways = test::repetitions(40000);
      for (int i = 0; i < ways; ++i)
        sum += ratioTrackedTransmittance(slab(depth), ray.origin, ray.direction, 1e9, random);
      EXPECT_NEAR(sum / ways, std::exp(-depth / sine), 4.0 / std::sqrt(ways));
    }
  }
}

TEST(CloudPathTracer, singleScatteringOfASlabIsTheClosedForm) {
  // phase * sin_sun / (sin_sun + sin_view) (1 - exp(-depth (1 / sin_sun + 1 / sin_view))) for light that
  // comes back: extrapolated to no albedo, where light scatters once. Within 2 %.
  const double depth = 0.4, sineOfSun = 0.6, sineOfView = 0.8;
  const glm::dvec3 toSun(0.8, sineOfSun, 0);
  const MarchRay down{{0, 5000, 0}, {0, -sineOfView, 0.6}};
  const auto perAlbedo = [&](double albedo) {
    TracedPhase phase = kTwoLobes;
    phase.albedo = albedo;
    return traceRays(slab(depth), phase, toSun, {&down, 1}, test::repetitions(200000), 7).front().mean.sun /
           albedo;
  };
  const double cosine = glm::dot(down.direction, toSun);
  const double phase =
      std::lerp(f64::henyeyGreenstein(cosine, kTwoLobes.anisotropy),
                f64::henyeyGreenstein(cosine, kTwoLobes.forwardAnisotropy), kTwoLobes.forwardShare);
  const double exact =
      phase * sineOfSun / (sineOfSun + sineOfView) * -std::expm1(-depth * (1 / sineOfSun + 1 / sineOfView));
  EXPECT_NEAR((2 * perAlbedo(0.1) - perAlbedo(0.2)) / exact, 1, test::kInstrumented ? 0.1 : 0.02);
}

TEST(Stability, C81_energyInIsEnergyOutWithoutAbsorption) {
  // A slab and the game's medium, albedo 1: what sun, sky and ground bring leaves again, within 1 %.
  const CloudField field(quickNoise(), cloudySettings());
  const double tolerance = test::kInstrumented ? 0.1 : 0.01;
  for (const double degrees : {40.0, 10.0}) {
    const glm::dvec3 toSun = sunAt(degrees);
    const Leaving out = leaving(slab(2), kTwoLobes, toSun, test::repetitions(60000));
    const double direct = std::exp(-2 / toSun.y) * toSun.y;
    EXPECT_TRUE(test::holds("C81", test::apart((out.up.sun + out.down.sun + direct) / toSun.y, 1),
                            test::atMost(tolerance), "of the energy"))
        << degrees;
    EXPECT_TRUE(test::holds("C81", test::apart(out.up.sky + out.down.sky + out.down.transmittance, 1),
                            test::atMost(tolerance), "of the energy"));
    EXPECT_TRUE(test::holds("C81", test::apart(out.up.ground + out.down.ground + out.up.transmittance, 1),
                            test::atMost(tolerance), "of the energy"));
  }
  const TracedMedium medium = tracedMediumOf(field);
  const glm::dvec3 toSun = sunAt(40);
  const double period = weatherPeriod(field.medium());
  const Leaving out = leaving(medium, kTwoLobes, toSun, test::repetitions(30000), period);
  const double direct =
      toSun.y *
      meanOf(test::repetitions(30000), [&](core::RandomStream& random) {
        const glm::dvec3 place(period * random.nextUnit(), medium.baseM, period * random.nextUnit());
        TracedLight light;
        light.transmittance = ratioTrackedTransmittance(medium, place, toSun, 1e9, random);
        return light;
      }).transmittance;
  EXPECT_LT(direct / toSun.y, 0.95) << "no cloud to speak of";
  EXPECT_TRUE(test::holds("C81", test::apart((out.up.sun + out.down.sun + direct) / toSun.y, 1),
                          test::atMost(tolerance), "of the energy"));
  EXPECT_TRUE(test::holds("C81", test::apart(out.up.sky + out.down.sky + out.down.transmittance, 1),
                          test::atMost(tolerance), "of the energy"));
}

TEST(Stability, C82_energyInIsEnergyOutOfAClosedBox) {
  // A box of cloud in clear air, albedo 1, depth 4 across: what the sun sends onto its faces and does not
  // come straight through leaves scattered through all six. Within 1 %.
  constexpr double kSide = 1000;
  const double extinction = 4 / kSide;
  const auto inBox = [=](const glm::dvec3& p) {
    return p.x >= 0 && p.x <= kSide && p.z >= 0 && p.z <= kSide ? extinction : 0.0;
  };
  const TracedMedium box{
      inBox, kBaseM, kTopM,
      std::make_shared<const ExtinctionBounds>(inBox, kBaseM, kTopM, 4 * kSide, kSide / 4, kSide / 4)};
  const glm::dvec3 toSun = glm::normalize(glm::dvec3(0.5, 0.7, 0.3));
  double in = 0, out = 0;
  for (int face = 0; face < 6; ++face) {
    glm::dvec3 normal(0);
    normal[face / 2] = face % 2 == 0 ? 1 : -1;
    const auto placeOn = [&](core::RandomStream& random) {
      glm::dvec3 place(random.nextUnit(), random.nextUnit(), random.nextUnit());
      place[face / 2] = face % 2 == 0 ? 1 - 1e-9 : 1e-9;
      return place * kSide + glm::dvec3(0, kBaseM, 0);
    };
    const int paths = test::repetitions(60000);
    out += kPi * meanOf(paths, [&](core::RandomStream& random) {
                   const glm::dvec3 place = placeOn(random), direction = cosineLaw(normal, random);
                   return tracePath(box, kTwoLobes, toSun, {place, -direction}, random);
                 }).sun;
    const double lit = glm::dot(normal, toSun);
    if (lit <= 0) continue;
    in += lit * (1 - meanOf(paths, [&](core::RandomStream& random) {
                       TracedLight light;
                       light.transmittance =
                           ratioTrackedTransmittance(box, placeOn(random), -toSun, 1e9, random);
                       return light;
                     }).transmittance);
  }
  EXPECT_TRUE(test::holds("C82", test::apart(out / in, 1), test::atMost(test::kInstrumented ? 0.1 : 0.01),
                          "of the energy"));
}

TEST(CloudPathTracer, aThickSlabPassesWhatDiffusionSays) {
  // Of an even sky 4 / (3 (depth + 1.4209)) comes through a slab that scatters evenly (Milne's problem, whose
  // extrapolation length is 0.7104), and with a mean cosine g as much as through one of (1 - g) times the
  // depth. Within 2 % and 4 %.
  const auto passed = [](double depth, const TracedPhase& phase) {
    const Leaving out = leaving(slab(depth), phase, sunAt(40), test::repetitions(60000));
    return out.down.sky + out.down.transmittance;
  };
  const double tolerance = test::kInstrumented ? 0.2 : 0.02;
  EXPECT_NEAR(passed(10, kEven) / (4 / (3 * (10 + 1.4209))), 1, tolerance);
  EXPECT_NEAR(passed(20, {0.5, 0, 0, 1}) / (4 / (3 * (10 + 1.4209))), 1, 2 * tolerance);
}

TEST(Stability, C83_albedo0And1AndExtinction0And10) {
  // Nothing scatters without albedo; there is nothing without extinction; a wall of 10 /m under an even sky
  // and ground is as bright as they are (albedo 1), and none of it comes through.
  const MarchRay ray = upwards(0.7);
  TracedPhase black = kTwoLobes;
  black.albedo = 0;
  const auto dark = traceRays(slab(2), black, sunAt(40), {&ray, 1}, 500, 1).front().mean;
  EXPECT_EQ(dark.sun, 0);
  EXPECT_EQ(dark.sky, 0);
  EXPECT_EQ(dark.ground, 0);
  const auto clear = traceRays(slab(0), kTwoLobes, sunAt(40), {&ray, 1}, 500, 1).front().mean;
  EXPECT_EQ(clear.sun, 0);
  EXPECT_EQ(clear.sky, 0);
  EXPECT_EQ(clear.transmittance, 1);
  const TracedMedium wall = homogeneousMedium(10, kBaseM, kBaseM + 2);
  const MarchRay below{{0, kBaseM - 10, 0}, {0, 1, 0}};
  const auto lit = traceRays(wall, kTwoLobes, sunAt(40), {&below, 1}, test::repetitions(4000), 1).front();
  EXPECT_TRUE(test::holds("C83", test::apart((lit.mean.sky + lit.mean.ground) * kPi, 1), test::atMost(1e-9),
                          "of the energy"));
  EXPECT_TRUE(test::holds("C83", lit.mean.transmittance, test::below(1e-3), "transmittance"));
  // Weights that are not one: the game's medium, lit evenly from all sides, is invisible.
  const CloudField field(quickNoise(), cloudySettings());
  const TracedMedium medium = tracedMediumOf(field);
  const auto seen = traceRays(medium, kTwoLobes, sunAt(40), {&ray, 1}, test::repetitions(4000), 1).front();
  EXPECT_TRUE(test::holds("C83",
                          test::apart((seen.mean.sky + seen.mean.ground) * kPi + seen.mean.transmittance, 1),
                          test::atMost(0.02), "of the energy"));
}

TEST(Stability, C84_theSunAtTheHorizonAndAtTheZenith) {
  // Finite, and dark from the horizon on.
  test::noFaults("C84", "violations");
  const CloudField field(quickNoise(), cloudySettings());
  const TracedMedium medium = tracedMediumOf(field);
  std::vector<MarchRay> rays;
  for (int i = 0; i < 8; ++i) rays.push_back(upwards(0.3 + 0.08 * i, 3000.0 * i));
  const auto sumOf = [&](const glm::dvec3& toSun) {
    double sum = 0;
    for (const TracedPixel& pixel : traceRays(medium, kTwoLobes, toSun, rays, 200, 1)) {
      EXPECT_TRUE(std::isfinite(pixel.mean.sun) && std::isfinite(pixel.error.sun));
      sum += pixel.mean.sun;
    }
    return sum;
  };
  EXPECT_GT(sumOf({0, 1, 0}), 0);
  EXPECT_GT(sumOf(sunAt(0.01)), 0);
  EXPECT_EQ(sumOf({1, 0, 0}), 0);
  EXPECT_EQ(sumOf(sunAt(-3)), 0);
}

TEST(Stability, C85_farAwayThePathsAreTheSame) {
  // A whole number of periods away, to 1e9 m, what comes of the same paths differs by rounding alone.
  const CloudField field(quickNoise(), cloudySettings());
  const TracedMedium medium = tracedMediumOf(field);
  const double period = weatherPeriod(field.medium());
  const auto at = [&](double x) {
    const MarchRay ray = upwards(0.6, x, 700);
    return traceRays(medium, kTwoLobes, sunAt(30), {&ray, 1}, 400, 1).front();
  };
  const TracedPixel here = at(0), there = at(std::round(1e9 / period) * period);
  EXPECT_GT(here.mean.sun, 0);
  EXPECT_TRUE(test::holds("C85", test::apart(there.mean.sun, here.mean.sun),
                          test::atMost(4 * (here.error.sun + there.error.sun)), "light"));
  EXPECT_TRUE(test::holds("C85", test::apart(there.mean.transmittance, here.mean.transmittance),
                          test::atMost(4 * here.error.transmittance + 1e-9), "transmittance"));
}

TEST(CloudPathTracer, errorBarsHoldWhatMorePathsFind) {
  // Of 64 rays of 200 paths each, about as many lie within one and two standard errors of 3000 paths as of a
  // normal distribution: at least half and four fifths.
  const CloudField field(quickNoise(), cloudySettings());
  const TracedMedium medium = tracedMediumOf(field);
  std::vector<MarchRay> rays;
  for (int i = 0; i < 64; ++i) rays.push_back(upwards(0.5, 900.0 * i));
  const auto few = traceRays(medium, kTwoLobes, sunAt(40), rays, 200, 1),
             many = traceRays(medium, kTwoLobes, sunAt(40), rays, test::repetitions(3000), 2);
  int seen = 0, within1 = 0, within2 = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (many[i].mean.transmittance > 0.9) continue;
    const double error = std::hypot(few[i].error.sun, many[i].error.sun);
    const double off = std::abs(few[i].mean.sun - many[i].mean.sun);
    ++seen;
    within1 += off < error ? 1 : 0;
    within2 += off < 2 * error ? 1 : 0;
  }
  ASSERT_GT(seen, 15);
  EXPECT_GT(within1, seen / 2);
  EXPECT_GT(within2, seen * 4 / 5);
}

TEST(CloudPathTracer, thePicturesBitsDoNotHangOnTheWorkers) {
  // Bit for bit: alone, with one worker, with three.
  const CloudField field(quickNoise(), cloudySettings());
  std::vector<MarchRay> rays;
  for (int i = 0; i < 12; ++i) rays.push_back(upwards(0.5, 700.0 * i));
  const auto trace = [&](core::JobPool* pool) {
    return traceRays(tracedMediumOf(field), kTwoLobes, sunAt(40), rays, 50, 9, pool);
  };
  const auto alone = trace(nullptr);
  for (const int workers : {1, 3}) {
    core::JobPool pool(workers);
    const auto shared = trace(&pool);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      EXPECT_EQ(shared[i].mean.sun, alone[i].mean.sun);
      EXPECT_EQ(shared[i].error.sky, alone[i].error.sky);
      EXPECT_EQ(shared[i].mean.transmittance, alone[i].mean.transmittance);
    }
  }
}

TEST(CloudPathTracer, whatItCannotTraceIsRefused) {
  const MarchRay ray = upwards(0.5), longRay{{0, 0, 0}, {0, 2, 0}};
  EXPECT_THROW(traceRays(slab(1), kEven, sunAt(40), {&ray, 1}, 1, 0), core::RangeError);
  EXPECT_THROW(traceRays(slab(1), kEven, {0, 3, 0}, {&ray, 1}, 2, 0), core::RangeError);
  EXPECT_THROW(traceRays(slab(1), kEven, sunAt(40), {&longRay, 1}, 2, 0), core::RangeError);
  const auto none = [](const glm::dvec3&) { return 0.0; };
  EXPECT_THROW(ExtinctionBounds(none, 1, 1, 1, 1, 1), core::RangeError);
  EXPECT_THROW(ExtinctionBounds(none, 0, 1, 1e9, 1, 1), core::RangeError);
}

}  // namespace
}  // namespace skydrop::clouds
