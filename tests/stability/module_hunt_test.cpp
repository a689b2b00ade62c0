// The hunt through the modules that are C++ alone: whatever goes in, what their headers promise comes out.
// SKYDROP_HUNT=1000000 tries so many inputs of each (docs/hunt.md).
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <limits>

#include "skydrop/core/deterministic_math.h"
#include "skydrop/core/error.h"
#include "skydrop/core/fixed_step.h"
#include "skydrop/core/guards.h"
#include "skydrop/core/wind.h"
#include "skydrop/flight/integrator.h"
#include "skydrop/flight/linear_drag.h"
#include "skydrop/flight/rigid_body.h"
#include "skydrop/flight/rotation.h"
#include "skydrop/render/frame/camera.h"
#include "skydrop/sky/almanac.h"
#include "skydrop/sky/atmosphere.h"
#include "skydrop/sky/night_light.h"
#include "skydrop/sky/refraction.h"
#include "skydrop/terrain/chunk_grid.h"
#include "skydrop/terrain/height_range.h"
#include "skydrop/terrain/noise_height_source.h"
#include "skydrop/weather/draughts.h"
#include "skydrop/weather/dryden.h"
#include "skydrop/weather/icing.h"
#include "skydrop/weather/standard_atmosphere.h"
#include "skydrop/weather/state.h"
#include "skydrop/weather/thunder.h"
#include "skydrop/weather/wind_profile.h"
#include "support/hunt.h"
#include "support/hunt_numbers.h"
#include "support/instrumented.h"

