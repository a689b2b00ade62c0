// What was changed in the menu, step by step, and the way back. Plain data: it names paths and values and
// sets nothing itself. A step is what the user means by one: a whole drag of a slider, a reset of everything,
// a preset.
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <vector>

namespace skydrop::ui {

struct SettingValue {
  std::string path;
  double value;
};

class UndoHistory {
 public:
  // Steps that are kept; the oldest are forgotten first. An hour of tuning fits.
  static constexpr std::size_t kDefaultSteps = 500;

  explicit UndoHistory(std::size_t mostSteps = kDefaultSteps) : mostSteps_(mostSteps) {}

  // Notes a change in the step that is open, or opens one. The same path again in one step: only where it
  // started and where it ended count. Forgets what could be done again.
  void note(const std::string& path, double before, double after);

  // Ends the open step. One that changed nothing in the end vanishes.
  void closeStep();

  // Takes the last call of note(), undo() or redo() back: what it was for could not be done. Sets nothing.
  void takeBack();

  // Forgets the last step, open or not, as if it had never been; returns the values that were before it.
  std::vector<SettingValue> dropLastStep();

  // The values to set, in the order in which to set them; empty where there is no step. Ends the open step
  // first.
  std::vector<SettingValue> undo();
  std::vector<SettingValue> redo();

  std::size_t undoSteps() const { return done_.size(); }
  std::size_t redoSteps() const { return undone_.size(); }

 private:
  struct Change {
    std::string path;
    double before, after;
  };
  using Step = std::vector<Change>;

  std::size_t mostSteps_;
  std::deque<Step> done_, undone_;  // the next one to take at the back
  bool open_ = false;               // the last of done_ still grows
  enum class Call { none, noted, undone, redone };
  Call last_ = Call::none;  // that takeBack() would take back
};

}  // namespace skydrop::ui
