// A forecast that is renewed on a thread of its own, against a server on this machine.
#include "skydrop/forecast/renewal.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <nlohmann/json.hpp>

#include "skydrop/core/error.h"
#include "support/refusal.h"
#include "support/weather_server.h"

namespace skydrop::forecast {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point since) {
  return std::chrono::duration<double>(Clock::now() - since).count();
}

class RenewalTest : public test::WeatherServerTest {
 protected:
  forecast::RenewalSetup setupAt(const std::string& path) const {
    forecast::RenewalSetup setup;
    setup.folder = folder_.path() / "kept";
    setup.request = at(path);
    setup.limits = limits();
    return setup;
  }

  // Waits for what a thread does; false after 20 s.
  static bool waitFor(const std::function<bool()>& condition) {
    for (const auto since = Clock::now(); secondsSince(since) < 20;) {
      if (condition()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return false;
  }

  // Makes all hours of what the server sends from now on so much warmer.
  void warm(double degrees) const {
    nlohmann::json answer = nlohmann::json::parse(core::readTextFile(answerFile_));
    for (nlohmann::json& value : answer.at("hourly").at("temperature_2m"))
      if (value.is_number()) value = value.get<double>() + degrees;
    core::writeFileAtomically(answerFile_, answer.dump());
  }
};

TEST_F(RenewalTest, asksAgainAndGivesOnlyWhatIsNew) {
  // The first answer comes at once, the same one (304) is none, another one is.
  forecast::RenewalSetup setup = setupAt("/file");
  setup.periodSeconds = 0.02;
  Renewal renewal(setup);
  std::optional<forecast::Renewed> first;
  ASSERT_TRUE(waitFor([&] { return (first = renewal.take()).has_value(); })) << renewal.state().failure;
  const int answers = renewal.state().answers;
  ASSERT_TRUE(waitFor([&] { return renewal.state().answers > answers + 3; }));
  EXPECT_FALSE(renewal.take()) << "the server has sent nothing";
  warm(10);
  std::optional<forecast::Renewed> second;
  ASSERT_TRUE(waitFor([&] { return (second = renewal.take()).has_value(); }));
  EXPECT_NEAR(second->forecast.near.states()[5].state.temperatureC,
              first->forecast.near.states()[5].state.temperatureC + 10, 1e-9);
}

TEST_F(RenewalTest, aFailureKeepsWhatThereIsSaysItsAgeAndIsAskedAgainLaterAndLater) {
  // After 2 s of failures with waits of .1, .2, .4 and .8 s there were at most six questions, not hundreds.
  forecast::RenewalSetup setup = setupAt("/error");
  setup.limits.attempts = 1;
  setup.fetched = sky::Instant{forecast::machineNow().utcMs - 2 * 3600 * 1000};
  setup.retrySeconds = 0.1;
  Renewal renewal(setup);
  ASSERT_TRUE(waitFor([&] { return renewal.state().attempts >= 4; }));
  const std::string line = renewal.state().failure;
  EXPECT_TRUE(test::isOneLineAbout(line, "/error")) << line;
  EXPECT_NE(line.find("status 500; the forecast that is flown in is 2.0 h old"), std::string::npos) << line;
  EXPECT_FALSE(renewal.take());
  const auto since = Clock::now();
  const int before = renewal.state().attempts;
  while (secondsSince(since) < 1) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_LE(renewal.state().attempts, before + 2) << "the waits are doubled";
}

}  // namespace
}  // namespace skydrop::forecast
