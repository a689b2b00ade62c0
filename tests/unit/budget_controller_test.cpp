// The frame budget's controller in simulated loads: it comes to the best rung that fits and stays there.
#include "skydrop/accuracy/budget_controller.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace skydrop::accuracy {
namespace {

using testing::HasSubstr;

// Rungs a factor of 1.5 apart, 10 to 76 ms.
std::vector<BudgetRung> ladder(std::size_t count = 6) {
  std::vector<BudgetRung> rungs;
  double ms = 10, error = 0.3;
  for (std::size_t i = 0; i < count; ++i, ms *= 1.5, error /= 2)
    rungs.push_back(
        {"rung" + std::to_string(i), ms, error, {"clouds.march.stepM=" + std::to_string(40 - i)}});
  return rungs;
}

// A machine and a view: what a frame takes with a rung, at a time in seconds.
struct Load {
  std::function<double(double)> factor = [](double) { return 1.0; };  // of the ladder's times
  double restMs = 0;
  double noise = 0;                // share: a standard deviation
  double spikeEvery = 0;           // frames; 0: never
  double spikeMs = 0;              // on top
  double quantumMs = 0;            // times are whole multiples of it; 0: any
  std::vector<double> twist = {};  // what rungs take over what the ladder says; empty: as it says
};

struct Flight {
  std::vector<std::size_t> rungs;  // of each frame
  std::vector<double> ms, seconds;
  std::int64_t changes = 0;

