#include <gtest/gtest.h>
#include <imgui.h>

#include <cmath>
#include <limits>

#include "skydrop/ui/imgui_context.h"
#include "skydrop/ui/loading_picture.h"

namespace skydrop::ui {
namespace {

TEST(InterfaceScale, textGrowsByTheFactorUntilItWouldNotFit) {
  EXPECT_EQ(Interface::linePixels(1920, 1080), 27);
  EXPECT_EQ(Interface::linePixels(1920, 1080, {2, 1}), 54);
  EXPECT_EQ(Interface::linePixels(1920, 1080, {.5, 1}), 13);
  EXPECT_EQ(Interface::linePixels(1920, 1080, {3, 1}), 60) << "18 lines must fit";
  EXPECT_EQ(Interface::linePixels(640, 360, {.5, 1}), 10) << "below that an 8 and a 0 look the same";
}

TEST(InterfaceScale, smallWindowsOnDenseScreensHaveLargerText) {
  // A fortieth of a large window is large on every screen; what has a least size has it in the screen's
  // points.
  EXPECT_EQ(Interface::linePixels(640, 360, {1, 1}), 10);
  EXPECT_EQ(Interface::linePixels(640, 360, {1, 2}), 20);
  EXPECT_EQ(Interface::linePixels(3840, 2160, {1, 2}), 54);
}

TEST(LoadingPicture, itFillsTheWindowAndItsBarIsFiniteWhateverTheShare) {
  for (const double share : {-1.0, 0.0, 0.4, 7.0, std::numeric_limits<double>::quiet_NaN()}) {
    Interface interface(320, 180);
    static_cast<void>(interface.beginFrame(320, 180, 0));
    drawLoadingPicture(interface, {"Making the land: 12 of 40", share});
    const ImDrawData& data = *interface.endFrame();
    ASSERT_GT(data.TotalVtxCount, 0);
    float right = 0, bottom = 0;
    for (int i = 0; i < data.CmdListsCount; ++i) {
      for (const ImDrawVert& vertex : data.CmdLists[i]->VtxBuffer) {
        ASSERT_TRUE(std::isfinite(vertex.pos.x) && std::isfinite(vertex.pos.y)) << share;
        right = std::max(right, vertex.pos.x);
        bottom = std::max(bottom, vertex.pos.y);
      }
    }
    EXPECT_EQ(right, 320);
    EXPECT_EQ(bottom, 180);
  }
}

}  // namespace
}  // namespace skydrop::ui
