// The panel of costs in the real window.
#include <gtest/gtest.h>

#include "window/flown_game.h"

namespace skydrop::test {
namespace {

using nlohmann::json;

TEST(CostPanelWindow, comesAndGoesByItsKeyAndLeavesNothing) {
  // F2 shows a row for each pass and part that took time; F2 again, and there is nothing of it.
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown({"--set", "quality=low"});
  const auto rows = [](const json& s) { return s.at("window").at("costRows").get<int>(); };
  EXPECT_EQ(rows(flown.statistics()), -1);
  const json before = flown.statistics().at("gl");
  flown.press("F2");
  ASSERT_TRUE(flown.waitFor([&](const json& s) { return rows(s) >= 6; })) << flown.statistics().dump();
  flown.press("F2");
  ASSERT_TRUE(flown.waitFor([&](const json& s) { return rows(s) == -1; }));
  const json after = flown.statistics().at("gl");
  for (const char* kind : {"textures", "programs", "framebuffers"})
    EXPECT_EQ(after.at(kind), before.at(kind)) << kind;
}

}  // namespace
}  // namespace skydrop::test
