#include "skydrop/accuracy/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace skydrop::accuracy {
namespace {

constexpr int kWidth = 64, kHeight = 48;
using Color = std::array<int, 3>;

std::vector<double> picture(const std::function<Color(int, int)>& at) {
  std::vector<double> values;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      for (const int channel : at(x, y)) values.push_back(channel / 255.0);
    }
  }
  return values;
}

Color ramp(int x, int y) { return {4 * x % 256, 5 * y % 256, (3 * x + 2 * y) % 256}; }
Color checker(int x, int y, int dark) {
  return (x / 4 + y / 4) % 2 ? Color{200, 180, 160} : Color{dark, 70, 80};
}

struct Seen {
  std::vector<double> values;
  operator SeenPicture() const { return {kWidth, kHeight, values}; }
};
Seen plain(const Color& color) {
  return {picture([&](int, int) { return color; })};
}

TEST(Flip, agreesWithTheProgramOfItsAuthors) {
  // Means and one pixel of six pairs, by the package flip-evaluator 1.7 (which computes in float: 1e-4).
  const Seen black = plain({0, 0, 0}), ramps{picture(ramp)};
  const Seen checkers{picture([](int x, int y) { return checker(x, y, 60); })};
  struct Pair {
    Seen reference, test;
    double mean, pixel;
  };
  const std::vector<Pair> pairs = {{black, plain({255, 255, 255}), 0.9673652648925781, 0.9673883318901062},
                                   {ramps,
                                    {picture([](int x, int y) { return ramp(x + 1, y); })},
                                    0.11521682143211365,
                                    0.08804229646921158},
                                   {checkers,
                                    {picture([](int x, int y) { return checker(x, y, 66); })},
                                    0.029925258830189705,
                                    0.031242607161402702},
                                   {ramps, checkers, 0.8139669895172119, 0.4804002642631531},
                                   {black,
                                    {picture([](int x, int y) {
                                      return x == 32 && y == 24 ? Color{255, 255, 255} : Color{0, 0, 0};
                                    })},
                                    0.00465796934440732,
                                    0.8649064898490906},
                                   {plain({0, 255, 0}), plain({0, 0, 255}), 1, 1}};
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_NEAR(flip(pairs[i].test, pairs[i].reference), pairs[i].mean, 1e-4) << i;
    EXPECT_NEAR(flipMap(pairs[i].test, pairs[i].reference)[24 * kWidth + 32], pairs[i].pixel, 5e-4) << i;
  }
}

TEST(Flip, isZeroForEqualPicturesSymmetricAndAtMostOne) {
  const Seen a{picture(ramp)}, b{picture([](int x, int y) { return checker(x, y, 60); })};
  EXPECT_EQ(flip(a, a), 0);
  EXPECT_DOUBLE_EQ(flip(a, b), flip(b, a));
  for (const double error : flipMap(a, b)) {
    EXPECT_GE(error, 0);
    EXPECT_LE(error, 1);
  }
}

TEST(Flip, weighsAnEdgeMoreThanTheSameColourWithoutOne) {
  // A line of another colour is worse, pixel for pixel, than the same difference of colour everywhere.
  const Seen grey = plain({120, 120, 120}), lighter = plain({140, 140, 140});
  const Seen line{picture([](int x, int) { return x == 30 ? Color{140, 140, 140} : Color{120, 120, 120}; })};
  const double even = flipMap(lighter, grey)[24 * kWidth + 30];
  const double atLine = flipMap(line, grey)[24 * kWidth + 30];
  const Seen wide{picture([](int x, int) { return x >= 30 ? Color{140, 140, 140} : Color{120, 120, 120}; })};
  EXPECT_GT(flipMap(wide, grey)[24 * kWidth + 30], even * 0.9);
  EXPECT_GT(atLine, 0);
}

TEST(Flip, theHeatMapGrowsBrighterWithTheError) {
  const core::Image heat = heatMap({0, 0.25, 0.5, 0.75, 1}, 5, 1);
  int before = -1;
  for (int x = 0; x < 5; ++x) {
    const int sum = heat.pixel(x, 0)[0] + heat.pixel(x, 0)[1] + heat.pixel(x, 0)[2];
    EXPECT_GT(sum, before);
    before = sum;
  }
}

}  // namespace
}  // namespace skydrop::accuracy
