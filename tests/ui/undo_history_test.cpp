#include "skydrop/ui/undo_history.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skydrop::ui {
namespace {

MATCHER_P2(isValue, path, value, "") { return arg.path == path && arg.value == value; }

TEST(UndoHistory, aStepGoesBackToWhereItBeganAndForwardToWhereItEnded) {
  // Whatever lay between, and for every path of the step.
  UndoHistory history;
  history.note("a", 1, 2);
  history.note("b", 10, 11);
  history.note("a", 2, 3);
  history.closeStep();
  EXPECT_EQ(history.undoSteps(), 1u);
  EXPECT_THAT(history.undo(), ::testing::ElementsAre(isValue("a", 1), isValue("b", 10)));
  EXPECT_EQ(history.undoSteps(), 0u);
  EXPECT_THAT(history.redo(), ::testing::ElementsAre(isValue("a", 3), isValue("b", 11)));
  EXPECT_TRUE(history.redo().empty());
}

TEST(UndoHistory, stepsAreTakenInTheirOrder) {
  UndoHistory history;
  for (int i = 0; i < 3; ++i) {
    history.note("a", i, i + 1);
    history.closeStep();
  }
  EXPECT_THAT(history.undo(), ::testing::ElementsAre(isValue("a", 2)));
  EXPECT_THAT(history.undo(), ::testing::ElementsAre(isValue("a", 1)));
  EXPECT_THAT(history.redo(), ::testing::ElementsAre(isValue("a", 2)));
  EXPECT_THAT(history.undo(), ::testing::ElementsAre(isValue("a", 1)));
  EXPECT_THAT(history.undo(), ::testing::ElementsAre(isValue("a", 0)));
  EXPECT_TRUE(history.undo().empty());
  EXPECT_EQ(history.redoSteps(), 3u);
}

TEST(UndoHistory, aNewChangeForgetsWhatWasUndone) {
  UndoHistory history;
  history.note("a", 1, 2);
  history.undo();
  history.note("b", 1, 2);
  EXPECT_TRUE(history.redo().empty());
  EXPECT_THAT(history.undo(), ::testing::ElementsAre(isValue("b", 1)));
}

TEST(UndoHistory, aStepThatEndsWhereItBeganIsNone) {
  UndoHistory history;
  history.note("a", 1, 2);
  history.note("a", 2, 1);
  history.closeStep();
  EXPECT_EQ(history.undoSteps(), 0u);
}

TEST(UndoHistory, aDroppedStepCanNeitherBeUndoneNorDoneAgain) {
  UndoHistory history;
  history.note("a", 1, 2);
  history.closeStep();
  history.note("b", 5, 6);
  EXPECT_THAT(history.dropLastStep(), ::testing::ElementsAre(isValue("b", 5)));
  EXPECT_TRUE(history.redo().empty());
  EXPECT_EQ(history.undoSteps(), 1u);
  EXPECT_TRUE(UndoHistory().dropLastStep().empty());
}

TEST(UndoHistory, whatCouldNotBeCarriedOutIsTakenBack) {
  // The last change, undo or redo, and that alone.
  UndoHistory history;
  history.takeBack();
  history.note("a", 1, 2);
  history.closeStep();
  history.note("b", 5, 6);
  history.closeStep();
  history.takeBack();
  history.takeBack();
  EXPECT_EQ(history.undoSteps(), 1u) << "b";
  history.undo();
  history.takeBack();
  EXPECT_EQ(history.undoSteps(), 1u) << "the undoing";
  EXPECT_EQ(history.redoSteps(), 0u);
  history.undo();
  history.redo();
  history.takeBack();
  EXPECT_EQ(history.undoSteps(), 0u) << "the redoing";
  EXPECT_EQ(history.redoSteps(), 1u);
}

TEST(UndoHistory, theOldestStepsAreForgotten) {
  UndoHistory history(3);
  for (int i = 0; i < 10; ++i) {
    history.note("a", i, i + 1);
    history.closeStep();
  }
  EXPECT_EQ(history.undoSteps(), 3u);
  history.undo();
  history.undo();
  EXPECT_THAT(history.undo(), ::testing::ElementsAre(isValue("a", 7)));
}

}  // namespace
}  // namespace skydrop::ui