  // How many changes came after this time.
  int changesAfter(double begin) const {
    int count = 0;
    for (std::size_t i = 1; i < rungs.size(); ++i) count += seconds[i] > begin && rungs[i] != rungs[i - 1];
    return count;
  }
  double shareOver(double budget, double begin) const {
    double over = 0, all = 0;
    for (std::size_t i = 0; i < ms.size(); ++i) {
      if (seconds[i] <= begin) continue;
      ++all;
      over += ms[i] > budget;
    }
    return over / all;
  }
};

Flight fly(BudgetController& controller, const Load& load, double seconds, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Flight flight;
  double now = 0;
  for (int frame = 1; now < seconds; ++frame) {
    const std::size_t rung = controller.rung();
    EXPECT_LT(rung, controller.ladder().size());
    double governed = controller.ladder()[rung].ms * load.factor(now);
    if (!load.twist.empty()) governed *= load.twist[rung];
    governed *= std::max(0.1, 1 + load.noise * normal(random));
    double ms = governed + load.restMs;
    if (load.spikeEvery > 0 && frame % static_cast<int>(load.spikeEvery) == 0) ms += load.spikeMs;
    if (load.quantumMs > 0) ms = std::ceil(ms / load.quantumMs) * load.quantumMs;
    flight.rungs.push_back(rung);
    flight.ms.push_back(ms);
    now += ms / 1000;
    flight.seconds.push_back(now);
    controller.note({ms, std::min(ms, ms - load.restMs)});
  }
  flight.changes = controller.changes();
  return flight;
}

TEST(BudgetController, beginsWithTheBestThatFitsByTheLaddersTimes) {
  EXPECT_EQ(BudgetController(ladder(), 33).rung(), 2u);  // 22.5 ms; the next takes 33.75
  EXPECT_EQ(BudgetController(ladder(), 0.5).rung(), 0u);
  EXPECT_EQ(BudgetController(ladder(), 1e4).rung(), 5u);
}

TEST(BudgetController, aStepInTheLoadIsFollowedWithinASecondAndOnce) {
  // Twice the load from 10 s on: down within half a second of frames; half of it again: back up within five.
  BudgetController controller(ladder(), 33);
  const Load load{.factor = [](double now) { return now < 10 || now > 30 ? 1.0 : 2.0; }};
  const Flight flight = fly(controller, load, 60);
  const auto at = [&](double second) {
    const auto i = std::ranges::lower_bound(flight.seconds, second) - flight.seconds.begin();
    return flight.rungs[static_cast<std::size_t>(i)];
  };
  EXPECT_EQ(at(9.9), 2u);
  EXPECT_EQ(at(10.8), 1u) << "15 x 2 = 30 ms fits";
  EXPECT_EQ(at(29.9), 1u);
  EXPECT_EQ(at(36), 2u);
  EXPECT_EQ(flight.changes, 2);
}

TEST(BudgetController, aMachineThatIsSlowerThanTheLadderSaysGetsWhatItCanDraw) {
  BudgetController controller(ladder(), 33);
  const Flight flight = fly(controller, {.factor = [](double) { return 3.0; }, .restMs = 1}, 20);
  EXPECT_EQ(controller.rung(), 0u) << "31 ms";
  EXPECT_TRUE(controller.holds());
  EXPECT_LE(flight.changes, 2);
  EXPECT_EQ(flight.shareOver(33, 3), 0);
}

TEST(BudgetController, aFasterMachineGoesUpToTheBestThatFitsWithItsMargin) {
  BudgetController controller(ladder(), 33);
  const Flight flight = fly(controller, {.factor = [](double) { return 0.5; }}, 30);
  EXPECT_EQ(controller.rung(), 4u) << "25 ms; the best takes 38";
  EXPECT_LE(flight.changes, 2);
  EXPECT_EQ(flight.changesAfter(15), 0);
}

TEST(BudgetController, singleSlowFramesChangeNothing) {
  BudgetController controller(ladder(), 33);
  const Flight flight = fly(controller, {.spikeEvery = 9, .spikeMs = 400}, 120);
  EXPECT_EQ(controller.rung(), 2u);
  EXPECT_EQ(flight.changes, 0);
}

TEST(BudgetController, changesDieOutInNoise) {
  // 30 % of noise over ten minutes, wherever the load stands against the budget. A change that is undone
  // doubles the time to the next: ten minutes have room for six tries of a rung, the second half for two, at
  // two changes each, and two rungs may fit by prediction and not in flight. Without that it is hundreds.
  for (const double noise : {0.2, 0.3}) {
    for (double factor = 0.5; factor < 3; factor *= 1.07) {
      BudgetController controller(ladder(), 33);
      const Load load{.factor = [&](double) { return factor; }, .restMs = 2, .noise = noise};
      const Flight flight = fly(controller, load, 600, static_cast<unsigned>(1000 * factor));
      EXPECT_LE(flight.changes, 24) << factor << ", noise " << noise;
      EXPECT_LE(flight.changesAfter(300), 8) << factor << ", noise " << noise;
      const double least = factor * controller.ladder().front().ms + 2;
      if (least < 33) {
        EXPECT_LE(factor * controller.chosen().ms + 2, 1.1 * 33) << factor << ", noise " << noise;
      } else {
        EXPECT_EQ(controller.rung(), 0u) << factor;
      }
    }
  }
}

TEST(BudgetController, itFollowsASlowDriftWithoutTurningBack) {
  // The load grows fivefold over two minutes: it goes down rung by rung and never up.
  BudgetController controller(ladder(), 33);
  const Load load{.factor = [](double now) { return 0.6 + 2.4 * now / 120; }, .noise = 0.05};
  const Flight flight = fly(controller, load, 120);
  EXPECT_TRUE(std::ranges::is_sorted(flight.rungs.begin() + 300, flight.rungs.end(), std::greater<>()));
  EXPECT_LE(flight.changes, 7);
  EXPECT_LT(flight.shareOver(1.1 * 33, 1), 0.05);
}

TEST(BudgetController, timesInStepsOfARefreshDoNotMakeItSwing) {
  // A screen of 60 Hz shows 18 ms as 33.3: the prediction for the next rung fits and does not hold.
  for (double factor = 0.3; factor < 3; factor *= 1.11) {
    BudgetController controller(ladder(), 25);
    const Load load{.factor = [&](double) { return factor; }, .quantumMs = 1000 / 60.0};
    const Flight flight = fly(controller, load, 600);
    EXPECT_LE(flight.changes, 24) << factor;
    EXPECT_LE(flight.changesAfter(300), 8) << factor;
  }
}

TEST(BudgetController, aRungThatTakesMoreThanItShouldIsTriedEverMoreSeldom) {
  // The third rung and the last take three times what was measured. Tries of either are 10, 20, 40 ... s
  // apart: seven in this time, of two changes each.
  BudgetController controller(ladder(4), 33);
  const Load load{.factor = [](double) { return 0.8; }, .twist = {1, 1, 3, 3}};
  const Flight flight = fly(controller, load, 1300);
  EXPECT_EQ(controller.rung(), 1u);
  EXPECT_LE(flight.changes, 2 * 2 * 7);
  EXPECT_GE(flight.changes, 5) << "it does try again";
  EXPECT_LT(flight.shareOver(33, 0), 0.01);
}

TEST(BudgetController, whatIsKnownOfARungIsInTheReason) {
  BudgetController controller(ladder(), 33);
  EXPECT_EQ(controller.reason(), "budget 33 ms: rung2; the next better, rung3, would need 34 ms");
  fly(controller, {.factor = [](double) { return 1.2; }, .restMs = 2}, 5);
  EXPECT_EQ(controller.reason(), "29.0 of 33 ms: rung2; the next better, rung3, would need 42 ms");
}

TEST(BudgetController, whatCannotBeHeldIsReported) {
  BudgetController controller(ladder(), 4);
  const Flight flight = fly(controller, {}, 5);
  EXPECT_EQ(flight.changes, 0);
  EXPECT_FALSE(controller.holds());
  EXPECT_EQ(controller.reason(), "10.0 of 4 ms: rung0, the cheapest, does not fit; nothing is left to turn");
}

TEST(BudgetController, aLadderOfOneStays) {
  BudgetController controller(ladder(1), 33);
  EXPECT_EQ(fly(controller, {.factor = [](double now) { return now < 5 ? 1.0 : 9.0; }}, 20).changes, 0);
  EXPECT_FALSE(controller.holds());
  BudgetController roomy(ladder(1), 1000);
  fly(roomy, {}, 5);
  EXPECT_THAT(roomy.reason(), HasSubstr("the best that was measured"));
}

TEST(BudgetController, timesThatCannotBeAreIgnored) {
  // Between good frames: not one of them moves the median or the rung.
  BudgetController controller(ladder(), 33);
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 300; ++i) {
    for (const double bad : {nan, inf, -inf, 0.0, -5.0, 1e9}) EXPECT_FALSE(controller.note({bad, bad}));
    EXPECT_FALSE(controller.note({22.5, 22.5}));
  }
  EXPECT_EQ(controller.medianMs(), 22.5);
  EXPECT_EQ(controller.rung(), 2u);
  for (const double bad : {nan, inf, -1.0, 99.0}) controller.note({22.5, bad});
  EXPECT_NEAR(controller.predictedMs(3), 33.75, 1e-9) << "a part that is none counts as the whole frame";
}

TEST(BudgetController, theSameFramesMakeTheSameChoices) {
  BudgetController a(ladder(), 33), b(ladder(), 33);
  const Load load{.factor = [](double now) { return 1.5 + std::sin(now / 7); }, .noise = 0.25};
  EXPECT_EQ(fly(a, load, 200).rungs, fly(b, load, 200).rungs);
}

TEST(BudgetController, framesOfAnotherSceneAreForgotten) {
  BudgetController controller(ladder(), 33);
  for (int i = 0; i < 7; ++i) controller.note({200, 200});
  controller.forgetFrames();
  EXPECT_EQ(controller.medianMs(), 0);
  for (int i = 0; i < 7; ++i) EXPECT_FALSE(controller.note({200, 200})) << "two settle, five are too few";
  EXPECT_EQ(controller.rung(), 2u);
}

}  // namespace
}  // namespace skydrop::accuracy
