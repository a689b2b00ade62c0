// The air as a shell: its geometry, its tables, and its light against the reference in double.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <vector>

#include "skydrop/core/hash.h"
#include "skydrop/sky/atmosphere.h"
#include "skydrop/sky/reference_paths.h"
#include "skydrop/sky/reference_sky.h"

namespace skydrop::sky {
namespace {

namespace f32 = core::shared::f32;
namespace f64 = core::shared::f64;

constexpr double kEyeM = 500;

Atmosphere clearAir() { return makeAtmosphere(100000, 1200, 0.7); }

const ReferenceSky& reference() {
  static const ReferenceSky sky(clearAir());
  return sky;
}

double sineOf(double degrees) { return std::sin(glm::radians(degrees)); }

// The dome: rings of equal solid angle, and azimuths to both sides of the middle.
std::vector<ReferenceRay> dome(double heightM, double sunDegrees, int rings = 6, int sectors = 6) {
  std::vector<ReferenceRay> rays;
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < sectors; ++j)
      rays.push_back(
          {heightM, (i + 0.5) / rings, std::cos(std::numbers::pi * (j + 0.5) / sectors), sineOf(sunDegrees)});
  }
  return rays;
}

// The program's sky without the night's, per irradiance of the sun.
glm::dvec3 radianceOf(const SkyLight& light, const ReferenceRay& ray) {
  const double across = std::sqrt(1 - ray.sine * ray.sine);
  const double aside = std::sqrt(std::max(1 - ray.cosAzimuth * ray.cosAzimuth, 0.0));
  return (skyRadiance(light, {across * ray.cosAzimuth, ray.sine, across * aside}) - light.night) /
         light.sunOutside;
}

SkyLight lightOf(SkyModel model, double heightM, double sunDegrees) {
  return skyLight(clearAir(), {std::cos(glm::radians(sunDegrees)), sineOf(sunDegrees), 0}, heightM, model);
}

TEST(SkyShell, floatKeepsHeightsAndCrossingsOfAPlanet) {
  // Against double, from the ground to the top and in all directions: heights along rays within 0.1 m in 1000
  // km (differences of squares are 7 to 23 m off), crossings within 1e-4 of their length and 0.1 m.
  core::RandomStream random{11};
  for (int i = 0; i < 20000; ++i) {
    const auto height = static_cast<float>(100000 * random.nextUnit() * random.nextUnit());
    const auto cosine = static_cast<float>(2 * random.nextUnit() - 1);
    const auto length = static_cast<float>(3e5 * random.nextUnit() * random.nextUnit());
    const double exact = f64::shellHeightAlong(height, cosine, length);
    if (exact > 0) {
      ASSERT_NEAR(f32::shellHeightAlong(height, cosine, length), exact, 0.1 + 2e-7 * length);
    }
    const f64::Vec2 top = f64::shellCrossing(height, cosine, f64::kShellTop);
    ASSERT_NEAR(f32::shellCrossing(height, cosine, f32::kShellTop).y, top.y, 0.1 + 1e-4 * std::abs(top.y));
    ASSERT_NEAR(f64::shellHeightAlong(height, cosine, top.y), f64::kShellTop, 1e-4);
  }
}

TEST(SkyShell, theHorizonDipsWithTheHeight) {
  // By the angle of a tangent to the sphere: 1 degree from 1 km, 3.5 from 12 km.
  for (const double height : {0.0, 2.0, 1000.0, 12000.0, 400000.0}) {
    const double dip = std::acos(f64::kEarthRadius / (f64::kEarthRadius + height));
    EXPECT_NEAR(-std::asin(f64::horizonSine(height)), dip, 1e-9) << height;
    EXPECT_NEAR(lightOf(SkyModel::shell, std::max(height, 1.0), 20).view->horizon,
                f64::horizonSine(std::max(height, 1.0)), 1e-12);
  }
}

