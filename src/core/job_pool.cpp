#include "skydrop/core/job_pool.h"

#include <algorithm>

#include "skydrop/core/thread_priority.h"

namespace skydrop::core {
int JobPool::defaultWorkerCount() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
}

JobPool::JobPool(int workers, std::size_t queueLimit) : queueLimit_(std::max<std::size_t>(queueLimit, 1)) {
  threads_.reserve(static_cast<std::size_t>(std::max(workers, 1)));
  for (int i = 0; i < std::max(workers, 1); ++i) {
    threads_.emplace_back([this](std::stop_token quit) { work(quit); });
  }
}

JobPool::~JobPool() {
  {
    const std::scoped_lock lock(mutex_);
    for (std::jthread& thread : threads_) thread.request_stop();
    waiting_.clear();
    for (auto& [id, stop] : running_) stop.request_stop();
  }
  threads_.clear();  // joins
}

std::optional<JobId> JobPool::submit(double priority, Job job) {
  JobId id = 0;
  {
    const std::scoped_lock lock(mutex_);
    if (waiting_.size() >= queueLimit_) return std::nullopt;
    id = nextId_++;
    waiting_.push_back({id, priority, std::move(job)});
    statistics_.longestQueue = std::max(statistics_.longestQueue, waiting_.size());
  }
  wake_.notify_one();
  return id;
}

bool JobPool::cancel(JobId id) {
  std::vector<Job> forgotten;  // destroyed outside the lock: a job may own much
  const std::scoped_lock lock(mutex_);
  return cancelLocked(id, forgotten);
}

void JobPool::cancel(std::span<const JobId> ids) {
  std::vector<Job> forgotten;
  const std::scoped_lock lock(mutex_);
  for (const JobId id : ids) cancelLocked(id, forgotten);
}

bool JobPool::cancelLocked(JobId id, std::vector<Job>& forgotten) {
  const auto at =
      std::find_if(waiting_.begin(), waiting_.end(), [id](const Waiting& w) { return w.id == id; });
  if (at != waiting_.end()) {
    forgotten.push_back(std::move(at->job));
    waiting_.erase(at);
    ++statistics_.cancelled;
    return true;
  }
  if (const auto running = running_.find(id); running != running_.end() && running->second.request_stop()) {
    ++statistics_.cancelled;
  }
  return false;
}

void JobPool::reprioritise(std::span<const std::pair<JobId, double>> priorities) {
  const std::unordered_map<JobId, double> wanted(priorities.begin(), priorities.end());
  const std::scoped_lock lock(mutex_);
  for (Waiting& waiting : waiting_) {
    if (const auto at = wanted.find(waiting.id); at != wanted.end()) waiting.priority = at->second;
  }
}

JobStatistics JobPool::statistics() const {
  const std::scoped_lock lock(mutex_);
  JobStatistics result = statistics_;
  result.queued = waiting_.size();
  result.running = running_.size();
  return result;
}

void JobPool::work(std::stop_token quit) {
  lowerThreadPriority();
  std::unique_lock lock(mutex_);
  while (true) {
    if (!wake_.wait(lock, quit, [this] { return !waiting_.empty(); }) || quit.stop_requested()) return;
    const auto best =
        std::min_element(waiting_.begin(), waiting_.end(), [](const Waiting& a, const Waiting& b) {
          return a.priority != b.priority ? a.priority < b.priority : a.id < b.id;
        });
    const JobId id = best->id;
    Job job = std::move(best->job);
    waiting_.erase(best);
    std::stop_token stop = running_.emplace(id, std::stop_source{}).first->second.get_token();
    ++statistics_.started;
    lock.unlock();

    bool escaped = false;
    try {
      job(stop);
    } catch (...) {
      escaped = true;
    }
    job = nullptr;  // what the job owned goes before it counts as done

    lock.lock();
    running_.erase(id);
    if (escaped) ++statistics_.escaped;
  }
}

}  // namespace skydrop::core
