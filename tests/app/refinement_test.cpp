#include "app/session/refinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

namespace skydrop::app {
namespace {

TEST(Refinement, everyRoundDrawsEveryPixelOnceFromCoarseToFine) {
  // Of sizes that no side divides, whatever parts take: rounds of 8, 4, 2 and 1 pixels, none left out.
  for (const Size size : {Size{101, 37}, Size{1, 1}, Size{640, 360}}) {
    for (const double msPerPixel : {1e-6, 0.01, 1.0}) {
      Refinement refinement(size);
      std::vector<int> rounds;
      std::map<int, std::vector<int>> drawn;
      double before = -1;
      for (int i = 0; i < Refinement::kProbes; ++i)
        refinement.drawn(msPerPixel * refinement.next().side * refinement.next().side);
      while (!refinement.isDone()) {
        const Refinement::Part part = refinement.next();
        if (rounds.empty() || rounds.back() != part.pixelSize) rounds.push_back(part.pixelSize);
        std::vector<int>& times = drawn[part.pixelSize];
        times.resize(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
        const int width = part.side * part.pixelSize;
        for (int y = part.corner.y; y < std::min(part.corner.y + width, size.height); ++y) {
          for (int x = part.corner.x; x < std::min(part.corner.x + width, size.width); ++x)
            ++times[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                    static_cast<std::size_t>(x)];
        }
        EXPECT_GT(refinement.share(), before);
        before = refinement.share();
        refinement.drawn(msPerPixel * part.side * part.side);
      }
      EXPECT_EQ(refinement.share(), 1);
      EXPECT_EQ(rounds, (std::vector<int>{8, 4, 2, 1}));
      for (const auto& [pixelSize, times] : drawn)
        EXPECT_TRUE(std::ranges::all_of(times, [](int n) { return n == 1; })) << pixelSize;
    }
  }
}

TEST(Refinement, partsAreAsLargeAsTheTimeForOneAllows) {
  // 40 ms a part, by what a part takes anyway and for each pixel: the least side where pixels are dear; large
  // ones where parts are dear and pixels cheap, for then small parts would take far longer together.
  struct Case {
    double anywayMs, msPerPixel;
    int side;
  };
  for (const Case& c : {Case{0, 0.1, 16}, Case{5, 0.4, 8}, Case{0, 10, 8}, Case{1, 0, 256},
                        Case{100, 0.001, 256}, Case{100, 0.02, 64}}) {
    Refinement refinement({640, 360}, 40);
    while (refinement.next().pixelSize == Refinement::kCoarsest) {
      EXPECT_LE(refinement.next().side, Refinement::kMostSideOfFirstRound);
      refinement.drawn(c.anywayMs + c.msPerPixel * refinement.next().side * refinement.next().side);
    }
    EXPECT_EQ(refinement.next().side, c.side) << c.anywayMs << ' ' << c.msPerPixel;
  }
}

}  // namespace
}  // namespace skydrop::app
