#include "app/window/screen_fit.h"

#include <gtest/gtest.h>

#include <vector>

namespace skydrop::app {
namespace {

using render::gl::WindowFrame;
using render::gl::WindowRect;

void expectRect(const WindowRect& rect, const WindowRect& expected) {
  EXPECT_EQ(rect.left, expected.left);
  EXPECT_EQ(rect.top, expected.top);
  EXPECT_EQ(rect.width, expected.width);
  EXPECT_EQ(rect.height, expected.height);
}

TEST(ScreenFit, aWindowThatFitsStaysAsItIs) {
  expectRect(heldToScreen({100, 50, 640, 360}, {}, std::vector<WindowRect>{{0, 0, 1280, 720}}),
             {100, 50, 640, 360});
}

TEST(ScreenFit, oneLargerThanItsScreenIsMadeAsLargeAsTheScreen) {
  // Frame included: its title stays in reach.
  const std::vector<WindowRect> screens = {{0, 0, 1280, 720}};
  expectRect(heldToScreen({0, 0, 3840, 2160}, {}, screens), {0, 0, 1280, 720});
  expectRect(heldToScreen({0, 0, 3840, 2160}, {4, 30, 4, 4}, screens), {4, 30, 1272, 686});
}

TEST(ScreenFit, oneBesideItsScreenIsMovedOntoIt) {
  const std::vector<WindowRect> screens = {{0, 0, 1280, 720}};
  expectRect(heldToScreen({1200, 700, 640, 360}, {}, screens), {640, 360, 640, 360});
  expectRect(heldToScreen({-5000, -5000, 640, 360}, {}, screens), {0, 0, 640, 360});
  expectRect(heldToScreen({100000, 100000, 640, 360}, {}, screens), {640, 360, 640, 360});
}

TEST(ScreenFit, theScreenThatHoldsMostOfItCounts) {
  // The second screen is larger and lies left of the first, at negative coordinates.
  const std::vector<WindowRect> screens = {{0, 0, 1280, 720}, {-2560, 0, 2560, 1440}};
  expectRect(heldToScreen({-2000, 100, 1800, 1000}, {}, screens), {-2000, 100, 1800, 1000});
  expectRect(heldToScreen({-100, 100, 1800, 1000}, {}, screens), {0, 0, 1280, 720});
}

TEST(ScreenFit, withoutScreensItIsAsWanted) {
  expectRect(heldToScreen({-100, 5, 3840, 2160}, {}, {}), {-100, 5, 3840, 2160});
}

}  // namespace
}  // namespace skydrop::app
