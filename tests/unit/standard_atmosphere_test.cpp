// The standard atmosphere of 1976 against its published tables.
#include "skydrop/weather/standard_atmosphere.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace skydrop::weather {
namespace {

struct Row {
  double heightM;  // geometric
  double temperatureK, pressurePa, densityKgM3;
};

// U.S. Standard Atmosphere 1976, table I (geometric altitude).
constexpr Row kTable[] = {{-5000, 320.676, 1.7776e5, 1.9311},    {-1000, 294.651, 1.1393e5, 1.3470},
                          {0, 288.150, 1.01325e5, 1.2250},       {1000, 281.651, 8.9876e4, 1.1117},
                          {5000, 255.676, 5.4048e4, 7.3643e-1},  {10000, 223.252, 2.6499e4, 4.1351e-1},
                          {15000, 216.650, 1.2111e4, 1.9476e-1}, {20000, 216.650, 5.5293e3, 8.8910e-2},
                          {30000, 226.509, 1.1970e3, 1.8410e-2}, {40000, 250.350, 2.8714e2, 3.9957e-3},
                          {50000, 270.650, 7.9779e1, 1.0269e-3}, {60000, 247.021, 2.1959e1, 3.0968e-4},
                          {70000, 219.585, 5.2209, 8.2829e-5},   {80000, 198.639, 1.0525, 1.8458e-5}};

TEST(StandardAtmosphere, agreesWithThePublishedTable) {
  // Temperature within 5 mK, pressure and density within the table's own five digits.
  for (const Row& row : kTable) {
    const Air air = standardAir(row.heightM);
    EXPECT_NEAR(air.temperatureK, row.temperatureK, 0.005) << row.heightM;
    EXPECT_NEAR(air.pressurePa / row.pressurePa, 1, 1e-4) << row.heightM;
    EXPECT_NEAR(air.densityKgM3 / row.densityKgM3, 1, 1e-4) << row.heightM;
  }
}

TEST(StandardAtmosphere, speedOfSoundIsThatOfTheTable) {
  EXPECT_NEAR(standardAir(0).soundMps, 340.294, 0.001);
  EXPECT_NEAR(standardAir(11000).soundMps, 295.154, 0.001);
}

TEST(StandardAtmosphere, warmAirIsThinnerAndHighPressureDenser) {
  // The ideal gas: density goes with pressure over temperature.
  const double standard = airAt(0, 15, 101325).densityKgM3;
  EXPECT_NEAR(standard, 1.225, 1e-4);
  EXPECT_NEAR(airAt(0, 35, 101325).densityKgM3 / standard, 288.15 / 308.15, 1e-9);
  EXPECT_NEAR(airAt(0, 15, 98000).densityKgM3 / standard, 98000.0 / 101325, 1e-9);
}

}  // namespace
}  // namespace skydrop::weather
