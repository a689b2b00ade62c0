// Keyed work with values as results, over a JobPool: says each frame what is wanted and in which order, and
// drains what is ready.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "skydrop/core/guards.h"
#include "skydrop/core/job_pool.h"

namespace skydrop::core {

// Owner: one thread, usually the main one; the pool must outlive the queue. The make function runs on the
// workers and owns what it needs. It may look at its stop token and then return anything: the value of a
// cancelled job is dropped.
template <class Key, class Value, class Hash = std::hash<Key>>
class JobQueue {
 public:
  using Make = std::function<Value(const Key&, std::stop_token)>;

  // A result without a value is a failure: the make function threw each time it was tried.
  struct Result {
    Key key;
    std::optional<Value> value;
    std::string failure;  // the last exception's reason
  };

  // At most `bound` keys of this queue wait in the pool. A key whose job throws is tried `attempts` times in
  // all, then reported once and left alone until retryFailed().
  JobQueue(JobPool& pool, Make make, std::size_t bound, int attempts = 2)
      : pool_(pool),
        make_(std::make_shared<const Make>(std::move(make))),
        bound_(bound),
        attempts_(attempts) {}

  // Cancels everything and waits for nothing: a job that runs keeps alive what it uses.
  ~JobQueue() { cancelAll(); }
  JobQueue(const JobQueue&) = delete;
  JobQueue& operator=(const JobQueue&) = delete;

  // Declares what is wanted, the most urgent first, without what is already at hand. Jobs for other keys are
  // cancelled, also running ones; the first `bound` keys wait in this order, the rest until the next call.
  void want(std::span<const Key> inOrder) {
    const std::unordered_set<Key, Hash> wanted(inOrder.begin(), inOrder.end());
    std::vector<JobId> stale;
    for (auto at = jobs_.begin(); at != jobs_.end();) {
      if (wanted.contains(at->first)) {
        ++at;
      } else {
        stale.push_back(at->second.id);
        at = jobs_.erase(at);
      }
    }
    pool_.cancel(stale);

    const std::unordered_set<std::uint64_t> started = startedTickets();
    std::vector<std::pair<Key, double>> missing;
    std::vector<std::pair<JobId, double>> priorities;
    std::size_t rank = 0;
    for (const Key& key : inOrder) {
      const auto job = jobs_.find(key);
      if (job == jobs_.end()) {
        if (rank < bound_ && !gaveUp_.contains(key)) missing.emplace_back(key, static_cast<double>(rank++));
      } else if (!started.contains(job->second.ticket)) {
        if (rank < bound_) {
          priorities.emplace_back(job->second.id, static_cast<double>(rank++));
        } else if (pool_.cancel(job->second.id)) {
          jobs_.erase(job);
        }
      }
    }
    pool_.reprioritise(priorities);
    for (const auto& [key, priority] : missing) submit(key, priority);
  }

  // What has been finished since the last call, in the order of finishing.
  std::vector<Result> drain() {
    std::vector<Finished> finished;
    {
      const std::scoped_lock lock(shared_->mutex);
      finished.swap(shared_->finished);
      for (const Finished& f : finished) shared_->started.erase(f.ticket);
    }
    std::vector<Result> results;
    for (Finished& f : finished) {
      const auto job = jobs_.find(f.key);
      if (job != jobs_.end() && job->second.ticket == f.ticket) jobs_.erase(job);
      if (f.value) {
        failures_.erase(f.key);
        results.push_back({f.key, std::move(f.value), {}});
      } else if (!f.cancelled) {
        if (++failures_[f.key] < attempts_) {
          countGuard(Guard::jobRetried);
        } else if (gaveUp_.insert(f.key).second) {
          countGuard(Guard::jobFailed);
          results.push_back({f.key, std::nullopt, std::move(f.failure)});
        }
      }
    }
    return results;
  }

  // Waits until there is something to drain, or until the time has come.
  void waitForResult(std::chrono::steady_clock::time_point end) {
    std::unique_lock lock(shared_->mutex);
    shared_->arrived.wait_until(lock, end, [this] { return !shared_->finished.empty(); });
  }

  void cancelAll() {
    std::vector<JobId> all;
    for (const auto& [key, job] : jobs_) all.push_back(job.id);
    pool_.cancel(all);
    jobs_.clear();
  }

  // Keys that were given up may be tried again.
  void retryFailed() {
    gaveUp_.clear();
    failures_.clear();
  }

  bool hasGivenUp(const Key& key) const { return gaveUp_.contains(key); }

  // Keys that wait, run, or are finished and not yet drained.
  std::size_t pending() const { return jobs_.size(); }

 private:
  struct Submitted {
    JobId id;
    std::uint64_t ticket;  // what the job itself knows of its identity
  };
  struct Finished {
    Key key;
    std::uint64_t ticket;
    std::optional<Value> value;
    std::string failure;
    bool cancelled;
  };
  // What the jobs share with the queue; it lives as long as the last of them.
  struct Shared {
    std::mutex mutex;
    std::condition_variable arrived;
    std::vector<Finished> finished;
    std::unordered_set<std::uint64_t> started;  // tickets that run or wait to be drained
  };

  std::unordered_set<std::uint64_t> startedTickets() const {
    const std::scoped_lock lock(shared_->mutex);
    return shared_->started;
  }

  void submit(const Key& key, double priority) {
    const std::uint64_t ticket = nextTicket_++;
    auto job = [make = make_, shared = shared_, key, ticket](std::stop_token stop) {
      {
        const std::scoped_lock lock(shared->mutex);
        shared->started.insert(ticket);
      }
      Finished finished{key, ticket, std::nullopt, {}, false};
      try {
        finished.value.emplace((*make)(key, stop));
      } catch (const std::exception& error) {
        finished.failure = error.what();
      } catch (...) {
        finished.failure = "an exception of unknown type";
      }
      if (stop.stop_requested()) {
        finished.value.reset();
        finished.cancelled = true;
      }
      const std::scoped_lock lock(shared->mutex);
      shared->finished.push_back(std::move(finished));
      shared->arrived.notify_all();
    };
    if (const std::optional<JobId> id = pool_.submit(priority, std::move(job))) {
      jobs_.emplace(key, Submitted{*id, ticket});
    }
  }

  JobPool& pool_;
  std::shared_ptr<const Make> make_;
  std::shared_ptr<Shared> shared_ = std::make_shared<Shared>();
  std::unordered_map<Key, Submitted, Hash> jobs_;
  std::unordered_map<Key, int, Hash> failures_;
  std::unordered_set<Key, Hash> gaveUp_;
  std::size_t bound_;
  int attempts_;
  std::uint64_t nextTicket_ = 1;
};

}  // namespace skydrop::core