TEST(SkyShell, placesOfTheTablesGoThereAndBack) {
  // Texel middles to directions and back; the last texel is the end, nothing is looked up beyond it.
  for (int y = 0; y < f64::kTransmittanceHeights; ++y) {
    for (int x = 0; x < f64::kTransmittanceSines; ++x) {
      const f64::Vec2 at(x / (f64::kTransmittanceSines - 1.0), y / (f64::kTransmittanceHeights - 1.0));
      const f64::Vec2 place = f64::transmittanceTablePlace(at);
      const f64::Vec2 back = f64::transmittanceTableAt(place.x, place.y);
      ASSERT_NEAR(back.y, at.y, 1e-9);
      // In the topmost row all lengths but the horizon's are none.
      if (y < f64::kTransmittanceHeights - 1) {
        ASSERT_NEAR(back.x, at.x, 1e-6) << x << ' ' << y;
      }
    }
  }
  for (const double horizon : {0.0, -0.06, -0.9}) {
    for (const double airEnds : {1.0, 0.5 * horizon}) {
      if (airEnds <= horizon) continue;
      for (int row = 0; row < f64::kSkyRows; ++row) {
        const double sine = f64::skyTableSine(row, horizon, airEnds);
        // The row below the horizon shares its sine with the one above.
        const double expected = row == f64::kSkyRowsBelow - 1 ? row + 1 : row;
        ASSERT_NEAR(f64::skyTableRow(sine, horizon, airEnds), expected, 1e-6) << horizon;
      }
      EXPECT_EQ(f64::skyTableRow(1, horizon, airEnds), f64::kSkyRows - 1);
      EXPECT_EQ(f64::skyTableRow(-1, horizon, airEnds), 0);
      EXPECT_EQ(f64::skyTableRow(std::nextafter(horizon, -1), horizon, airEnds) < f64::kSkyRowsBelow, true);
    }
  }
  EXPECT_EQ(f64::skyTableColumn(-1), 0);
  EXPECT_EQ(f64::skyTableColumn(1), f64::kSkyColumns - 1);
}

TEST(SkyShell, thePhaseFunctionInTheTableOfTheAirIsThatOfThePixel) {
  // Mixed from four texels: within 1.2 % of it at the default haze's anisotropy of .7, wherever light and
  // view stand; and every texel is where a pixel asks for it.
  constexpr double kHorizon = -0.02, kAirEnds = 1, kAnisotropy = 0.7;
  for (int column = 0; column < f64::kAirColumns; ++column)
    ASSERT_NEAR(f64::airTableColumn(f64::airTableCosAzimuth(column)), column, 1e-9);
  for (int row = 0; row < f64::kAirRows; ++row) ASSERT_EQ(f64::airTableRow(f64::airTableSkyRow(row)), row);
  double most = 0;
  for (const double sunDegrees : {1.0, 5.0, 20.0, 40.0, 60.0}) {
    const double sun = std::sin(glm::radians(sunDegrees)), sunAcross = std::sqrt(1 - sun * sun);
    const auto phase = [&](double sine, double cosAzimuth) {
      const double cosAngle = sine * sun + std::sqrt(1 - sine * sine) * sunAcross * cosAzimuth;
      return f64::henyeyGreenstein(std::clamp(cosAngle, -1.0, 1.0), kAnisotropy);
    };
    const auto texel = [&](int row, int column) {
      return phase(f64::skyTableSine(f64::airTableSkyRow(row), kHorizon, kAirEnds),
                   f64::airTableCosAzimuth(column));
    };
    for (double elevation = -60; elevation <= 60; elevation += 0.37) {
      for (double azimuth = 0; azimuth <= 180; azimuth += 0.41) {
        const double sine = std::sin(glm::radians(elevation)), cosAzimuth = std::cos(glm::radians(azimuth));
        const double atRow = f64::airTableRow(f64::skyTableRow(sine, kHorizon, kAirEnds)),
                     atColumn = f64::airTableColumn(cosAzimuth);
        const int row = std::min(static_cast<int>(atRow), f64::kAirRows - 2),
                  column = std::min(static_cast<int>(atColumn), f64::kAirColumns - 2);
        const double mixed = glm::mix(
            glm::mix(texel(row, column), texel(row, column + 1), atColumn - column),
            glm::mix(texel(row + 1, column), texel(row + 1, column + 1), atColumn - column), atRow - row);
        most = std::max(most, std::abs(mixed / phase(sine, cosAzimuth) - 1));
      }
    }
  }
  EXPECT_LT(most, 0.012);
  EXPECT_GT(most, 0.002);
}

