// How long each pass took. On hardware: timer queries, read when they have arrived (some frames later), so
// the pipeline never waits. On a software renderer, where timer queries mean nothing, and in measuring runs
// only: wall clock between two glFinish calls, which makes the frame itself slower.
#pragma once

#include <chrono>
#include <deque>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "skydrop/render/gl/query.h"

namespace skydrop::render::gl {

enum class PassClock { none, timerQuery, wallClock };

class PassTimer {
 public:
  PassTimer() = default;
  // measuring: the user asked for times (--stats, accuracy studies), so a software renderer may be slowed
  // down.
  PassTimer(Context& context, bool measuring);

  // Changes the answer, from the next pass on.
  void setMeasuring(bool measuring);

  PassClock clock() const { return clock_; }
  // What the statistics call it: "none", "timer query", "wall clock between glFinish calls".
  std::string_view clockName() const;

  // Order of calls: beginFrame(), then begin() and end() for each pass, on the context's thread. The first
  // takes over what has arrived of earlier frames; it waits only where more than 80 passes are under way.
  void beginFrame();
  // Passes do not nest.
  void begin(std::string_view pass);
  void end();
  // Waits for every query that is under way: the last frames of a measuring run.
  void finish();

  // What has been measured since the last call: pass and milliseconds, in the order of measuring.
  std::vector<std::pair<std::string, double>> takeMilliseconds() { return std::exchange(milliseconds_, {}); }

 private:
  struct Pending {
    std::string pass;
    Query query;
  };

  Context* context_ = nullptr;
  PassClock clock_ = PassClock::none;
  std::string pass_;
  std::chrono::steady_clock::time_point start_;
  std::deque<Pending> pending_;
  std::vector<Query> spare_;
  std::vector<std::pair<std::string, double>> milliseconds_;
};

}  // namespace skydrop::render::gl
