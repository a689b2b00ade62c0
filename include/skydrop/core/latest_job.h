// One piece of work at a time beside the caller, of which only the newest matters: for what is made again
// while a slider is dragged.
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

namespace skydrop::core {

// Makes values from keys on a thread of its own, which is started by the first request. A request replaces
// one that waits; what is being made is finished, so that a drag shows something now and then and never
// queues up. One thread calls; its destructor asks what runs to stop and waits for that only. make() must not
// touch what may die before this.
template <class Key, class Value>
class LatestJob {
 public:
  using Make = std::function<Value(const Key&, std::stop_token)>;

  explicit LatestJob(Make make) : make_(std::move(make)) {}
  LatestJob(const LatestJob&) = delete;
  LatestJob& operator=(const LatestJob&) = delete;

  void request(Key key) {
    {
      const std::scoped_lock lock(mutex_);
      waiting_ = std::move(key);
    }
    if (!thread_.joinable()) thread_ = std::jthread([this](std::stop_token stop) { work(stop); });
    wake_.notify_all();
  }

  // The newest that is done since the last call; nothing while there is none. Throws what ended the newest
  // early.
  std::optional<Value> take() {
    const std::scoped_lock lock(mutex_);
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    return std::exchange(made_, std::nullopt);
  }

  bool isBusy() const {
    const std::scoped_lock lock(mutex_);
    return waiting_ || running_;
  }

  // Returns when it is not busy: for pictures without a window, and tests.
  void wait() const {
    std::unique_lock lock(mutex_);
    wake_.wait(lock, [this] { return !waiting_ && !running_; });
  }

 private:
  void work(std::stop_token stop) {
    std::unique_lock lock(mutex_);
    while (wake_.wait(lock, stop, [this] { return waiting_.has_value(); })) {
      const Key key = *std::exchange(waiting_, std::nullopt);
      running_ = true;
      lock.unlock();
      std::optional<Value> made;
      std::exception_ptr failure;
      try {
        made.emplace(make_(key, stop));
      } catch (...) {
        failure = std::current_exception();
      }
      lock.lock();
      running_ = false;
      if (stop.stop_requested()) break;
      made_ = std::move(made);
      failure_ = failure;
      wake_.notify_all();
    }
  }

  Make make_;
  mutable std::mutex mutex_;  // of what follows
  mutable std::condition_variable_any wake_;
  std::optional<Key> waiting_;
  std::optional<Value> made_;
  std::exception_ptr failure_;
  bool running_ = false;
  std::jthread thread_;  // last: it works with all of the above
};

}  // namespace skydrop::core