TEST(SkyShell, theReferenceConvergesWithTheSquareOfItsSteps) {
  // Light scattered once, in air without ozone, whose tent has edges: twice the steps, a quarter of the
  // error. With ozone 256 steps, as the studies take, are within 1e-4 of 2048.
  Atmosphere smooth = clearAir();
  smooth.ozone = glm::dvec3(0);
  const ReferenceSky withoutOzone(smooth);
  for (const double sun : {60.0, 10.0, 2.0}) {
    const ReferenceRay ray{kEyeM, 0.2, 0.3, sineOf(sun)};
    const glm::dvec3 a = withoutOzone.once(ray, 256), b = withoutOzone.once(ray, 512),
                     c = withoutOzone.once(ray, 1024);
    const glm::dvec3 order = glm::log2(glm::abs((b - a) / (c - b)));
    const glm::dvec3 fine = reference().once(ray, 2048), used = reference().once(ray, 256);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(order[i], 2, 0.1) << sun;
      EXPECT_NEAR(used[i] / fine[i], 1, 1e-4) << sun;
    }
  }
}

TEST(SkyShell, theTableOfTransmittanceIsThatOfTheReference) {
  // At heights and angles between its texels, to the horizon of each height.
  const AirTables tables(clearAir());
  double worst = 0;
  for (const double height : {0.0, 37.0, 500.0, 3100.0, 12000.0, 40000.0}) {
    for (const double share : {0.0, 0.001, 0.01, 0.1, 0.4, 1.0}) {
      const double horizon = f64::horizonSine(height), cosine = horizon + (1 - horizon) * share;
      const glm::dvec3 exact = reference().transmittance(height, cosine, 400);
      const glm::dvec3 table(tables.at(static_cast<float>(height)).transmittance(static_cast<float>(cosine)));
      for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(exact[c] - table[c]));
    }
  }
  EXPECT_LT(worst, 0.004);
}

// Root mean square of differences over the dome, by the mean of the reference, for each channel.
struct Sums {
  glm::dvec3 squares{0}, mean{0};
  double count = 0;
  void add(const glm::dvec3& difference, const glm::dvec3& of) {
    squares += difference * difference;
    mean += of;
    ++count;
  }
  glm::dvec3 relative() const { return glm::sqrt(squares / count) / (mean / count); }
};

