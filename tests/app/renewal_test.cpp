// A forecast that is renewed beside the flight, against a server on this machine that answers well and badly.
#include "skydrop/forecast/renewal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>

#include "app/session/run_config.h"
#include "app/session/simulation.h"
#include "skydrop/core/error.h"
#include "support/refusal.h"
#include "support/renewal_server.h"
#include "support/shared_noise.h"

namespace skydrop::app {
namespace {

using forecast::Renewal;
using test::Clock, test::secondsSince;

int threads() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word != "Threads:") continue;
    int count = 0;
    status >> count;
    return count;
  }
  return -1;
}

class RenewalTest : public test::RenewalServerTest {
 protected:
  void SetUp() override {
    RenewalServerTest::SetUp();
    if (IsSkipped()) return;
    test::copySharedNoise(folder_.path() / "cache" / "skydrop");
    setenv("XDG_CACHE_HOME", (folder_.path() / "cache").c_str(), 1);
  }
  void TearDown() override { setenv("XDG_CACHE_HOME", test::sharedCacheHome().c_str(), 1); }

  CommandLine liveLine(const std::string& path) const {
    CommandLine line;
    line.scene = "terrain";
    line.userDir = folder_.path() / "user";
    line.autopilot = true;
    line.set = {"effects.weather=true", "weather.variability=0", "live.blendSeconds=5"};
    line.live = LiveRequest{at(path), std::nullopt};
    return line;
  }
};

TEST_F(RenewalTest, aServerThatStallsHoldsUpNeitherTheFlightNorItsEnd) {
  // 1200 steps, a look at the renewal before each fourth as a window has it, while the server sends nothing:
  // every bit is that of a flight without, no look takes 20 ms, and the end does not wait for the 60 s that
  // the server takes.
  CommandLine line = liveLine("/unused");
  line.live.reset();
  line.weatherFiles = {answerFile_};
  const auto fly = [&](Renewal* renewal) {
    const auto run = prepareRun(line);
    Simulation simulation(run->setup, run->settings, run->table);
    double longest = 0;
    for (int i = 0; i < 1200; ++i) {
      if (renewal && i % 4 == 0) {
        const auto since = Clock::now();
        EXPECT_FALSE(renewal->take());
        EXPECT_EQ(renewal->state().failure, "");
        longest = std::max(longest, secondsSince(since));
      }
      simulation.step({});
    }
    EXPECT_LT(longest, 0.02);
    return simulation.world().stateHash();
  };
  const std::uint64_t without = fly(nullptr);
  for (const char* path : {"/silent", "/stalls"}) {
    forecast::RenewalSetup setup = setupAt(path);
    setup.limits = {};  // the program's own: 10 s without a byte
    auto renewal = std::make_unique<Renewal>(setup);
    ASSERT_TRUE(waitFor([&] { return renewal->state().attempts == 1; }));
    EXPECT_EQ(fly(renewal.get()), without) << path;
    const auto since = Clock::now();
    renewal.reset();
    EXPECT_LT(secondsSince(since), 0.5) << path;
  }
}

TEST_F(RenewalTest, aNewerForecastTakesOverWithoutAJump) {
  // 10 degrees in 5 s: no step of 1/120 s changes the temperature that is flown in by more than 1.5 / 600 of
  // that, and in the end it is the new one's.
  const auto run = prepareRun(liveLine("/file"));
  ASSERT_TRUE(run->setup.forecast && run->renewal);
  Simulation simulation(run->setup, run->settings, run->table);
  const auto temperature = [&] { return simulation.world().now().weather.at({0, 0}).temperatureC; };
  simulation.step({});
  const double before = temperature();
  warm(10);
  run->renewal->periodSeconds = 0.02;
  Renewal renewal(*run->renewal);
  std::optional<forecast::Renewed> newer;
  ASSERT_TRUE(waitFor([&] { return (newer = renewal.take()).has_value(); })) << renewal.state().failure;
  run->setup.forecast = simulation.takeForecast(newer->forecast);
  EXPECT_TRUE(simulation.isHandingOver());
  double last = temperature(), most = std::abs(last - before);
  for (int i = 0; i < 605; ++i) {
    simulation.step({});
    most = std::max(most, std::abs(temperature() - std::exchange(last, temperature())));
  }
  EXPECT_LT(most, 10 * 1.51 / 600);
  EXPECT_FALSE(simulation.isHandingOver());
  EXPECT_NEAR(temperature(), before + 10, 0.01);
}