namespace skydrop {
namespace {

using core::isFinite;
using test::HuntNumbers;

std::uint64_t rounds(int usual) {
  return test::huntedInputs(static_cast<std::uint64_t>(test::repetitions(usual)));
}

TEST(ModuleHunt, chunkIndexIsTheFloor) {
  // Of any place within the world and any size of chunk or patch: index * size <= place < (index + 1) * size.
  HuntNumbers n(1);
  for (std::uint64_t i = 0; i < rounds(20000); ++i) {
    const double size = 60 * std::exp2(static_cast<double>(n.pick(11)));
    const double border = std::floor((n.unit() - 0.5) * std::pow(10.0, 14 * n.unit())) * size;
    const double place = std::clamp(n.finite({border, -border, terrain::kWorldLimitMetres}),
                                    -terrain::kWorldLimitMetres, terrain::kWorldLimitMetres);
    const auto index = static_cast<double>(terrain::gridIndex(place, size));
    ASSERT_TRUE(index * size <= place && place < (index + 1) * size) << place << " " << size << " " << i;
  }
}

TEST(ModuleHunt, heightCodesAreTheNearest) {
  HuntNumbers n(2);
  for (std::uint64_t i = 0; i < rounds(20000); ++i) {
    terrain::HeightRange range;
    if (n.pick(2) == 0) range = {n.within(-1e4, 0), n.within(1, 1e4)};
    const double height = n.any({range.lowest, range.highest, 0});
    const double inside = std::isnan(height) ? range.lowest : std::clamp(height, range.lowest, range.highest);
    ASSERT_LE(std::abs(range.decode(range.encode(height)) - inside), range.step() * (0.5 + 1e-9))
        << height << " " << i;
  }
}

TEST(ModuleHunt, rotationsStayRotations) {
  // The exponential map of any vector up to 1e15 is a unit quaternion and its logarithm the vector (below
  // pi); any attitude comes back from its angles within 1e-7.
  HuntNumbers n(3);
  for (std::uint64_t i = 0; i < rounds(20000); ++i) {
    const auto one = [&] { return std::clamp(n.finite({glm::pi<double>(), 1e-8, 1e-160}), -1e15, 1e15); };
    const glm::dvec3 v(one(), n.pick(2) == 0 ? 0 : one(), n.pick(2) == 0 ? 0 : one());
    const glm::dquat q = flight::exponentialMap(v);
    ASSERT_NEAR(glm::length(q), 1, 1e-12) << v.x << " " << v.y << " " << v.z << " " << i;
    const double size = std::hypot(v.x, v.y, v.z);
    const glm::dvec3 back = flight::logarithmMap(q);
    ASSERT_TRUE(isFinite(back)) << i;
    if (size < 3) {
      ASSERT_LE(glm::length(back - v), 1e-14 + 1e-12 * size) << v.x << " " << v.y << " " << v.z << " " << i;
    }
    const flight::Attitude attitude = flight::attitudeOf(q);
    ASSERT_TRUE(attitude.headingRad >= 0 && attitude.headingRad < 2 * glm::pi<double>()) << i;
    ASSERT_LE(std::abs(attitude.pitchRad), glm::half_pi<double>()) << i;
    ASSERT_TRUE(attitude.bankRad > -glm::pi<double>() && attitude.bankRad <= glm::pi<double>()) << i;
    ASSERT_GE(std::abs(glm::dot(flight::orientationOf(attitude), q)), 1 - 1e-12) << i;
  }
}

TEST(ModuleHunt, bodiesStayFinite) {
  // Whatever pushes them and however long the step: finite, of unit attitude, and a step of no length changes
  // nothing.
  HuntNumbers n(4);
  for (std::uint64_t i = 0; i < rounds(20000); ++i) {
    flight::RigidBody body(std::pow(10.0, 6 * n.unit() - 2), {n.within(-1e9, 1e9), n.within(-1e4, 1e5), 0},
                           {1, 0, 0, 0}, glm::dmat3(n.within(0.1, 100)));
    for (int step = 0; step < 3; ++step) {
      body.applyForce({n.any(), n.any(), n.any()});
      body.applyRelativeTorque({n.any(), n.any(), n.any()});
      const flight::BodyState before = body.state();
      const double dt = n.any({1.0 / 120});
      body.update(dt);
      const flight::BodyState& after = body.state();
      ASSERT_TRUE(isFinite(after.position) && isFinite(after.velocity) && isFinite(after.angularVelocity))
          << i;
      ASSERT_NEAR(glm::length(after.orientation), 1, 1e-12) << i;
      if (!(dt > 0)) {
        ASSERT_EQ(before.position, after.position) << i;
      }
    }
  }
}

TEST(ModuleHunt, fallIsThatOfLongDouble) {
  // Any drag and any duration up to 1e9 s: within 1e-12 of the largest term.
  HuntNumbers n(5);
  for (std::uint64_t i = 0; i < rounds(20000); ++i) {
    const double k = std::clamp(std::abs(n.finite({0.5, 1e-8})), 0.0, 1e30),
                 t = std::clamp(std::abs(n.finite()), 0.0, 1e9);
    const flight::PointState end = flight::fallWithLinearDrag({{0, 0, 0}, {50, 0, 0}}, k, {3, 0, 0}, t);
    const long double z = static_cast<long double>(k) * t;
    const long double one = z > 0 ? -expm1l(-z) / z : 1;
    const long double expected = 3.0L * t + 47.0L * t * one;
    ASSERT_TRUE(isFinite(end.position) && isFinite(end.velocity)) << k << " " << t;
    ASSERT_NEAR(end.position.x, static_cast<double>(expected), 1e-12 * (3 * t + 47 * t) + 1e-300)
        << k << " " << t << " " << i;
    ASSERT_LE(end.velocity.y, 0) << i;
  }
}

TEST(ModuleHunt, windIsFiniteAndNoFasterThanItsKnots) {
  HuntNumbers n(6);
  for (std::uint64_t i = 0; i < rounds(20000); ++i) {
    weather::Wind wind;
    wind.speedMps = n.within(0, 60);
    wind.directionDeg = n.within(0, 360);
    wind.roughnessM = std::pow(10.0, -4 * n.unit());
    wind.gustMps = n.within(0, 30);
    for (std::size_t k = 0; k < weather::kWindLevels; ++k)
      wind.levels[k] = {500 + 2000 * static_cast<double>(k) + 1000 * n.unit(), n.within(0, 90),
                        n.within(0, 360)};
    const weather::WindProfile profile(wind);
    const double height =
        n.any({300, wind.levels[0].heightM, wind.levels[1].heightM, wind.levels[2].heightM});
    const double above = n.any({10, 300, 0});
    const glm::dvec3 air = profile.at(height, above);
    ASSERT_TRUE(isFinite(air) && air.y == 0) << height << " " << above << " " << i;
    ASSERT_LE(glm::length(air), 400) << i;
    if (!(above > 0)) {
      ASSERT_EQ(glm::length(air), 0) << i;
    }
    ASSERT_TRUE(std::isfinite(profile.w20Mps())) << i;
    ASSERT_NEAR(glm::length(weather::windVelocity(1, n.finite({360, 0}))), 1, 1e-12) << i;
    core::WindSettings drift;
    ASSERT_TRUE(std::isfinite(core::windDrift(drift, n.finite()).x)) << i;
  }
}

TEST(ModuleHunt, turbulenceHasScalesAndKeepsItsVariance) {
  // Any height, wind and severity; any airspeed and step: intensities and lengths finite, shares kept in [0,
  // 1].
  HuntNumbers n(7);
  for (std::uint64_t i = 0; i < rounds(20000); ++i) {
    const double height = n.finite({3.048, 304.8, 609.6}), w20 = std::clamp(std::abs(n.finite()), 0.0, 100.0);
    const weather::DrydenScales scales = weather::drydenScales(height, w20, n.within(0, 6));
    ASSERT_TRUE(isFinite(scales.intensityMps) && isFinite(scales.lengthM))
        << height << " " << w20 << " " << i;
    for (int c = 0; c < 3; ++c)
      ASSERT_TRUE(scales.intensityMps[c] >= 0 && scales.lengthM[c] > 0) << height << " " << i;
    const double speed = std::abs(n.finite()), seconds = std::abs(n.finite({1.0 / 120}));
    const weather::DrydenStep step(scales, speed, seconds);
    for (const double keep : {step.keepU, step.v.keep, step.w.keep})
      ASSERT_TRUE(keep >= 0 && keep <= 1) << speed << " " << seconds;
    for (const double x : {step.noiseU, step.v.feed, step.v.noise11, step.v.noise21, step.v.noise22,
                           step.w.feed, step.w.noise11, step.w.noise21, step.w.noise22})
      ASSERT_TRUE(std::isfinite(x)) << speed << " " << seconds << " " << i;
    weather::Dryden dryden(i);
    dryden.advance(step, i);
    ASSERT_TRUE(isFinite(dryden.gust())) << speed << " " << seconds << " " << i;
  }
}

TEST(ModuleHunt, airIsFiniteAtAnyHeight) {
  HuntNumbers n(8);
  for (std::uint64_t i = 0; i < rounds(20000); ++i) {
    const double height = n.any({-5000, 0, 11000, 20000, 32000, 47000, 51000, 71000, 86000, -6356766});
    for (const weather::Air& air :
         {weather::standardAir(height), weather::airAt(height, n.within(-60, 50), n.within(8e4, 1.1e5))}) {
      ASSERT_TRUE(std::isfinite(air.temperatureK) && air.temperatureK > 0) << height << " " << i;
      ASSERT_TRUE(std::isfinite(air.pressurePa) && air.pressurePa >= 0) << height << " " << i;
      ASSERT_TRUE(std::isfinite(air.densityKgM3) && air.densityKgM3 >= 0 && std::isfinite(air.soundMps))
          << height << " " << i;
    }
    ASSERT_TRUE(weather::speedOfSound(n.finite({-273.15})) > 0) << i;
  }
}

TEST(ModuleHunt, draughtsAndIceStayInTheirRange) {
  HuntNumbers n(9);
  for (std::uint64_t i = 0; i < rounds(20000); ++i) {
    const double base = n.within(100, 5000), top = base + n.within(1, 12000);
    const weather::Layer layer{static_cast<weather::Genus>(n.pick(10)), base, top, n.within(0, 1),
                               n.within(0, 4)};
    const double height = n.finite({base, top, 0}), ground = n.within(-400, 4000);
    const double draught = weather::cloudDraught(layer, n.within(0, 1), height, ground, n.within(0, 200));
    ASSERT_TRUE(std::isfinite(draught) && std::abs(draught) < 200)
        << height << " " << ground << " " << base << " " << top;
    const glm::dvec2 wind(n.within(-90, 90), n.within(-90, 90)), slope(n.finite(), n.finite());
    const double ridge = weather::slopeDraught(wind, slope, n.finite({0}));
    ASSERT_TRUE(std::isfinite(ridge) && std::abs(ridge) <= 130) << slope.x << " " << slope.y << " " << i;
    const weather::IcingAir air{n.finite({0, -7, -25}), n.within(0, 1), n.within(0, 200)};
    const double ice = weather::iceAfter(n.within(0, 1), air, n.within(0, 10), std::abs(n.finite()));
    ASSERT_TRUE(ice >= 0 && ice <= 1) << air.temperatureC << " " << ice << " " << i;
  }
}

TEST(ModuleHunt, directionsOfWindMixWithinTheCompass) {
  HuntNumbers n(10);
  for (std::uint64_t i = 0; i < rounds(20000); ++i) {
    const double from = n.finite({0, 180, 360, -360}), to = n.finite({0, 180, 360, from + 180});
    const double mixed =
        weather::mixedDirection(from, std::abs(n.finite()), to, std::abs(n.finite()), n.within(0, 1));
    ASSERT_TRUE(mixed >= 0 && mixed < 360) << from << " " << to << " " << mixed << " " << i;
  }
}

TEST(ModuleHunt, sunAndMoonStandInTheSky) {
  // Within the years that can be written, any place: angles in their ranges, distances those of the solar
  // system.
  HuntNumbers n(11);
  for (std::uint64_t i = 0; i < rounds(4000); ++i) {
    const double days = n.within(-365300, 365300);
    const sky::Place place{n.finite({90, -90, 0}), n.finite({180, -180, 0})};
    for (const bool isMoon : {false, true}) {
      const sky::Body body = isMoon ? sky::moonAt(days, place) : sky::sunAt(days, place);
      ASSERT_TRUE(body.horizontal.azimuthDegrees >= 0 && body.horizontal.azimuthDegrees < 360)
          << days << " " << place.latitudeDegrees << " " << place.longitudeDegrees << " "
          << body.horizontal.azimuthDegrees;
      ASSERT_LE(std::abs(body.horizontal.elevationDegrees), 90) << days;
      ASSERT_TRUE(body.rightAscensionDegrees >= 0 && body.rightAscensionDegrees < 360) << days;
      ASSERT_TRUE(body.hourAngleDegrees >= -180 && body.hourAngleDegrees < 180)
          << days << " " << place.longitudeDegrees;
      ASSERT_GT(body.distanceKm, isMoon ? 345000 : 1.46e8) << days;
      ASSERT_LT(body.distanceKm, isMoon ? 415000 : 1.53e8) << days;
    }
    const sky::MoonPhase phase = sky::moonPhase(days, place);
    ASSERT_TRUE(phase.phase >= 0 && phase.phase < 1 && phase.illuminatedFraction >= 0 &&
                phase.illuminatedFraction <= 1);
    ASSERT_TRUE(phase.brightLimbDegrees >= 0 && phase.brightLimbDegrees < 360);
    const double sidereal = sky::siderealDegrees(days, place.longitudeDegrees);
    ASSERT_TRUE(sidereal >= 0 && sidereal < 360) << days << " " << place.longitudeDegrees;
  }
}

TEST(ModuleHunt, placesInTheSkyComeBackFromTheirDirection) {
  // A direction of any length from 1e-300 to 1e300; azimuth and elevation within 1e-9 degrees.
  HuntNumbers n(12);
  for (std::uint64_t i = 0; i < rounds(20000); ++i) {
    const sky::Horizontal place{360 * n.unit(), n.within(-89, 89)};
    const double length = std::pow(10.0, 600 * n.unit() - 300);
    const sky::Horizontal back = sky::horizontalOf(sky::worldDirection(place) * length);
    ASSERT_NEAR(std::remainder(back.azimuthDegrees - place.azimuthDegrees, 360), 0, 1e-9)
        << length << " " << i;
    ASSERT_NEAR(back.elevationDegrees, place.elevationDegrees, 1e-9) << length << " " << i;
  }
}

TEST(ModuleHunt, refractionAndItsInverse) {
  HuntNumbers n(13);
  for (std::uint64_t i = 0; i < rounds(20000); ++i) {
    const double elevation = n.within(-90, 90);
    const double lift = sky::refraction(elevation);
    ASSERT_TRUE(lift >= 0 && lift < 0.7) << elevation;
    ASSERT_NEAR(sky::geometricElevation(elevation + lift), elevation, 1e-9) << elevation << " " << i;
  }
}

TEST(ModuleHunt, skyLightIsFiniteFromAnyHeight) {
  HuntNumbers n(14);
  for (std::uint64_t i = 0; i < rounds(3000); ++i) {
    const sky::Atmosphere air =
        sky::makeAtmosphere(n.within(100, 5e5), n.within(50, 1e4), n.within(-0.95, 0.95));
    const double height = n.finite({0, 1e5});
    const double sine = n.within(-1, 1), level = std::sqrt(std::max(1 - sine * sine, 0.0));
    const sky::SkyLight light = sky::skyLight(air, {level, sine, 0}, height, sky::SkyModel::closedForm);
    const double upwards = n.within(-1, 1), aside = std::sqrt(std::max(1 - upwards * upwards, 0.0));
    for (const glm::dvec3& c :
         {light.sun, light.sky, light.ground, skyRadiance(light, {0, upwards, aside}),
          airRadiance(light, {0, upwards, aside}, std::abs(n.finite())), sunIlluminance(light, n.finite())}) {
      ASSERT_TRUE(isFinite(c) && c.x >= 0 && c.y >= 0 && c.z >= 0)
          << height << " " << sine << " " << upwards << " " << i;
    }
    const double other = n.finite();
    const glm::dvec3 left = sky::transmittance(air, height, other, std::abs(height - other));
    ASSERT_TRUE(isFinite(left) && left.x >= 0 && left.x <= 1) << height << " " << other << " " << i;
  }
}

TEST(ModuleHunt, landAnswersAnywhere) {
  HuntNumbers n(15);
  const auto land = terrain::makeNoiseHeightSource({}, 1);
  for (std::uint64_t i = 0; i < rounds(5000); ++i) {
    const glm::dvec2 place(n.any({960, -960, terrain::kWorldLimitMetres}),
                           n.any({61440, 0, -terrain::kWorldLimitMetres}));
    const terrain::HeightSample sample = land->sample(place);
    ASSERT_TRUE(sample.height >= land->range().lowest && sample.height <= land->range().highest)
        << place.x << " " << place.y;
    ASSERT_TRUE(std::isfinite(sample.gradient.x) && std::isfinite(sample.gradient.y))
        << place.x << " " << place.y;
  }
}

TEST(ModuleHunt, camerasAreRefusedOrSeeStraight) {
  // A pose of any numbers: not finite is refused and changes nothing; else the view's axes are a rotation
  // within 1e-9.
  HuntNumbers n(16);
  render::Camera camera;
  camera.setMode(render::CameraMode::free);
  for (std::uint64_t i = 0; i < rounds(20000); ++i) {
    const glm::dvec3 place(n.any(), n.any(), n.any());
    const double yaw = n.any({glm::pi<double>()}), pitch = n.any({glm::half_pi<double>()}), roll = n.any();
    const glm::dvec3 before = camera.position();
    if (!isFinite(place) || !std::isfinite(yaw + pitch + roll)) {
      ASSERT_THROW(camera.setPose(place, yaw, pitch, roll), core::RangeError) << i;
      ASSERT_EQ(camera.position(), before) << i;
      continue;
    }
    camera.setPose(place, yaw, pitch, roll);
    const glm::dmat3 axes(camera.getView());
    const glm::dmat3 off = axes * glm::transpose(axes) - glm::dmat3(1);
    for (int c = 0; c < 3; ++c)
      ASSERT_LE(glm::length(off[c]), 1e-9) << yaw << " " << pitch << " " << roll << " " << i;
    ASSERT_NEAR(glm::determinant(axes), 1, 1e-9) << i;
  }
}

TEST(ModuleHunt, clockTakesAnyTime) {
  HuntNumbers n(17);
  core::FixedStep clock;
  for (std::uint64_t i = 0; i < rounds(20000); ++i) {
    const double real = n.any({1.0 / 120, 0.25, 0});
    const int due = clock.advance(real);
    ASSERT_TRUE(due >= 0 && due <= 30) << real << " " << i;
    if (!(real > 0) || std::isinf(real)) {
      ASSERT_EQ(due, 0) << real;
    }
    ASSERT_TRUE(clock.alpha() >= 0 && clock.alpha() < 1) << real << " " << i;
  }
}

TEST(ModuleHunt, guardsTakeAnything) {
  HuntNumbers n(18);
  for (std::uint64_t i = 0; i < rounds(20000); ++i) {
    const glm::dvec3 v(n.any({1e-150, 1e150}), n.any({1e-150}), n.any());
    const glm::dvec3 unit = core::safeNormalize(v * (n.pick(2) == 0 ? 1e200 : 1e-100), {0, 1, 0});
    ASSERT_NEAR(glm::length(unit), 1, 1e-12) << v.x << " " << v.y << " " << v.z << " " << i;
    ASSERT_LE(std::abs(core::safeAsin(n.finite({1, -1}))), glm::half_pi<double>()) << i;
    ASSERT_GE(core::safeSqrt(n.finite({0})), 0) << i;
  }
}

TEST(ModuleHunt, moonlightIsFinite) {
  HuntNumbers n(19);
  for (std::uint64_t i = 0; i < rounds(5000); ++i) {
    const double phase = n.within(-180, 180), distance = n.within(345000, 415000);
    for (const double x : {sky::moonIlluminance(phase, distance), sky::moonRadiance(phase, distance),
                           sky::lommelSeeligerShare(phase)})
      ASSERT_TRUE(std::isfinite(x) && x >= 0) << phase << " " << distance << " " << i;
  }
}

}  // namespace
}  // namespace skydrop