// As the reference had it before its paths were led: each place by the air's extinction, each direction by
// the phase function, light only where the path is scattered. Slow to converge, and simple.
glm::dvec3 byPlainPaths(const Atmosphere& air, const ReferenceSky& sky, const ReferenceRay& ray, int paths,
                        glm::dvec3& error) {
  const double length = endOf(ray);
  const glm::dvec3 toSun(std::sqrt(1 - ray.sunSine * ray.sunSine), ray.sunSine, 0);
  const double across = std::sqrt(1 - ray.sine * ray.sine);
  const glm::dvec3 along(across * ray.cosAzimuth, ray.sine,
                         across * std::sqrt(1 - ray.cosAzimuth * ray.cosAzimuth));
  glm::dvec3 mean(0);
  for (int channel = 0; channel < 3; ++channel) {
    double sum = 0, squares = 0;
    for (int path = 0; path < paths; ++path) {
      core::RandomStream random{
          core::hashCombine(static_cast<std::uint64_t>(channel) + 91, static_cast<std::uint64_t>(path))};
      const auto even = [&] {  // a direction of all
        const double y = 2 * random.nextUnit() - 1, a = 2 * std::numbers::pi * random.nextUnit();
        const double r = std::sqrt(1 - y * y);
        return glm::dvec3(r * std::cos(a), y, r * std::sin(a));
      };
      glm::dvec3 place(0, f64::kEarthRadius + ray.heightM, 0), direction = along;
      double weight = 1, value = 0, way = length;
      bool falls = false;
      for (int order = 1; order < 200 && weight > 1e-6; ++order) {
        const double height = glm::length(place) - f64::kEarthRadius;
        const double climb = glm::dot(direction, place) / glm::length(place);
        if (order > 1) {
          falls = climb < f64::horizonSine(std::max(height, 0.0));
          way = falls ? f64::shellCrossing(height, climb, 0).x
                      : f64::shellCrossing(height, climb, f64::kShellTop).y;
        }
        const double most = air.rayleigh[channel] + air.haze + air.ozone[channel];
        double t = 0;
        do {
          t -= std::log(1 - random.nextUnit()) / most;
        } while (t < way &&
                 random.nextUnit() * most >=
                     f64::shellAirAt(air, f64::shellHeightAlong(height, climb, t)).extinction[channel]);
        if (t >= way && !falls) break;
        place += direction * std::min(t, way);
        const double r = glm::length(place), there = std::max(r - f64::kEarthRadius, 0.0);
        const double sun = glm::dot(place, toSun) / r;
        const double light = sun > f64::horizonSine(there) ? sky.transmittance(there, sun, 64)[channel] : 0;
        const glm::dvec3 next = even();
        if (t >= way) {  // on the ground
          if (order > 1) value += weight * f64::kGroundAlbedo * light * std::max(sun, 0.0) / std::numbers::pi;
          weight *= 4 * f64::kGroundAlbedo * std::max(glm::dot(next, place) / r, 0.0);
        } else {
          const f64::ShellAir here = f64::shellAirAt(air, there);
          const auto scattered = [&](const glm::dvec3& to) {
            const double between = glm::dot(direction, to);
            return (here.rayleigh[channel] * f64::rayleighPhase(between) +
                    here.haze * f64::henyeyGreenstein(between, air.hazeAnisotropy)) /
                   here.extinction[channel];
          };
          if (order > 1) value += weight * light * scattered(toSun);
          weight *= 4 * std::numbers::pi * scattered(next);
        }
        direction = next;
      }
      sum += value;
      squares += value * value;
    }
    mean[channel] = sum / paths;
    error[channel] = std::sqrt(std::max(squares / paths - mean[channel] * mean[channel], 0.0) / paths);
  }
  return mean;
}

TEST(SkyShell, pathsThatAreLedHaveTheMeanOfPathsThatAreNot) {
  // Light scattered more than once, for rays up and along the ground, by day and in twilight, within four
  // standard errors of both, which are below 5 % of it.
  const Atmosphere air = clearAir();
  for (const ReferenceRay& ray :
       {ReferenceRay{kEyeM, 0.7, 0.3, sineOf(50)}, ReferenceRay{kEyeM, 0.1, 0.8, sineOf(8)},
        ReferenceRay{3000, 0.3, -0.6, sineOf(1)}, ReferenceRay{kEyeM, 0.15, 0.9, sineOf(-2)}}) {
    glm::dvec3 plainError(0);
    const glm::dvec3 plain = byPlainPaths(air, reference(), ray, 100000, plainError);
    const ReferenceEstimate led = reference().often(ray, 8192, 3);
    for (int c = 0; c < 3; ++c) {
      EXPECT_LT(plainError[c], 0.05 * plain[c]) << ray.sunSine << ' ' << c;
      EXPECT_LT(led.error[c], 0.05 * led.mean[c]) << ray.sunSine << ' ' << c;
      EXPECT_NEAR(led.mean[c], plain[c], 4 * std::hypot(plainError[c], led.error[c]))
          << ray.sunSine << ' ' << c;
    }
  }
}

TEST(SkyShell, morePathsAreAddedToThoseThatThereAre) {
  // Bit for bit those of an estimate that begins with as many.
  const ReferenceRay ray{kEyeM, 0.3, 0.2, sineOf(-4)};
  ReferencePaths grown(reference(), ray, 5);
  grown.upTo(64);
  EXPECT_EQ(grown.upTo(256).mean, reference().often(ray, 256, 5).mean);
  EXPECT_NE(reference().often(ray, 256, 5).mean, reference().often(ray, 256, 6).mean);
}

