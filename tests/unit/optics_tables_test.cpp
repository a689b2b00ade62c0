// The tables of halos, sun dogs and rainbows against geometrical optics, which is computed here from the
// refractive indices of the literature and not by the scripts that made the tables.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <numbers>
#include <vector>

#include "skydrop/core/dds.h"
#include "skydrop/core/shared_optics.h"
#include "support/paths.h"
#include "support/process.h"
#include "support/python.h"
#include "support/temporary_folder.h"

namespace skydrop {
namespace {

namespace shared = core::shared::f64;

constexpr double kDegree = std::numbers::pi / 180;

core::TextureData opticsFile(const char* name) {
  return core::readDds(std::filesystem::path(test::sourceDir()) / "assets/optics" / name);
}

float texel(const core::TextureData& table, int x, int y, int z, int channel) {
  float value = 0;
  const auto at = static_cast<std::size_t>(((z * table.height + y) * table.width + x) * 4 + channel);
  std::memcpy(&value, &table.texels[at * sizeof(float)], sizeof value);
  return value;
}

// The place within [from, to] where f is largest.
double placeOfMost(double from, double to, const std::function<double(double)>& f) {
  constexpr int kSteps = 20000;
  double best = from;
  for (int i = 0; i <= kSteps; ++i) {
    const double x = from + (to - from) * i / kSteps;
    if (f(x) > f(best)) best = x;
  }
  return best;
}

// The angle from the antisolar point (degrees) at which rays of one (primary) or two inner reflections gather
// in a drop: the stationary deviation over all that hit it.
double geometricBow(double index, int reflections) {
  const auto angle = [&](double sine) {
    const double deviation = 2 * (std::asin(sine) - std::asin(sine / index)) +
                             reflections * (std::numbers::pi - 2 * std::asin(sine / index));
    return reflections == 1 ? std::numbers::pi - deviation : deviation - std::numbers::pi;
  };
  const double sign = reflections == 1 ? 1 : -1;
  return angle(placeOfMost(0, 1, [&](double sine) { return sign * angle(sine); })) / kDegree;
}

// Water at 20 degrees C (Hale and Querry 1973) and ice (Warren 1984) in the red and in the blue that the
// screen's red and blue mostly stand for.
constexpr double kRedWater = 1.332, kBlueWater = 1.339, kRedIce = 1.3090, kBlueIce = 1.3155;
constexpr int kRed = 0, kBlue = 2;

class RainbowTable : public testing::Test {
 protected:
  double degrees(int x) const { return 90.0 * x / (table_.width - 1); }
  int column(double degrees) const {
    return static_cast<int>(std::lround(degrees * (table_.width - 1) / 90));
  }
  double value(double degrees, int row, int channel) const {
    return static_cast<double>(texel(table_, column(degrees), row, 0, channel));
  }
  double mean(double from, double to, int row) const {
    double sum = 0;
    for (int x = column(from); x <= column(to); ++x) sum += static_cast<double>(texel(table_, x, row, 0, 1));
    return sum / (column(to) - column(from) + 1);
  }
  // Where a channel falls to half of its largest value, from `from` on towards the dark band.
  double edge(double from, double to, int row, int channel) const {
    double peak = 0;
    int at = 0;
    const int step = to > from ? 1 : -1;
    for (int x = column(from); x != column(to); x += step) {
      const auto v = static_cast<double>(texel(table_, x, row, 0, channel));
      if (v > peak) peak = v, at = x;
    }
    while (static_cast<double>(texel(table_, at, row, 0, channel)) > peak / 2) at += step;
    return degrees(at);
  }
  core::TextureData table_ = opticsFile("rainbow.dds");
};

TEST_F(RainbowTable, edgesOfBothBowsAreAtTheLeastDeviationOfRedAndBlueLight) {
  // Drops from half a millimetre on, in which waves are short: within 0.3 degrees (the sun's radius is 0.27),
  // red outside in the primary and inside in the secondary bow.
  ASSERT_EQ(table_.height, 15);
  for (int row = 10; row < 15; ++row) {
    EXPECT_NEAR(edge(36, 46, row, kRed), geometricBow(kRedWater, 1), 0.3) << row;
    EXPECT_NEAR(edge(36, 46, row, kBlue), geometricBow(kBlueWater, 1), 0.3) << row;
    EXPECT_NEAR(edge(58, 46, row, kRed), geometricBow(kRedWater, 2), 0.3) << row;
    EXPECT_NEAR(edge(58, 46, row, kBlue), geometricBow(kBlueWater, 2), 0.3) << row;
  }
  // And these are the figures of the textbooks.
  EXPECT_NEAR(geometricBow(kRedWater, 1), 42.2, 0.1);
  EXPECT_NEAR(geometricBow(kRedWater, 2), 50.6, 0.1);
}

TEST_F(RainbowTable, skyIsDarkBetweenTheBowsAndBrightInsideThePrimary) {
  // Alexander's band at most a fifth of what is inside the primary, which is brighter than the secondary's
  // far side; the primary at least four times the secondary.
  for (int row = 0; row < table_.height; ++row) {
    EXPECT_LT(mean(45, 48, row), mean(25, 36, row) / 5) << row;
    EXPECT_LT(mean(45, 48, row), mean(60, 64, row)) << row;
    EXPECT_GT(mean(25, 36, row), mean(60, 64, row)) << row;
    EXPECT_GT(mean(40, 42, row), 4 * mean(51, 53, row)) << row;
  }
}

TEST_F(RainbowTable, largerDropsMakeNarrowerBows) {
  // The distance of the red edge from the red bow's brightest ring falls with the radius (Airy 1838).
  double last = 90;
  for (int row = 0; row < table_.height; row += 3) {
    int peak = column(36);
    for (int x = peak; x < column(46); ++x) {
      if (texel(table_, x, row, 0, kRed) > texel(table_, peak, row, 0, kRed)) peak = x;
    }
    const double width = edge(36, 46, row, kRed) - degrees(peak);
    EXPECT_LT(width, last) << row;
    last = width;
  }
  EXPECT_LT(last, 0.5);
}

TEST_F(RainbowTable, firstRowIsWhatTheScriptMakes) {
  // Within a hundred thousandth: sums of matrices are not the same bits on all machines.
  const std::string python = test::pythonWithNumpy();
  if (python.empty()) GTEST_SKIP() << "no python3 with numpy";
  const test::TemporaryFolder folder;
  const test::ProcessResult result = test::runProcess(
      {python, test::sourceDir() + "/assets/scripts/make_rainbow.py", folder.path().string(), "--row", "0"},
      {"PYTHONDONTWRITEBYTECODE=1"}, 100);
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const core::TextureData made = core::readDds(folder.path() / "rainbow.dds");
  ASSERT_EQ(made.width, table_.width);
  for (int x = 0; x < made.width; ++x) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(texel(made, x, 0, 0, c), texel(table_, x, 0, 0, c), 1e-6) << x;
  }
}

class HaloTable : public testing::Test {
 protected:
  static double degrees(int x) { return 16 + 0.1 * x; }
  // Where a channel first reaches half of its largest value between two angles.
  double edge(double from, double to, int channel) const {
    const int first = static_cast<int>(std::lround((from - 16) * 10)),
              last = static_cast<int>((to - 16) * 10);
    float peak = 0;
    for (int x = first; x < last; ++x) peak = std::max(peak, texel(table_, x, 0, 0, channel));
    int x = first;
    while (texel(table_, x, 0, 0, channel) < peak / 2) ++x;
    return degrees(x);
  }
  core::TextureData table_ = opticsFile("halo.dds");
};

double leastDeviation(double index, double prismDegrees) {
  return 2 * std::asin(index * std::sin(prismDegrees / 2 * kDegree)) / kDegree - prismDegrees;
}

TEST_F(HaloTable, innerEdgesAreTheLeastDeviationOfPrismsOf60And90Degrees) {
  // Within 0.3 degrees, red inside blue.
  ASSERT_EQ(table_.width, 481);
  EXPECT_NEAR(edge(16, 30, kRed), leastDeviation(kRedIce, 60), 0.3);
  EXPECT_NEAR(edge(16, 30, kBlue), leastDeviation(kBlueIce, 60), 0.3);
  EXPECT_NEAR(edge(40, 54, kRed), leastDeviation(kRedIce, 90), 0.3);
  EXPECT_NEAR(leastDeviation(1.31, 60), 21.8, 0.1);  // as in the textbooks
  EXPECT_LT(edge(16, 30, kRed) + 0.2, edge(16, 30, kBlue));
}

TEST_F(HaloTable, skyInsideIsDarkAndNoMoreLightComesOutThanGoesIn) {
  // Inside the 22 degree halo a tenth of it at most; the integral over the sphere is a share of the light
  // that meets ice, of which half passes by (diffraction).
  EXPECT_LT(texel(table_, 30, 0, 0, 1), texel(table_, 70, 0, 0, 1) / 10);
  double sum = 0;
  for (int x = 0; x < table_.width; ++x)
    sum += static_cast<double>(texel(table_, x, 0, 0, 1)) * 2 * std::numbers::pi *
           std::sin(degrees(x) * kDegree) * 0.1 * kDegree;
  EXPECT_GT(sum, 0.1);
  EXPECT_LT(sum, 0.5);
}

using Vec = glm::dvec3;

// Refraction at a face with outward normal, from index `from` to `to`; false where all is reflected.
bool refract(Vec& ray, const Vec& normal, double from, double to) {
  const double cosine = glm::dot(ray, normal), ratio = from / to;
  const double square = 1 - ratio * ratio * (1 - cosine * cosine);
  if (square < 0) return false;
  ray = ratio * ray + (std::copysign(std::sqrt(square), cosine) - ratio * cosine) * normal;
  return true;
}

// The least azimuth (degrees) by which a level plate turns light of an elevation, over all ways that it can
// be turned: rays through two side faces that are 60 degrees apart. 180: none comes through.
double leastAzimuthByRays(double elevation, double index) {
  double least = 180;
  for (int i = 0; i < 9000; ++i) {
    const double turn = i * 0.01 * kDegree;
    const Vec in(-std::cos(elevation), -std::sin(elevation), 0);
    Vec ray = in;
    const auto side = [&](double angle) { return Vec(std::cos(angle), 0, std::sin(angle)); };
    const Vec first = side(turn), second = side(turn + 2 * std::numbers::pi / 3);
    if (glm::dot(ray, first) >= 0 || !refract(ray, first, 1, index)) continue;
    if (glm::dot(ray, second) <= 0 || !refract(ray, second, index, 1)) continue;
    least = std::min(least, std::abs(std::atan2(ray.z * in.x - ray.x * in.z, ray.x * in.x + ray.z * in.z)));
  }
  return least == 180 ? least : least / kDegree;
}

TEST(SunDogs, azimuthIsTheLeastOfRaysThroughLevelPlates) {
  // At the heights of the light at which there are sun dogs, within 0.1 degrees.
  for (const double elevation : {0.0, 10.0, 25.0, 40.0, 50.0, 58.0}) {
    const double byRays = leastAzimuthByRays(elevation * kDegree, shared::kRedIndexOfIce);
    EXPECT_NEAR(shared::leastSunDogAzimuth(std::sin(elevation * kDegree)) / kDegree, byRays, 0.1)
        << elevation;
  }
  EXPECT_EQ(leastAzimuthByRays(61.5 * kDegree, kRedIce), 180);
}

TEST(SunDogs, tableHasThemAtTheirPlaceAndFadesOutAbove60Degrees) {
  // The brightest column of each height up to 50 degrees lies within a degree outside the least deviation, in
  // the rows of the light's own elevation; blue farther out than red; at 60 degrees a hundredth is left of
  // what there is at 30.
  const core::TextureData table = opticsFile("sun_dogs.dds");
  ASSERT_EQ(table.depth, 21);
  const auto brightest = [&](int z, int channel) {
    glm::ivec2 best(0);
    for (int y = 0; y < table.height; ++y) {
      for (int x = 0; x < table.width; ++x) {
        if (texel(table, x, y, z, channel) > texel(table, best.x, best.y, z, channel)) best = {x, y};
      }
    }
    return best;
  };
  for (int z = 0; z <= 16; ++z) {
    const glm::ivec2 green = brightest(z, 1);
    EXPECT_NEAR(0.25 * green.x - 3, 0.6, 0.6) << z;
    EXPECT_NEAR(green.y, table.height / 2, 2) << z;
    EXPECT_LT(brightest(z, kRed).x, brightest(z, kBlue).x) << z;
  }
  const glm::ivec2 high = brightest(20, 1), middle = brightest(10, 1);
  EXPECT_LT(texel(table, high.x, high.y, 20, 1), texel(table, middle.x, middle.y, 10, 1) / 100);
}

TEST(SunDogs, aSliceIsWhatTheScriptMakes) {
  // With the light at 30 degrees, within a hundred thousandth of its brightest texel.
  const std::string python = test::pythonWithNumpy();
  if (python.empty()) GTEST_SKIP() << "no python3 with numpy";
  const test::TemporaryFolder folder;
  const test::ProcessResult result = test::runProcess(
      {python, test::sourceDir() + "/assets/scripts/make_halo.py", folder.path().string(), "--slice", "10"},
      {"PYTHONDONTWRITEBYTECODE=1"}, 100);
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const core::TextureData made = core::readDds(folder.path() / "sun_dogs.dds"),
                          kept = opticsFile("sun_dogs.dds");
  ASSERT_EQ(made.texels.size(), kept.texels.size());
  for (int y = 0; y < kept.height; ++y) {
    for (int x = 0; x < kept.width; ++x)
      EXPECT_NEAR(texel(made, x, y, 10, 1), texel(kept, x, y, 10, 1), 1e-4) << x;
  }
}

}  // namespace
}  // namespace skydrop
