// Renews a forecast beside a flight: a thread asks the service again and again, reads what comes and makes
// the weather of it, so that taking it over costs the thread that draws nothing. It exists only while
// somebody flies with a service.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "skydrop/forecast/kept_answers.h"
#include "skydrop/weather/forecast.h"

namespace skydrop::forecast {

// The age of an answer in words: "45 s", "12 min", "3.5 h", "4 d". Of the future: "0 s".
std::string ageText(sky::Instant fetched, sky::Instant now);

// The time of the machine's clock.
sky::Instant machineNow();

struct RenewalSetup {
  std::filesystem::path folder;                 // of the kept answers
  FetchRequest request;                         // usable (addressOf()); its key is kept in memory
  std::vector<std::filesystem::path> farFiles;  // of a second site, which is not renewed
  // The answer that is flown in: when it was fetched, and its content. Without, the service is asked at once.
  std::optional<sky::Instant> fetched;
  std::uint64_t digest = 0;
  double periodSeconds = 3600;  // from one answer to the next question, > 0
  double retrySeconds = 30;     // after a failure; doubled after each further one, up to the period
  FetchLimits limits;
};

// What came, ready to be flown in.
struct Renewed {
  weather::Forecast forecast;
  std::vector<std::string> notes;  // lines about what was understood with a doubt
};

struct RenewalState {
  std::optional<sky::Instant> fetched;  // when the newest answer was known to be the newest
  std::string failure;                  // one line, with the age of the newest answer; empty: all is well
  int attempts = 0, answers = 0;        // questions asked since the start, and those that were answered
};

// One thread calls; none of the functions waits for the network. The destructor ends what runs within
// milliseconds.
class Renewal {
 public:
  explicit Renewal(RenewalSetup setup);
  Renewal(const Renewal&) = delete;
  Renewal& operator=(const Renewal&) = delete;

  // The newest forecast that has come since the last call and says something else than the one before it.
  std::optional<Renewed> take();
  RenewalState state() const;
  // From the next question on; one that is due by it is asked now.
  void setPeriod(double seconds);

 private:
  void work(const std::stop_token& stop);
  void ask(const std::stop_token& stop);
  double dueInSeconds() const;

  const RenewalSetup setup_;
  mutable std::mutex mutex_;  // of what follows, down to the thread
  std::condition_variable_any wake_;
  RenewalState state_;
  std::uint64_t digest_;
  double periodSeconds_;
  int failuresInARow_ = 0;
  std::optional<Renewed> renewed_;
  std::jthread thread_;  // last: it works with all of the above
};

}  // namespace skydrop::forecast
