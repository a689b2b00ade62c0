// The weather server on this machine (weather_server.py), for the tests of what asks it.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "skydrop/core/file.h"
#include "skydrop/forecast/fetch.h"
#include "support/background_process.h"
#include "support/paths.h"
#include "support/temporary_folder.h"

namespace skydrop::test {

class WeatherServerTest : public testing::Test {
 protected:
  static constexpr const char* kAnswer = "/tests/corpus/weather/goodOpenMeteo.json";

  void SetUp() override {
    const auto python = findProgram("python3");
    if (!python) GTEST_SKIP() << "no python3";
    answerFile_ = folder_.write("answer.json", core::readTextFile(sourceDir() + kAnswer));
    const std::string portFile = folder_.path() / "port";
    server_ = std::make_unique<BackgroundProcess>(
        std::vector<std::string>{*python, sourceDir() + "/tests/support/weather_server.py", portFile,
                                 answerFile_},
        std::vector<std::string>(), folder_.path() / "log");
    for (int i = 0; i < 2000 && !std::filesystem::exists(portFile); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    port_ = core::readTextFile(portFile);
  }

  std::string url(const std::string& path) const { return "http://127.0.0.1:" + port_ + path; }

  forecast::FetchRequest at(const std::string& path) const {
    forecast::FetchRequest request;
    request.latitudeDegrees = 47.2;
    request.longitudeDegrees = 7.5;
    request.url = url(path);
    return request;
  }

  // Quick to lose patience.
  static forecast::FetchLimits limits() {
    forecast::FetchLimits limits;
    limits.connectS = limits.totalS = 1.5;
    limits.attempts = 3;
    limits.backOffS = 0.01;
    limits.longestBackOffS = 0.05;
    limits.bytes = 1 << 20;
    return limits;
  }

  TemporaryFolder folder_;
  std::string answerFile_;  // what the server sends
  std::unique_ptr<BackgroundProcess> server_;
  std::string port_;
};

}  // namespace skydrop::test
