#include "skydrop/core/latest_job.h"

#include <gtest/gtest.h>

#include <atomic>
#include <semaphore>
#include <stdexcept>

namespace skydrop::core {
namespace {

TEST(LatestJob, givesTheNewestAndSkipsWhatWasReplaced) {
  // While the first is made, 98 of 99 further requests are forgotten: two are made in all.
  std::counting_semaphore<> begin(0), begun(0);
  std::atomic<int> made = 0;
  LatestJob<int, int> job([&](const int& key, std::stop_token) {
    begun.release();
    begin.acquire();
    ++made;
    return 10 * key;
  });
  job.request(0);
  begun.acquire();
  for (int key = 1; key < 100; ++key) job.request(key);
  EXPECT_TRUE(job.isBusy());
  EXPECT_EQ(job.take(), std::nullopt);
  begin.release(2);
  job.wait();
  EXPECT_FALSE(job.isBusy());
  EXPECT_EQ(job.take(), 990);
  EXPECT_EQ(job.take(), std::nullopt);
  EXPECT_EQ(made, 2);
}

TEST(LatestJob, endsWhileItRuns) {
  // The destructor asks for a stop and returns when the job has heeded it.
  std::atomic<bool> stopped = false;
  {
    std::binary_semaphore begun(0);
    LatestJob<int, int> job([&](const int&, std::stop_token stop) {
      begun.release();
      while (!stop.stop_requested()) std::this_thread::yield();
      stopped = true;
      return 0;
    });
    job.request(1);
    begun.acquire();
  }
  EXPECT_TRUE(stopped);
}

TEST(LatestJob, handsFailuresToTheCaller) {
  // take() throws once what make() threw; the next request is made as ever.
  LatestJob<int, int> job([](const int& key, std::stop_token) {
    if (key < 0) throw std::runtime_error("negative");
    return key;
  });
  job.request(-1);
  job.wait();
  EXPECT_THROW(static_cast<void>(job.take()), std::runtime_error);
  EXPECT_EQ(job.take(), std::nullopt);
  job.request(3);
  job.wait();
  EXPECT_EQ(job.take(), 3);
}

}  // namespace
}  // namespace skydrop::core
