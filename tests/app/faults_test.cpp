#include "app/window/faults.h"

#include <gtest/gtest.h>

namespace skydrop::app {
namespace {

TEST(Faults, aFaultIsNewsOnceAndStandsUntilItsPartIsSound) {
  Faults faults;
  EXPECT_EQ(faults.shown(), "");
  EXPECT_TRUE(faults.set("scene", "a.json: line 1: no"));
  EXPECT_FALSE(faults.set("scene", "a.json: line 1: no"));
  EXPECT_TRUE(faults.set("shaders", "sky.frag: line 2: no"));
  EXPECT_EQ(faults.shown(), "sky.frag: line 2: no") << "the latest";
  EXPECT_TRUE(faults.set("scene", "a.json: line 3: no"));
  EXPECT_EQ(faults.shown(), "a.json: line 3: no");
  faults.clear("scene");
  EXPECT_EQ(faults.shown(), "sky.frag: line 2: no") << "what still stands";
  faults.clear("shaders");
  faults.clear("shaders");
  EXPECT_EQ(faults.shown(), "");
  EXPECT_TRUE(faults.set("scene", "a.json: line 1: no")) << "news again";
}

}  // namespace
}  // namespace skydrop::app
