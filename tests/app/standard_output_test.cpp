#include "app/console/standard_output.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <string>

#include "support/refusal.h"

namespace skydrop::app {
namespace {

// Standard output leads to a descriptor for a while.
class Redirected {
 public:
  explicit Redirected(int to) : saved_(::dup(STDOUT_FILENO)) {
    std::fflush(stdout);
    ::dup2(to, STDOUT_FILENO);
  }
  ~Redirected() {
    std::fflush(stdout);
    std::clearerr(stdout);
    ::dup2(saved_, STDOUT_FILENO);
    ::close(saved_);
  }

 private:
  int saved_;
};

TEST(StandardOutput, linesAreThereAsTheyCome) {
  // Also in a pipe, which the C library fills by blocks.
  int ends[2];
  ASSERT_EQ(::pipe2(ends, O_CLOEXEC | O_NONBLOCK), 0);
  char text[16] = "";
  ssize_t count = 0;
  {
    const Redirected output(ends[1]);
    print("%s %d\n", "frame", 7);
    count = ::read(ends[0], text, sizeof text);
  }
  EXPECT_EQ(std::string(text, static_cast<std::size_t>(std::max<ssize_t>(count, 0))), "frame 7\n");
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST(StandardOutput, aFullDiskIsAnErrorOfTheLineThatIsLost) {
  const int full = ::open("/dev/full", O_WRONLY | O_CLOEXEC);
  std::string refusal;
  {
    const Redirected output(full);
    refusal = test::refusalOf<core::DataError>([] { print("lost\n"); });
  }
  ::close(full);
  EXPECT_EQ(refusal, "standard output: cannot write: No space left on device");
}

TEST(StandardOutput, aClosedPipeIsToldApart) {
  int ends[2];
  ASSERT_EQ(::pipe2(ends, O_CLOEXEC), 0);
  ::close(ends[0]);
  auto* before = std::signal(SIGPIPE, SIG_IGN);
  std::string refusal;
  {
    const Redirected output(ends[1]);
    refusal = test::refusalOf<core::ClosedPipe>([] { print("unread\n"); });
  }
  std::signal(SIGPIPE, before);
  ::close(ends[1]);
  EXPECT_NE(refusal, "");
}

}  // namespace
}  // namespace skydrop::app
