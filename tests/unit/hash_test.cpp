#include "skydrop/core/hash.h"

#include <gtest/gtest.h>

#include <set>

namespace skydrop::core {
namespace {

TEST(Hash, streamsOfDifferentSeedsShareNoValue) {
  // Two seeds give two streams: a thousand draws of each, all different.
  RandomStream a{1, 0}, b{2, 0};
  std::set<std::uint64_t> seen;
  for (int i = 0; i < 1000; ++i) {
    seen.insert(a.next());
    seen.insert(b.next());
  }
  EXPECT_EQ(seen.size(), 2000u);
}

TEST(Hash, unitDrawsStayBelowOneAndAverageOneHalf) {
  RandomStream stream{7, 0};
  double sum = 0;
  for (int i = 0; i < 10000; ++i) {
    const double u = stream.nextUnit();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
  }
  EXPECT_NEAR(sum / 10000, 0.5, 0.01);  // standard error .0029
}

TEST(Hash, stateHashSeesTheOrderAndTheSignOfZero) {
  StateHasher a, b, c, d;
  a.add(1.0), a.add(2.0);
  b.add(2.0), b.add(1.0);
  c.add(0.0);
  d.add(-0.0);
  EXPECT_NE(a.value(), b.value());
  EXPECT_NE(c.value(), d.value());
}

}  // namespace
}  // namespace skydrop::core
