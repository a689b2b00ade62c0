#include "app/console/progress.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace skydrop::app {
namespace {

class ProgressTest : public testing::Test {
 protected:
  // What was written so far.
  std::string written() {
    std::rewind(file_.get());
    std::string text(1000, '\0');
    text.resize(std::fread(text.data(), 1, text.size(), file_.get()));
    return text;
  }
  // A loop that asks 128 times a second: a period that doubles add up exactly.
  void work(Progress& progress, int turns) {
    for (int i = 0; i < turns; ++i, now_ += 1.0 / 128) {
      if (progress.isDue()) progress.show(std::to_string(++shown_));
    }
  }

  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_{std::tmpfile(), std::fclose};
  double now_ = 50;
  int shown_ = 0;
};

TEST_F(ProgressTest, aTerminalShowsOneLineThatIsGoneAtTheEnd) {
  {
    Progress progress("simulate", Progress::Style::overwritten, file_.get(), [&] { return now_; });
    work(progress, 122);
    EXPECT_EQ(shown_, 10) << "ten times a second";
  }
  const std::string text = written();
  EXPECT_TRUE(text.starts_with("\rsimulate: 1\x1b[K\rsimulate: 2\x1b[K")) << text;
  EXPECT_TRUE(text.ends_with("\rsimulate: 10\x1b[K\r\x1b[K")) << text;
  EXPECT_EQ(text.find('\n'), std::string::npos);
}

TEST_F(ProgressTest, elsewhereItIsALineASecond) {
  {
    Progress progress("simulate", Progress::Style::lines, file_.get(), [&] { return now_; });
    work(progress, 320);
  }
  EXPECT_EQ(written(), "simulate: 1\nsimulate: 2\nsimulate: 3\n");
}

TEST_F(ProgressTest, nothingIsWrittenWhereItWasNotAskedFor) {
  Progress progress("simulate", Progress::Style::none, file_.get(), [&] { return now_; });
  work(progress, 320);
  progress.show("in any case");
  EXPECT_EQ(shown_, 0);
  EXPECT_EQ(written(), "");
}

}  // namespace
}  // namespace skydrop::app