TEST(SkyShell, allOrdersOfScatteringAreNearTheReference) {
  // Over the dome from 500 m, against single scattering by quadrature and the rest by paths, down to the end
  // of nautical twilight. Printed for the documents.
  struct Row {
    double sunDegrees, most, surest;
  };
  for (const Row& row : {Row{60, 0.05, 0.01}, Row{10, 0.05, 0.01}, Row{0, 0.10, 0.01}, Row{-3, 0.10, 0.01},
                         Row{-6, 0.15, 0.03}, Row{-9, 0.3, 0.05}, Row{-12, 0.3, 0.1}}) {
    const SkyLight shell = lightOf(SkyModel::shell, kEyeM, row.sunDegrees),
                   closed = lightOf(SkyModel::closedForm, kEyeM, row.sunDegrees);
    Sums ofShell, ofClosed, unsure;
    std::uint64_t seed = 0;
    for (const ReferenceRay& ray : dome(kEyeM, row.sunDegrees)) {
      const ReferenceEstimate rest = reference().often(ray, 2048, ++seed);
      const glm::dvec3 exact = reference().once(ray, 128) + rest.mean;
      ofShell.add(radianceOf(shell, ray) - exact, exact);
      ofClosed.add(radianceOf(closed, ray) - exact, exact);
      unsure.add(rest.error, exact);
    }
    const glm::dvec3 a = ofShell.relative(), b = ofClosed.relative(), e = unsure.relative();
    std::printf("sun %5.1f: shell %.3f %.3f %.3f, closed form %.3f %.3f %.3f, paths %.3f %.3f %.3f\n",
                row.sunDegrees, a.x, a.y, a.z, b.x, b.y, b.z, e.x, e.y, e.z);
    for (int c = 0; c < 3; ++c) {
      EXPECT_LT(a[c], row.most) << row.sunDegrees << ' ' << c;
      EXPECT_LT(e[c], row.surest) << row.sunDegrees << ' ' << c;
    }
  }
}

TEST(SkyShell, skiesBetweenThoseThatAreKeptAreAsExact) {
  // Mixed from the corners of a cell of heights and elevations, a sky is within 1.5 % of the one made for the
  // place itself, relative to its mean, and within 4.2 % of it at -9.2 degrees (4.08 %, read by curves;
  // straight lines between texels hid a tenth of a per cent of it).
  SkyViews views(clearAir());
  for (const double height : {3.0, 130.0, 790.0, 2600.0, 11000.0}) {
    for (const double sun : {50.3, 8.7, 0.9, -0.43, -2.77, -5.86, -9.2}) {
      const SkyView mixed = *views.view(height, sineOf(sun)),
                    exact = makeSkyView(views.tables(), height, sineOf(sun));
      Sums sums;
      for (const ReferenceRay& ray : dome(height, sun, 12, 8)) {
        const glm::dvec3 a = mixed.at(SkyLayer::skyEven, ray.sine, ray.cosAzimuth),
                         b = exact.at(SkyLayer::skyEven, ray.sine, ray.cosAzimuth);
        sums.add(a - b, b);
      }
      const glm::dvec3 error = sums.relative();
      EXPECT_LT(std::max({error.x, error.y, error.z}), sun < -8 ? 0.042 : 0.015) << height << ' ' << sun;
    }
  }
}

TEST(SkyShell, aSkyDoesNotDependOnWhatWasAskedForBefore) {
  // Bit for bit: fresh, after a flight through other heights and suns, and with corners made ahead in slices.
  SkyViews fresh(clearAir()), used(clearAir()), ahead(clearAir());
  for (int i = 0; i < 40; ++i) used.view(50.0 * i, sineOf(5 - 0.2 * i));
  for (int i = 0; i < 40; ++i) ahead.prepare(300 + i, sineOf(-2 + 0.01 * i), 7);
  const auto a = fresh.view(340, sineOf(-1.6)), b = used.view(340, sineOf(-1.6)),
             c = ahead.view(340, sineOf(-1.6));
  EXPECT_EQ(a->texels, b->texels);
  EXPECT_EQ(a->texels, c->texels);
}

