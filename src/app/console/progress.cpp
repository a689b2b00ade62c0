#include "app/console/progress.h"

#include <unistd.h>

#include <chrono>
#include <limits>
#include <utility>

namespace skydrop::app {
namespace {

constexpr double kOverwrittenPeriodS = 0.1, kLinesPeriodS = 1;

double monotonicSeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Progress::Progress(std::string verb, Style style, std::FILE* to, Clock clock)
    : verb_(std::move(verb)),
      style_(style),
      to_(to),
      clock_(std::move(clock)),
      nextS_(-std::numeric_limits<double>::infinity()) {}

Progress::Progress(std::string verb, bool asked)
    : Progress(std::move(verb),
               ::isatty(STDERR_FILENO) ? Style::overwritten
               : asked                 ? Style::lines
                                       : Style::none,
               stderr, monotonicSeconds) {}

bool Progress::isDue() const { return style_ != Style::none && clock_() >= nextS_; }

void Progress::show(const std::string& state) {
  if (style_ == Style::none) return;
  const bool overwritten = style_ == Style::overwritten;
  nextS_ = clock_() + (overwritten ? kOverwrittenPeriodS : kLinesPeriodS);
  std::fprintf(to_, overwritten ? "\r%s: %s\x1b[K" : "%s: %s\n", verb_.c_str(), state.c_str());
  std::fflush(to_);
  shown_ = overwritten;
}

void Progress::clear() {
  if (!std::exchange(shown_, false)) return;
  std::fputs("\r\x1b[K", to_);
  std::fflush(to_);
}

}  // namespace skydrop::app
