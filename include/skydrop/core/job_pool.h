// Worker threads for work that must not hold up the frame. Most callers want JobQueue (job_queue.h), which
// returns values; the pool itself only runs functions in the order of their priority.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <stop_token>
#include <thread>
#include <unordered_map>
#include <utility>
#include <vector>

namespace skydrop::core {

using JobId = std::uint64_t;

// A job owns what it works on (values, shared pointers to immutable things) and never points to anything that
// may die before it. It should look at its stop token now and then: a cancelled job may return at once.
using Job = std::function<void(std::stop_token)>;

struct JobStatistics {
  std::size_t queued = 0, running = 0;
  std::size_t longestQueue = 0;  // ever
  std::uint64_t started = 0, cancelled = 0;
  std::uint64_t escaped = 0;  // jobs that let an exception out; it goes no further
};

// All functions may be called from any thread but the workers' own jobs may not destroy the pool.
class JobPool {
 public:
  // Processors - 1, at least 1: one is left to the thread that draws.
  static int defaultWorkerCount();

  // Workers run below normal priority where the system allows it. At most queueLimit jobs wait.
  explicit JobPool(int workers = defaultWorkerCount(), std::size_t queueLimit = 256);

  // Forgets what waits, asks what runs to stop, and waits for that only.
  ~JobPool();

  JobPool(const JobPool&) = delete;
  JobPool& operator=(const JobPool&) = delete;

  // Lower priority values run first, equal ones in order of submission. Nothing when the queue is full.
  std::optional<JobId> submit(double priority, Job job);

  // A waiting job is forgotten, a running one asked to stop; anything else is ignored. True if it had been
  // waiting (so it never ran and never will).
  bool cancel(JobId id);

  // All at once: no worker takes up one of them because another was stopped.
  void cancel(std::span<const JobId> ids);

  // New priorities for jobs that still wait; others are ignored.
  void reprioritise(std::span<const std::pair<JobId, double>> priorities);

  int workers() const { return static_cast<int>(threads_.size()); }
  JobStatistics statistics() const;

 private:
  struct Waiting {
    JobId id;
    double priority;
    Job job;
  };

  void work(std::stop_token quit);
  bool cancelLocked(JobId id, std::vector<Job>& forgotten);

  mutable std::mutex mutex_;
  std::condition_variable_any wake_;
  std::vector<Waiting> waiting_;  // short (queueLimit), so the best is found by looking at all
  std::unordered_map<JobId, std::stop_source> running_;
  std::size_t queueLimit_;
  JobId nextId_ = 1;
  JobStatistics statistics_;
  std::vector<std::jthread> threads_;  // last member: the threads end before what they use
};

}  // namespace skydrop::core
