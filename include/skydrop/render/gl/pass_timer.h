// How long each pass took. On hardware: timer queries, read when they have arrived (some frames later), so
// the pipeline never waits. On a software renderer, where timer queries mean nothing, and in measuring runs
// only: wall clock between two glFinish calls, which makes the frame itself slower.
#pragma once

#include <chrono>
#include <deque>
#include <map>
#include <string>
#include <string_view>
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

  PassClock clock() const { return clock_; }
  // What the statistics call it: "none", "timer query", "wall clock between glFinish calls".
  std::string_view clockName() const;

  void beginFrame();
  // Passes do not nest.
  void begin(std::string_view pass);
  void end();
  // Waits for every query that is under way: the last frames of a measuring run.
  void finish();

  // The last time that is known of each pass, in milliseconds.
  const std::map<std::string, double>& milliseconds() const { return milliseconds_; }

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
  std::map<std::string, double> milliseconds_;
};

}  // namespace skydrop::render::gl
