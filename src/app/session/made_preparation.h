// A preparation that is one function of values, run on a thread of its own.
#pragma once

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "app/session/preparation.h"

namespace skydrop::app {

// Begins when it is constructed; the thread ends with it, as soon as make() heeds its stop token. make()
// gives null when it was stopped, and notes how far it is, 0 .. 1. A graphics card is not asked for help.
template <class Result>
class MadePreparation final : public Preparation {
 public:
  using Make = std::function<std::shared_ptr<const Result>(std::stop_token, std::atomic<double>& progress)>;

  MadePreparation(std::string_view title, Make make)
      : title_(title), thread_([this, make = std::move(make)](std::stop_token stop) { run(make, stop); }) {}

  std::string_view title() const override { return title_; }
  double progress() const override { return progress_; }
  bool isReady() const override {
    const std::scoped_lock lock(mutex_);
    if (failure_) std::rethrow_exception(failure_);
    return result_ != nullptr;
  }
  void waitUntilReady() const override {
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return result_ || failure_; });
    }
    static_cast<void>(isReady());
  }
  void makePart(render::gl::Context&) override {}
  void putResult(PreparedResources& resources) const override {
    const std::scoped_lock lock(mutex_);
    resources.put(result_);
  }
  std::vector<std::string> takeMessages() override { return {}; }

 private:
  void run(const Make& make, std::stop_token stop) {
    try {
      std::shared_ptr<const Result> made = make(stop, progress_);
      const std::scoped_lock lock(mutex_);
      result_ = std::move(made);
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      failure_ = std::current_exception();
    }
    changed_.notify_all();
  }

  std::string title_;
  std::atomic<double> progress_ = 0;
  mutable std::mutex mutex_;  // of what follows
  mutable std::condition_variable changed_;
  std::shared_ptr<const Result> result_;
  std::exception_ptr failure_;
  std::jthread thread_;  // last: it works with all of the above
};

}  // namespace skydrop::app
