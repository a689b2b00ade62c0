// The hunt through the light volume: cells of any depth, layers of any thickness and extinction under any
// sun, and places anywhere. SKYDROP_HUNT=1000000 tries more (docs/hunt.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/packing.hpp>

#include "clouds/light_cell.h"
#include "skydrop/clouds/light_volume.h"
#include "skydrop/core/shared.h"
#include "support/cloud_noise.h"
#include "support/hunt.h"
#include "support/hunt_numbers.h"
#include "support/instrumented.h"
#include "support/margin.h"

namespace skydrop::clouds {
namespace {

namespace f32 = core::shared::f32;
using test::HuntNumbers;

constexpr double kPi = glm::pi<double>();

std::uint64_t rounds(int usual) {
  return test::huntedInputs(static_cast<std::uint64_t>(test::repetitions(usual)));
}

TEST(LightVolumeHunt, aCellLosesWhatItsMeanTakes) {
  // Of any optical depth from 0 to 1e30: both shares those of long double within 1e-6, and depth * kept = 1 -
  // left within 1e-6: light is neither made nor lost.
  HuntNumbers n(50);
  for (std::uint64_t i = 0; i < rounds(200000); ++i) {
    const auto depth = static_cast<float>(std::abs(n.finite({0.5, 1e-3, 69, 88, 104})));
    const CellPassage cell = cellPassage(depth);
    const auto exact = static_cast<long double>(depth);
    const long double kept = exact > 0 ? -expm1l(-exact) / exact : 1;
    ASSERT_NEAR(cell.left, static_cast<double>(expl(-exact)), 1e-6) << depth << " " << i;
    ASSERT_LE(std::abs(static_cast<double>(cell.kept / kept - 1)), 1e-6) << depth << " " << i;
    ASSERT_NEAR(static_cast<double>(depth) * static_cast<double>(cell.kept),
                1 - static_cast<double>(cell.left), 1e-6)
        << depth << " " << i;
    ASSERT_TRUE(cell.left >= 0 && cell.left <= 1 && cell.kept >= 0 && cell.kept <= 1) << depth << " " << i;
  }
}

// One volume of the quick noise for the tests of places.
const LightVolume& quickVolume() {
  static const LightVolume volume(CloudField(test::quickNoise(), test::cloudySettings()),
                                  {std::cos(0.6), std::sin(0.6), 0});
  return volume;
}
struct Frame {
  double baseM, thicknessM, periodM;
};
Frame quickFrame() {
  const CloudField field(test::quickNoise(), test::cloudySettings());
  return {field.layer().cloudHeight, field.layer().thickness, weatherPeriod(field.medium())};
}

TEST(LightVolumeHunt, aPlaceHasTheMeanOfItsEightCells) {
  // Any finite place up to 1e30 m: between the least and the largest of its cells; within 1e9 m that of long
  // double, as far as the place is known; across the border of cells no further than rounding; and the same
  // whole periods away.
  const LightVolume& volume = quickVolume();
  const Frame frame = quickFrame();
  constexpr int kSide = LightVolume::kSide, kRows = LightVolume::kRows;
  const double cellM = frame.periodM / kSide, rowM = frame.thicknessM / kRows;
  const auto texelAt = [&](std::int64_t x, int row, std::int64_t z) -> const LightVolume::Texel& {
    const auto wrapped = [](std::int64_t i) { return static_cast<std::size_t>(i & (kSide - 1)); };
    return volume
        .texels()[(wrapped(z) * kRows + static_cast<std::size_t>(std::clamp(row, 0, kRows - 1))) * kSide +
                  wrapped(x)];
  };
  HuntNumbers n(51);
  for (std::uint64_t i = 0; i < rounds(50000); ++i) {
    const auto level = [&] {
      const double border = (static_cast<double>(n.pick(2 * kSide)) - kSide + 0.5) * cellM;
      return n.finite({border, border + 0.5 * cellM, frame.periodM, -frame.periodM});
    };
    const glm::dvec3 place(
        level(), n.finite({frame.baseM, frame.baseM + frame.thicknessM, frame.baseM + 0.5 * rowM}), level());
    const LightVolume::Texel found = volume.at(place);
    ASSERT_TRUE(found.sun >= 0 && found.sky >= 0 && found.ground() >= 0)
        << place.x << " " << place.y << " " << i;
    if (std::max(std::abs(place.x), std::abs(place.z)) > 1e9) continue;
    const auto cellOf = [](double metres, double unit) {
      return static_cast<long double>(metres) / unit - 0.5L;
    };
    const long double x = cellOf(place.x, cellM), z = cellOf(place.z, cellM),
                      row = std::clamp(cellOf(place.y - frame.baseM, rowM), 0.0L, kRows - 1.0L);
    long double sun = 0, sky = 0;
    float least = 1e9F, most = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const int dx = corner & 1, dy = corner >> 1 & 1, dz = corner >> 2;
      const auto share = [](long double at, int side) {
        const long double t = at - std::floor(at);
        return side == 1 ? t : 1 - t;
      };
      const LightVolume::Texel& texel =
          texelAt(static_cast<std::int64_t>(std::floor(x)) + dx, static_cast<int>(std::floor(row)) + dy,
                  static_cast<std::int64_t>(std::floor(z)) + dz);
      const long double weight = share(x, dx) * share(row, dy) * share(z, dz);
      sun += weight * static_cast<long double>(texel.sun);
      sky += weight * static_cast<long double>(texel.sky);
      least = std::min(least, texel.sun);
      most = std::max(most, texel.sun);
    }
    // A place is known to 2^-52 of its distance; sun and sky differ by less than 1 from cell to cell.
    const double known =
        4 * 2.3e-16 * (std::abs(place.x) + std::abs(place.z) + std::abs(place.y)) / std::min(cellM, rowM);
    ASSERT_NEAR(found.sun, static_cast<double>(sun), 2e-6 + known)
        << place.x << " " << place.y << " " << place.z << " " << i;
    ASSERT_NEAR(found.sky, static_cast<double>(sky), 2e-6 + known)
        << place.x << " " << place.y << " " << place.z << " " << i;
    ASSERT_TRUE(static_cast<double>(found.sun) >= static_cast<double>(least) - 1e-6 - known &&
                static_cast<double>(found.sun) <= static_cast<double>(most) + 1e-6 + known)
        << place.x << " " << place.y << " " << place.z << " " << i;
    const LightVolume::Texel beside = volume.at({std::nextafter(place.x, 1e300), place.y, place.z});
    ASSERT_NEAR(beside.sun, found.sun, 1e-6 + known) << place.x << " " << i;
    const double turns = static_cast<double>(n.pick(1000)) - 500;
    const LightVolume::Texel away = volume.at({place.x + turns * frame.periodM, place.y, place.z});
    ASSERT_NEAR(away.sun, found.sun, 1e-6 + known + 1e-15 * 500 * kSide)
        << place.x << " " << turns << " " << i;
  }
}

TEST(LightVolumeHunt, halfPrecisionKeepsTheLight) {
  // Of any light from 0 to 1: within a unit of half of 2^-11, or 2^-25 of the smallest; the ground's share
  // never below 0, though 1 / pi is rounded up.
  HuntNumbers n(52);
  for (std::uint64_t i = 0; i < rounds(200000); ++i) {
    const auto sun = static_cast<float>(std::clamp(std::abs(n.finite()), 0.0, 1.0));
    const auto sky = static_cast<float>(std::clamp(std::abs(n.finite({1 / kPi})), 0.0, 1 / kPi));
    const glm::vec2 back = glm::unpackHalf2x16(glm::packHalf2x16({sun, std::min(sky, 1 / glm::pi<float>())}));
    ASSERT_NEAR(back.x, sun, std::max(4.9e-4 * static_cast<double>(sun), 3e-8)) << sun << " " << i;
    ASSERT_NEAR(back.y, sky, std::max(4.9e-4 * static_cast<double>(sky), 3e-8)) << sky << " " << i;
    ASSERT_GE(f32::groundOfVolume(back.y), 0) << sky << " " << i;
    ASSERT_NEAR(f32::groundOfVolume(back.y), 1 / kPi - static_cast<double>(sky), 2e-4) << sky << " " << i;
  }
}

TEST(LightVolumeHunt, lightOfAnyLayerIsWithinWhatComesIn) {
  // Layers of any thickness, extinction, cover and anisotropy of the settings, the sun at any height: sky and
  // ground together as much as outside, no light of the sun where there is none, and never more than five
  // times the even light of it (a conservative half-space under a zenith sun has 5.04 deep inside:
  // Chandrasekhar's H(1) sqrt 3).
  HuntNumbers n(53);
  const std::uint64_t volumes = std::max<std::uint64_t>(1, rounds(300000) / 100000);
  for (std::uint64_t i = 0; i < volumes; ++i) {
    CloudSettings settings = test::cloudySettings();
    CloudLayerSettings& layer = settings.layers[0];
    layer.extinction = i == 0 ? 1 : std::pow(10.0, -4 * n.unit());
    layer.thickness = i == 0 ? 6000 : n.within(50, 6000);
    layer.coverage = i == 0 ? 1 : n.within(0, 1);
    layer.anisotropy = i == 0 ? 0 : n.within(0, 0.95);
    layer.forwardShare = i == 0 ? 0 : n.within(0, 1);
    const double height = i == 0 ? kPi / 2 : n.within(-0.2, kPi / 2), azimuth = n.within(0, 2 * kPi);
    const glm::dvec3 toSun(std::cos(height) * std::cos(azimuth), std::sin(height),
                           std::cos(height) * std::sin(azimuth));
    const LightVolume volume(CloudField(test::quickNoise(), settings), toSun);
    ASSERT_TRUE(volume.isSolved());
    float brightest = 0;
    for (const LightVolume::Texel& texel : volume.texels()) {
      ASSERT_TRUE(std::isfinite(texel.sun) && texel.sun >= 0 && texel.sky >= 0 && texel.ground() >= 0) << i;
      brightest = std::max(brightest, texel.sun);
    }
    RecordProperty("brightest" + std::to_string(i), std::to_string(static_cast<double>(brightest) * 4 * kPi));
    EXPECT_LE(static_cast<double>(brightest) * 4 * kPi, toSun.y > 0 ? 5.04 : 0)
        << "extinction " << layer.extinction << " thickness " << layer.thickness << " sun " << height;
  }
}

}  // namespace
}  // namespace skydrop::clouds
