// A forecast that is renewed on a thread of its own, against a server on this machine.
#include "skydrop/forecast/renewal.h"

#include <gtest/gtest.h>

#include <chrono>

#include "skydrop/core/error.h"
#include "support/refusal.h"
#include "support/renewal_server.h"

namespace skydrop::forecast {
namespace {

using test::Clock, test::secondsSince;
using RenewalTest = test::RenewalServerTest;

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
