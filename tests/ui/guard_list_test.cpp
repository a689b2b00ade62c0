#include "skydrop/ui/guard_list.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include "ui/interface_driver.h"

namespace skydrop::ui {
namespace {

using core::FiredGuard, core::Guard;

TEST(GuardList, whatFiredInThisFrameIsToldFromWhatFiredBefore) {
  const std::vector<FiredGuard> fired = {{Guard::stiffStep, 3, 412}, {Guard::jobRetried, 0, 1}};
  const std::vector<GuardLine> lines = guardLines(fired);
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[2].text, "stiffStep 3, 412 in all");
  EXPECT_TRUE(lines[2].isNow);
  EXPECT_EQ(lines[3].text, "jobRetried 0, 1 in all");
  EXPECT_FALSE(lines[3].isNow);
  EXPECT_EQ(guardLines({}).back().text, "none on the processor");
}

TEST(GuardList, itIsDrawnWithinTheWindow) {
  // All that is drawn lies in a window of any size that is played in, and a list is more than no list.
  const std::vector<FiredGuard> fired = {{Guard::stiffStep, 3, 412}, {Guard::jobRetried, 0, 1}};
  bool isShown = false;
  test::InterfaceDriver driver(640, 360, [&](const Interface& context) {
    if (isShown) drawGuardList(context, guardLines(fired));
  });
  driver.frames(2);
  const int without = ImGui::GetDrawData()->TotalVtxCount;
  isShown = true;
  driver.frames(2);
  EXPECT_GT(ImGui::GetDrawData()->TotalVtxCount, without + 200);
  const ImDrawData& data = *ImGui::GetDrawData();
  for (int i = 0; i < data.CmdListsCount; ++i) {
    for (const ImDrawVert& vertex : data.CmdLists[i]->VtxBuffer) {
      EXPECT_TRUE(vertex.pos.x >= -1 && vertex.pos.x <= 641 && vertex.pos.y >= -1 && vertex.pos.y <= 361);
    }
  }
}

}  // namespace
}  // namespace skydrop::ui
