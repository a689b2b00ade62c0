// A data race needs two threads, so the thread sanitizer runs the tests that start one: threaded_tests.txt
// names them. Here each test is held to that list by counting the threads that the process starts. Linked
// into the CPU suites, but not under sanitizers, which take pthread_create for themselves.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <pthread.h>

#include <atomic>
#include <fstream>
#include <set>
#include <string>

#include "support/paths.h"

namespace {

std::atomic<int> startedThreads{0};

std::set<std::string> threadedTests() {
  std::ifstream file(skydrop::test::sourceDir() + "/tests/threads/threaded_tests.txt");
  std::set<std::string> names;
  for (std::string line; std::getline(file, line);) {
    if (!line.empty() && line.front() != '#') names.insert(line);
  }
  return names;
}

class ThreadWatch : public testing::EmptyTestEventListener {
 public:
  void OnTestEnd(const testing::TestInfo& test) override {
    if (test.result()->Skipped()) return;
    const std::string name = std::string(test.test_suite_name()) + "." + test.name();
    const bool isListed = listed_.contains(name);
    if (startedThreads.exchange(0) > 0) {
      EXPECT_TRUE(isListed) << "starts a thread: add the line " << name
                            << " to tests/threads/threaded_tests.txt";
    } else if (testing::UnitTest::GetInstance()->test_to_run_count() ==
               1) {  // no earlier test has started them
      EXPECT_FALSE(isListed) << "starts no thread: take " << name
                             << " out of tests/threads/threaded_tests.txt";
    }
  }

 private:
  std::set<std::string> listed_ = threadedTests();
};

// Before main(), which GoogleTest has.
[[maybe_unused]] const bool kIsWatching = [] {
  testing::UnitTest::GetInstance()->listeners().Append(new ThreadWatch);
  return true;
}();

}  // namespace

// Stands before that of the C library: std::thread and all others come through here.
extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*),
                              void* argument) noexcept {
  static const auto create = reinterpret_cast<decltype(&pthread_create)>(dlsym(RTLD_NEXT, "pthread_create"));
  ++startedThreads;
  return create(thread, attributes, run, argument);
}
