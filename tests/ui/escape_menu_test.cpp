#include <gtest/gtest.h>

#include <utility>

#include "app/input/input_code.h"
#include "skydrop/ui/menu.h"
#include "ui/interface_driver.h"

namespace skydrop::ui {
namespace {

class EscapeMenuTest : public ::testing::Test {
 protected:
  EscapeAction taken() { return std::exchange(action, EscapeAction::none); }

  EscapeMenu menu;
  EscapeAction action = EscapeAction::none;
  test::InterfaceDriver driver{1280, 720, [this](const Interface& context) {
                                 const EscapeAction now = menu.draw(context);
                                 if (now != EscapeAction::none) action = now;
                               }};
};

TEST_F(EscapeMenuTest, arrowsSelectAndEnterChooses) {
  EXPECT_EQ(taken(), EscapeAction::none);
  driver.tap(app::key::kEnter);
  EXPECT_EQ(taken(), EscapeAction::resume) << "the first entry is selected at first";
  driver.tap(app::key::kDown);
  driver.tap(app::key::kEnter);
  EXPECT_EQ(taken(), EscapeAction::help);
  driver.tap(app::key::kDown);
  driver.tap(app::key::kEnter);
  EXPECT_EQ(taken(), EscapeAction::laboratory);
  driver.tap(app::key::kDown);
  driver.tap(app::key::kKeypadEnter);
  EXPECT_EQ(taken(), EscapeAction::quit);
  driver.tap(app::key::kDown);
  EXPECT_EQ(menu.selected(), 0) << "wraps around";
  driver.tap(app::key::kUp);
  driver.tap(app::key::kEnter);
  EXPECT_EQ(taken(), EscapeAction::quit);
  menu.reset();
  EXPECT_EQ(menu.selected(), 0);
}

TEST_F(EscapeMenuTest, theMouseChooses) {
  constexpr EscapeAction kActions[] = {EscapeAction::resume, EscapeAction::help, EscapeAction::laboratory,
                                       EscapeAction::quit};
  ASSERT_EQ(menu.places().size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    driver.click(ScreenRect(menu.places()[i]));
    EXPECT_EQ(taken(), kActions[i]);
  }
}

TEST_F(EscapeMenuTest, aRestingMouseDoesNotHoldTheKeysBack) {
  const ScreenRect first = menu.places()[0];
  driver.move((first.left + first.right) / 2, (first.top + first.bottom) / 2);
  driver.tap(app::key::kDown);
  EXPECT_EQ(menu.selected(), 1);
}

}  // namespace
}  // namespace skydrop::ui
