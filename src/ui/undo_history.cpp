#include "skydrop/ui/undo_history.h"

#include <algorithm>
#include <utility>

namespace skydrop::ui {

void UndoHistory::note(const std::string& path, double before, double after) {
  undone_.clear();
  last_ = Call::noted;
  if (!open_) {
    done_.emplace_back();
    open_ = true;
    if (done_.size() > mostSteps_) done_.pop_front();
  }
  Step& step = done_.back();
  const auto known = std::ranges::find(step, path, &Change::path);
  if (known == step.end()) {
    step.push_back({path, before, after});
  } else {
    known->after = after;
  }
}

void UndoHistory::closeStep() {
  if (!std::exchange(open_, false)) return;
  Step& step = done_.back();
  std::erase_if(step, [](const Change& change) { return change.before == change.after; });
  if (step.empty()) done_.pop_back();
}

void UndoHistory::takeBack() {
  switch (last_) {
    case Call::none:
      break;
    case Call::noted:
      static_cast<void>(dropLastStep());
      break;
    case Call::undone:
      static_cast<void>(redo());
      break;
    case Call::redone:
      static_cast<void>(undo());
      break;
  }
  last_ = Call::none;
}

std::vector<SettingValue> UndoHistory::dropLastStep() {
  std::vector<SettingValue> values = undo();
  if (!values.empty()) undone_.pop_back();
  last_ = Call::none;
  return values;
}

std::vector<SettingValue> UndoHistory::undo() {
  closeStep();
  if (done_.empty()) return {};
  std::vector<SettingValue> values;
  for (const Change& change : done_.back()) values.push_back({change.path, change.before});
  undone_.push_back(std::move(done_.back()));
  done_.pop_back();
  last_ = Call::undone;
  return values;
}

std::vector<SettingValue> UndoHistory::redo() {
  closeStep();
  if (undone_.empty()) return {};
  std::vector<SettingValue> values;
  for (const Change& change : undone_.back()) values.push_back({change.path, change.after});
  done_.push_back(std::move(undone_.back()));
  undone_.pop_back();
  last_ = Call::redone;
  return values;
}

}  // namespace skydrop::ui
