#include "app/settings/xdg_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <string>

namespace skydrop::app {
namespace {

// Leaves the environment as it was.
class XdgFolder : public testing::Test {
 protected:
  XdgFolder() {
    if (const char* home = std::getenv("HOME")) home_ = home;
  }
  ~XdgFolder() override {
    unsetenv(kVariable);
    if (home_) setenv("HOME", home_->c_str(), 1);
  }

  static constexpr const char* kVariable = "SKYDROP_TEST_XDG_HOME";

 private:
  std::optional<std::string> home_;
};

TEST_F(XdgFolder, variableComesBeforeHome) {
  // An absolute path in the variable is taken; one that is not, or none, leaves the folder below $HOME.
  setenv("HOME", "/home/pilot", 1);
  setenv(kVariable, "/var/cache", 1);
  EXPECT_EQ(xdgFolder(kVariable, ".cache"), "/var/cache/skydrop");
  for (const char* unusable : {"", "cache"}) {
    setenv(kVariable, unusable, 1);
    EXPECT_EQ(xdgFolder(kVariable, ".cache"), "/home/pilot/.cache/skydrop") << unusable;
  }
  unsetenv(kVariable);
  EXPECT_EQ(xdgFolder(kVariable, ".cache"), "/home/pilot/.cache/skydrop");
}

TEST_F(XdgFolder, withoutHomeThereIsNone) {
  // Neither variable: no folder, so nothing is kept.
  unsetenv(kVariable);
  unsetenv("HOME");
  EXPECT_TRUE(xdgFolder(kVariable, ".cache").empty());
}

}  // namespace
}  // namespace skydrop::app
