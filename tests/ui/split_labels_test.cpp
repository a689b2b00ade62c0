#include "skydrop/ui/split_labels.h"

#include <gtest/gtest.h>

#include <optional>

#include "ui/interface_driver.h"

namespace skydrop::ui {
namespace {

class SplitLabelsTest : public testing::Test {
 protected:
  SplitLabels labels_{"clouds: low", "clouds: reference", "RMSE 0.1", 0.5, {}};
  std::optional<double> moved_;
  test::InterfaceDriver driver_{640, 360, [this](const Interface& context) {
                                  if (const auto dragged = drawSplitLabels(context, labels_))
                                    labels_.divider = *(moved_ = dragged);
                                }};
};

TEST_F(SplitLabelsTest, theDividerFollowsTheMouseThatHoldsIt) {
  driver_.move(320, 100);
  driver_.button(320, 100, true);
  driver_.move(250, 100);
  driver_.move(160, 120);
  EXPECT_DOUBLE_EQ(labels_.divider, 0.25);
  driver_.move(-50, 120);  // no further than the window
  EXPECT_DOUBLE_EQ(labels_.divider, 0);
  driver_.move(480, 120);
  driver_.button(480, 120, false);
  EXPECT_DOUBLE_EQ(labels_.divider, 0.75);
  moved_.reset();
  driver_.move(100, 100);
  EXPECT_FALSE(moved_) << "it was let go";
}

TEST_F(SplitLabelsTest, aClickBesideItMovesNothing) {
  driver_.move(200, 100);
  driver_.button(200, 100, true);
  driver_.move(320, 100);
  driver_.move(400, 100);
  driver_.button(400, 100, false);
  EXPECT_FALSE(moved_);
}

}  // namespace
}  // namespace skydrop::ui
