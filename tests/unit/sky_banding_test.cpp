// Whether the texels of the sky's tables show: what a graphics card makes of them between those that it has,
// in steps of the 8 bits that are shown.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/trigonometric.hpp>
#include <utility>

#include "skydrop/core/shared.h"
#include "skydrop/render/frame/sky_light.h"

namespace skydrop::render {
namespace {

namespace f64 = core::shared::f64;

constexpr double kEyeM = 500;

class SkyBanding : public testing::Test {
 protected:
  void look(double sunDegrees) {
    RenderSettings settings;
    settings.sun = {sunDegrees, 90};
    light_ = skyLight(settings, kEyeM);
  }
  // Light after exposure, the night's included, as shaders/sky/atmosphere.glsl has it, of what both layers
  // hold in a direction.
  glm::dvec3 light(double sine, double cosAzimuth, const glm::dvec3& even, const glm::dvec3& haze) const {
    const double between = sine * light_.toSun.y + std::sqrt(std::max(1 - sine * sine, 0.0)) *
                                                       std::sqrt(1 - light_.toSun.y * light_.toSun.y) *
                                                       cosAzimuth;
    const double phase = f64::henyeyGreenstein(between, light_.air.hazeAnisotropy);
    return ((even + haze * phase) * light_.sunOutside + light_.night) * light_.exposure;
  }
  static glm::dvec3 shown(const glm::dvec3& light) {
    return 255.0 * f64::srgbEncode(f64::toneMap(glm::max(light, glm::dvec3(0))));
  }
  double sineOf(double row) const {
    const double share = (row - f64::kSkyRowsBelow) / (f64::kSkyRowsAbove - 1);
    return light_.view->horizon + (light_.view->airEnds - light_.view->horizon) * share * share;
  }
  // By how much a straight line between places of the curve, half a step on both sides of a place, misses it.
  double missed(double row, double column, double rows, double columns) const {
    const auto at = [&](double share) {
      const double sine = sineOf(row + share * rows),
                   cosAzimuth = 2 * (column + share * columns) / (f64::kSkyColumns - 1) - 1;
      return std::pair(light_.view->at(sky::SkyLayer::skyEven, sine, cosAzimuth),
                       light_.view->at(sky::SkyLayer::skyHaze, sine, cosAzimuth));
    };
    const auto a = at(-0.5), b = at(0.5), middle = at(0);
    const double sine = sineOf(row), cosAzimuth = 2 * column / (f64::kSkyColumns - 1) - 1;
    const glm::dvec3 line = light(sine, cosAzimuth, 0.5 * (a.first + b.first), 0.5 * (a.second + b.second));
    const glm::dvec3 apart =
        glm::abs(shown(line) - shown(light(sine, cosAzimuth, middle.first, middle.second)));
    return std::max({apart.x, apart.y, apart.z});
  }

  SkyLight light_;
};

TEST_F(SkyBanding, whatALineBetweenTexelsMissesIsUnderHalfAStepOf8Bits) {
  // At all hours, above the horizon and over all azimuths, with the texels that the graphics card has: five
  // in the place of a column, two in that of a row. With one each (printed beside it) twilight has kinks of
  // up to eight steps.
  for (const double sun : {60.0, 30.0, 10.0, 3.0, 0.0, -3.0, -6.0, -9.0, -12.0}) {
    look(sun);
    double rows = 0, columns = 0, plainRows = 0, plainColumns = 0;
    constexpr int kFinerRows = 3, kFinerColumns = 6;  // as in src/render/frame/sky_tables.cpp
    for (int i = 0; i < kFinerRows * (f64::kSkyRowsAbove - 1); ++i) {
      for (int j = 0; j < kFinerColumns * (f64::kSkyColumns - 1); ++j) {
        const double row = f64::kSkyRowsBelow + (i + 0.5) / kFinerRows, column = (j + 0.5) / kFinerColumns;
        rows = std::max(rows, missed(row, column, 1.0 / kFinerRows, 0));
        columns = std::max(columns, missed(row, column, 0, 1.0 / kFinerColumns));
      }
    }
    for (double row = f64::kSkyRowsBelow + 0.5; row < f64::kSkyRows - 1; ++row) {
      for (double column = 0.5; column < f64::kSkyColumns - 1; ++column) {
        plainRows = std::max(plainRows, missed(row, column, 1, 0));
        plainColumns = std::max(plainColumns, missed(row, column, 0, 1));
      }
    }
    std::printf("sun %5.1f: rows %.3f, columns %.3f; with one texel each %.3f, %.3f\n", sun, rows, columns,
                plainRows, plainColumns);
    EXPECT_LT(rows, 0.5) << sun;
    EXPECT_LT(columns, 0.5) << sun;
  }
}

}  // namespace
}  // namespace skydrop::render