TEST_F(RenewalTest, aFlightBeginsOfflineWithTheNewestAnswerAndSaysItsAge) {
  const CommandLine line = liveLine("/file");
  prepareRun(line);
  server_.reset();
  const auto run = prepareRun(line);
  ASSERT_TRUE(run->setup.forecast && run->renewal && run->renewal->fetched);
  EXPECT_TRUE(std::ranges::any_of(run->notes, [](const std::string& note) {
    return note.find(": fetched ") != std::string::npos && note.ends_with(" ago");
  }));
  CommandLine other = liveLine("/file");
  other.live->fetch.latitudeDegrees = 10;
  EXPECT_TRUE(test::isOneLineAbout(test::refusalOf<core::DataError>([&] { prepareRun(other); }), "127.0.0.1"))
      << "there is nothing to begin with";
  other.weatherFiles = {answerFile_};
  EXPECT_FALSE(prepareRun(other)->renewal->fetched) << "a file will do until the service answers";
}

TEST_F(RenewalTest, whatNobodyAskedForDoesNotExist) {
  // Without --live a run has nothing to renew with, and no thread more than before; with it there is one,
  // until the renewal ends.
  CommandLine line = liveLine("/file");
  line.live.reset();
  const int before = threads();
  {
    const auto run = prepareRun(line);
    Simulation simulation(run->setup, run->settings, run->table);
    EXPECT_FALSE(run->renewal);
    EXPECT_FALSE(run->setup.forecastsCome);
    EXPECT_EQ(threads(), before);
  }
  {
    forecast::RenewalSetup setup = setupAt("/file");
    setup.fetched = forecast::machineNow();  // not due for an hour: it sleeps
    const Renewal renewal(setup);
    EXPECT_EQ(threads(), before + 1);
  }
  EXPECT_TRUE(waitFor([&] { return threads() == before; }));
}

TEST_F(RenewalTest, playIsMadeByHandAndComesAndGoesWithoutAJump) {
  // live.follow off: the weather goes to that of the rows, on again in the middle of that: back from where it
  // is. No step changes 30 degrees by more than the steepest of the blend.
  CommandLine line = liveLine("/file");
  line.live.reset();
  line.weatherFiles = {answerFile_};
  line.set.emplace_back("weather.sites.0.temperature=-30");
  const auto run = prepareRun(line);
  Simulation simulation(run->setup, run->settings, run->table);
  const auto temperature = [&] { return simulation.world().now().weather.at({0, 0}).temperatureC; };
  simulation.step({});
  const double live = temperature();
  double last = live, most = 0;
  const auto fly = [&](int steps) {
    for (int i = 0; i < steps; ++i) {
      simulation.step({});
      most = std::max(most, std::abs(temperature() - std::exchange(last, temperature())));
    }
  };
  const auto follow = [&](bool on) {
    run->settings.live.follow = on;
    simulation.apply({"live.follow"});
  };
  follow(false);
  fly(250);
  EXPECT_LT(temperature(), live - 5);
  follow(true);
  fly(300);
  EXPECT_NEAR(temperature(), live, 0.1);
  follow(false);
  fly(605);
  EXPECT_EQ(temperature(), -30);
  EXPECT_LT(most, (live + 30) * 1.51 / 600);
}

}  // namespace
}  // namespace skydrop::app
