#include "skydrop/render/gl/pass_timer.h"

#include <utility>

namespace skydrop::render::gl {
namespace {

// Enough for 20 passes over 4 frames in flight; beyond it the oldest is waited for, so the queue is bounded.
constexpr std::size_t kMaxPending = 80;
constexpr double kMsPerNs = 1e-6;

}  // namespace

PassTimer::PassTimer(Context& context, bool measuring) : context_(&context) { setMeasuring(measuring); }

void PassTimer::setMeasuring(bool measuring) {
  if (!context_->isSoftware()) {
    clock_ = PassClock::timerQuery;
  } else {
    clock_ = measuring ? PassClock::wallClock : PassClock::none;
  }
}

std::string_view PassTimer::clockName() const {
  switch (clock_) {
    case PassClock::none:
      return "none";
    case PassClock::timerQuery:
      return "timer query";
    case PassClock::wallClock:
      return "wall clock between glFinish calls";
  }
  return "";
}

void PassTimer::beginFrame() {
  while (!pending_.empty()) {
    Pending& first = pending_.front();
    const auto nanoseconds = pending_.size() > kMaxPending ? first.query.result() : first.query.poll();
    if (!nanoseconds) break;
    milliseconds_.emplace_back(first.pass, static_cast<double>(*nanoseconds) * kMsPerNs);
    spare_.push_back(std::move(first.query));
    pending_.pop_front();
  }
}

void PassTimer::begin(std::string_view pass) {
  if (paused_) return;
  pass_ = pass;
  if (clock_ == PassClock::wallClock) {
    context_->api().Finish();
    start_ = std::chrono::steady_clock::now();
  } else if (clock_ == PassClock::timerQuery) {
    Query query;
    if (spare_.empty()) {
      query = Query(*context_, GL_TIME_ELAPSED);
    } else {
      query = std::move(spare_.back());
      spare_.pop_back();
    }
    query.begin();
    pending_.push_back({pass_, std::move(query)});
  }
}

void PassTimer::end() {
  if (paused_) return;
  if (clock_ == PassClock::wallClock) {
    context_->api().Finish();
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start_;
    milliseconds_.emplace_back(pass_, elapsed.count());
  } else if (clock_ == PassClock::timerQuery) {
    pending_.back().query.end();
  }
}

void PassTimer::finish() {
  for (Pending& pending : pending_) {
    milliseconds_.emplace_back(pending.pass, static_cast<double>(pending.query.result()) * kMsPerNs);
    spare_.push_back(std::move(pending.query));
  }
  pending_.clear();
}

}  // namespace skydrop::render::gl
