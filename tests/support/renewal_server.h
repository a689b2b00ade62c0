// What the tests of a forecast's renewal have in common: a server whose answer changes, and waiting for a
// thread.
#pragma once

#include <chrono>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "skydrop/core/file.h"
#include "skydrop/forecast/renewal.h"
#include "support/weather_server.h"

namespace skydrop::test {

using Clock = std::chrono::steady_clock;

inline double secondsSince(Clock::time_point since) {
  return std::chrono::duration<double>(Clock::now() - since).count();
}

class RenewalServerTest : public WeatherServerTest {
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

}  // namespace skydrop::test
