#include "skydrop/core/job_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <future>
#include <new>
#include <numeric>
#include <set>
#include <vector>

#include "skydrop/core/job_queue.h"
#include "support/margin.h"

namespace skydrop::core {
namespace {

using Queue = JobQueue<int, int>;

constexpr int kQuickJobs = 20;  // of T13: keys below it end at once, the others run until they are stopped

// Occupies the only worker of a pool until it is opened, so that what waits behind it stays waiting.
class Gate {
 public:
  explicit Gate(JobPool& pool) {
    pool.submit(-1e9, [future = open_.get_future().share(), this](std::stop_token) {
      entered_.set_value();
      future.wait();
    });
    entered_.get_future().wait();
  }
  ~Gate() { open(); }
  void open() {
    if (!opened_) open_.set_value();
    opened_ = true;
  }

 private:
  std::promise<void> open_, entered_;
  bool opened_ = false;
};

std::vector<Queue::Result> drainAll(Queue& queue) {
  std::vector<Queue::Result> all;
  while (queue.pending() > 0) {
    for (Queue::Result& result : queue.drain()) all.push_back(std::move(result));
    std::this_thread::yield();
  }
  return all;
}

TEST(JobPool, jobsRunInTheOrderOfTheirPriorityAndThatMayChangeWhileTheyWait) {
  // One worker, held up: three jobs wait; the order of running is that of the last priorities.
  JobPool pool(1);
  std::vector<int> order;
  std::promise<void> done;
  {
    Gate gate(pool);
    const auto a = pool.submit(1, [&](std::stop_token) { order.push_back(1); });
    const auto b = pool.submit(2, [&](std::stop_token) { order.push_back(2); });
    const auto c = pool.submit(3, [&](std::stop_token) { order.push_back(3); });
    pool.submit(100, [&](std::stop_token) { done.set_value(); });
    const std::vector<std::pair<JobId, double>> changed{{*a, 9}, {*b, 8}, {*c, 7}};
    pool.reprioritise(changed);
  }
  done.get_future().wait();
  EXPECT_EQ(order, (std::vector<int>{3, 2, 1}));
}

TEST(JobPool, aFullQueueRefusesAndACancelledJobNeverRuns) {
  JobPool pool(1, 2);
  std::atomic<int> ran = 0;
  std::promise<void> done;
  {
    Gate gate(pool);
    const auto a = pool.submit(0, [&](std::stop_token) { ++ran; });
    ASSERT_TRUE(a);
    ASSERT_TRUE(pool.submit(1, [&](std::stop_token) { ++ran; }));
    EXPECT_FALSE(pool.submit(2, [&](std::stop_token) { ++ran; }));
    EXPECT_TRUE(pool.cancel(*a));
    EXPECT_FALSE(pool.cancel(*a));
    ASSERT_TRUE(pool.submit(2, [&](std::stop_token) { done.set_value(); }));
  }
  done.get_future().wait();
  EXPECT_EQ(ran, 1);
  EXPECT_EQ(pool.statistics().longestQueue, 2u);
}

TEST(JobPool, aRunningJobSeesThatItWasCancelled) {
  JobPool pool(1);
  std::promise<void> entered, left;
  const auto id = pool.submit(0, [&](std::stop_token stop) {
    entered.set_value();
    while (!stop.stop_requested()) std::this_thread::yield();
    left.set_value();
  });
  entered.get_future().wait();
  EXPECT_FALSE(pool.cancel(*id));  // it no longer waits
  left.get_future().wait();
}

TEST(JobQueue, everyWantedKeyIsMadeOnceAndStaleOnesAreCancelled) {
  // A hundred keys are wanted, then other fifty: the first that have not begun are never made.
  JobPool pool(1);
  std::atomic<int> made = 0;
  Queue queue(
      pool, [&](int key, std::stop_token) { return ++made, key * key; }, 1000);
  {
    Gate gate(pool);
    std::vector<int> first(100), second(50);
    std::iota(first.begin(), first.end(), 0);
    std::iota(second.begin(), second.end(), 1000);
    queue.want(first);
    queue.want(second);
    queue.want(second);
  }
  std::set<int> keys;
  for (const Queue::Result& result : drainAll(queue)) {
    ASSERT_TRUE(result.value);
    EXPECT_EQ(*result.value, result.key * result.key);
    EXPECT_TRUE(keys.insert(result.key).second);
  }
  EXPECT_EQ(keys.size(), 50u);
  EXPECT_EQ(*keys.begin(), 1000);
  EXPECT_EQ(made, 50);
}

TEST(JobQueue, atMostItsBoundWaitsAndTheMostUrgentDo) {
  // Ten may wait. New and more urgent keys push the others out; the order of making is that of the last call.
  JobPool pool(1);
  std::vector<int> order;
  Queue queue(
      pool, [&](int key, std::stop_token) { return order.push_back(key), key; }, 10);
  {
    Gate gate(pool);
    std::vector<int> many(1000);
    std::iota(many.begin(), many.end(), 0);
    queue.want(many);
    EXPECT_EQ(pool.statistics().queued, 10u);
    std::reverse(many.begin(), many.end());
    queue.want(many);
    EXPECT_EQ(pool.statistics().queued, 10u);
  }
  drainAll(queue);
  EXPECT_EQ(order, (std::vector<int>{999, 998, 997, 996, 995, 994, 993, 992, 991, 990}));
}

TEST(Stability, T15_aJobThatThrowsIsRetriedThenReportedOnceAndNeverBlocksTheOthers) {
  // Keys divisible by 3 throw bad_alloc, by 5 an int, 7 only the first time: the others arrive, 7 too, each
  // failure is reported once however often it is wanted, and the pool's threads survive.
  test::noFaults("T15", "violations");
  JobPool pool(2);
  std::atomic<int> sevens = 0, threes = 0;
  Queue queue(
      pool,
      [&](int key, std::stop_token) {
        if (key == 3) ++threes;
        if (key % 3 == 0) throw std::bad_alloc();
        if (key % 5 == 0) throw 5;
        if (key == 7 && sevens++ == 0) throw std::runtime_error("first time");
        return key;
      },
      100);
  std::vector<int> wanted(20);
  std::iota(wanted.begin(), wanted.end(), 1);
  std::multiset<int> values, failures;
  for (int frame = 0; frame < 10; ++frame) {
    queue.want(wanted);
    for (const Queue::Result& result : drainAll(queue)) {
      (result.value ? values : failures).insert(result.key);
      if (!result.value) {
        EXPECT_FALSE(result.failure.empty());
      }
      if (result.value) std::erase(wanted, result.key);
    }
  }
  EXPECT_EQ(failures, (std::multiset<int>{3, 5, 6, 9, 10, 12, 15, 18, 20}));
  EXPECT_EQ(values, (std::multiset<int>{1, 2, 4, 7, 8, 11, 13, 14, 16, 17, 19}));
  EXPECT_EQ(threes, 2);
  EXPECT_TRUE(queue.hasGivenUp(3));
  EXPECT_EQ(pool.statistics().escaped, 0u);
  queue.retryFailed();
  EXPECT_FALSE(queue.hasGivenUp(3));
}

TEST(Stability, T15_aWorkerThatStallsHoldsUpOnlyItself) {
  // One of two workers stalls on key 0; the other keys arrive meanwhile, and the stalled one afterwards.
  test::noFaults("T15", "violations");
  JobPool pool(2);
  std::promise<void> release;
  const std::shared_future<void> released = release.get_future().share();
  Queue queue(
      pool,
      [released](int key, std::stop_token) {
        if (key == 0) released.wait();
        return key;
      },
      100);
  std::vector<int> wanted(50);
  std::iota(wanted.begin(), wanted.end(), 0);
  queue.want(wanted);
  std::set<int> arrived;
  while (arrived.size() < 49) {
    for (const Queue::Result& result : queue.drain()) arrived.insert(result.key);
    std::this_thread::yield();
  }
  EXPECT_FALSE(arrived.contains(0));
  release.set_value();
  for (const Queue::Result& result : drainAll(queue)) arrived.insert(result.key);
  EXPECT_TRUE(arrived.contains(0));
}

TEST(Stability, T13_thePoolEndsCleanlyAndWaitsForNothingThatHasNotBegun) {
  // Quit at once, after some jobs and in the middle of a long one: what waits never runs, what runs is asked
  // to stop, and the queue may die before the pool and before its results are drained.
  test::noFaults("T13", "violations");
  const int rounds = std::getenv("SKYDROP_LONG_TESTS") != nullptr ? 1000 : 100;
  for (int round = 0; round < rounds; ++round) {
    std::atomic<int> finished = 0, stopped = 0;
    {
      JobPool pool(2);
      auto payload = std::make_shared<const std::vector<int>>(1000, round);
      Queue queue(
          pool,
          [payload, &finished, &stopped](int key, std::stop_token stop) {
            for (int i = 0; i < 1000000 && key >= kQuickJobs; ++i) {
              if (stop.stop_requested()) return ++stopped, 0;
              std::this_thread::yield();
            }
            ++finished;
            return (*payload)[static_cast<std::size_t>(key)];
          },
          200);
      payload.reset();
      std::vector<int> wanted(200);
      std::iota(wanted.begin(), wanted.end(), 0);
      queue.want(wanted);
      if (round % 3 == 1) queue.drain();
      if (round % 3 == 2) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ASSERT_LE(finished, kQuickJobs);
    ASSERT_LE(stopped, 2);
  }
}

}  // namespace
}  // namespace skydrop::core