TEST(SkyShell, noStepIsSeenAtTheHorizon) {
  // Just above the horizon the ray leaves the air, just below it ends at the sea: what it misses is the light
  // of the air beyond, about as bright, through all the air before. Within 3 %, from the ground to 12 km.
  for (const double height : {2.0, 1000.0, 12000.0}) {
    const SkyLight light = lightOf(SkyModel::shell, height, 20);
    for (const double azimuth : {0.1, 1.5, 3.0}) {
      const auto towards = [&](double sine) {
        const double across = std::sqrt(1 - sine * sine);
        return glm::dvec3(across * std::cos(azimuth), sine, across * std::sin(azimuth));
      };
      const double over = light.view->horizon + 1e-7, under = light.view->horizon - 1e-7;
      const glm::dvec3 above = skyRadiance(light, towards(over)), below = skyRadiance(light, towards(under));
      const glm::dvec3 left = light.view->at(SkyLayer::left, under, std::cos(azimuth));
      for (int c = 0; c < 3; ++c) EXPECT_NEAR((below[c] + left[c] * above[c]) / above[c], 1, 0.03) << height;
    }
  }
}

TEST(SkyShell, theAirUpToADistanceAndTheSkyBehindItAreTheWholeSky) {
  // What an eye sees is the light of the air up to a distance, and the sky that an eye there sees through
  // that air: from tables of another height and another elevation of the sun. Within 3 % of the whole sky's
  // mean by day and in twilight; in twilight at 60 km, beyond the last slice with a distance, within 10 %.
  const AirTables tables(clearAir());
  for (const double sun : {40.0, 5.0, -2.0}) {
    for (const double distance : {1000.0, 6000.0, 20000.0, 60000.0}) {
      Sums sums;
      for (const double sine : {0.03, 0.1, 0.4}) {
        for (const double cosAzimuth : {-0.8, 0.1, 0.9}) {
          const double sunSine = sineOf(sun), across = std::sqrt(1 - sine * sine);
          const double between = sine * sunSine + across * std::sqrt(1 - sunSine * sunSine) * cosAzimuth;
          const double height = f64::shellHeightAlong(kEyeM, sine, distance),
                       up = f64::shellCosineAlong(kEyeM, sine, distance),
                       sunThere = ((f64::kEarthRadius + kEyeM) * sunSine + distance * between) /
                                  (f64::kEarthRadius + height);
          const double azimuthThere =
              (between - up * sunThere) / std::sqrt((1 - up * up) * (1 - sunThere * sunThere));
          const SkyView here = makeSkyView(tables, kEyeM, sunSine),
                        there = makeSkyView(tables, height, sunThere);
          const double phase = f64::henyeyGreenstein(between, 0.7);
          const auto skyOf = [&](const SkyView& view, double towards, double azimuth) {
            return view.at(SkyLayer::skyEven, towards, azimuth) +
                   view.at(SkyLayer::skyHaze, towards, azimuth) * phase;
          };
          const glm::dvec3 kept = here.at(SkyLayer::left, sine, 0) / there.at(SkyLayer::left, up, 0);
          const glm::dvec3 mean = here.upTo(SkyLayer::airEven, sine, cosAzimuth, distance) +
                                  here.upTo(SkyLayer::airHaze, sine, cosAzimuth, distance) * phase;
          const glm::dvec3 whole = skyOf(here, sine, cosAzimuth);
          sums.add(mean * (1.0 - kept) + kept * skyOf(there, up, azimuthThere) - whole, whole);
        }
      }
      const glm::dvec3 error = sums.relative();
      const double most = sun < 0 && distance > 50000 ? 0.10 : 0.03;
      EXPECT_LT(std::max({error.x, error.y, error.z}), most) << sun << ' ' << distance;
    }
  }
}

TEST(SkyShell, skiesOfSunAndMoonAreKeptFromFrameToFrame) {
  // Asked for in turns they are the same objects, so nothing is mixed or uploaded again.
  SkyViews views(makeAtmosphere(100000, 1200, 0.7));
  const auto sun = views.view(500, -0.3), moon = views.view(500, 0.6);
  EXPECT_NE(sun, moon);
  EXPECT_EQ(views.view(500, -0.3), sun);
  EXPECT_EQ(views.view(500, 0.6), moon);
  EXPECT_EQ(views.view(500, -0.3), sun);
  const auto later = views.view(500, -0.301);  // in place of the one that was not asked for last
  EXPECT_EQ(views.view(500, -0.3), sun);
  EXPECT_EQ(views.view(500, -0.301), later);
}

}  // namespace
}  // namespace skydrop::sky
