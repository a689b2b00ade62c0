// Chooses a rung of a ladder so that frames stay within a budget of time. A deterministic function of the
// ladder, the budget and the frames that it is told of: no clock, no settings, no OpenGL. One thread.
//
// What a frame takes is estimated by medians, so that single slow frames change nothing. Another rung is
// predicted to take as many times the present one as the two took when they were measured, on top of the part
// of the frame that no rung changes. Down it goes as soon as the budget is exceeded; up only where the
// prediction and a margin fit for a while, and, after a rung that did not keep what was predicted, after a
// time that doubles with every such try: so in a load that stays, however noisy, changes die out.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "skydrop/accuracy/budget_ladder.h"

namespace skydrop::accuracy {

struct BudgetRules {
  std::size_t window = 31;       // frames of the median that is shown and by which it goes up; odd
  std::size_t shortWindow = 15;  // of the one by which it goes down; at most `window`
  std::size_t fewestFrames = 8;  // after a change, before it goes on down
  std::size_t settleFrames = 2;  // after a change, which are not counted: targets are made anew
  double overShare = 1.1;        // of the budget: the short median may not exceed it
  double upMargin = 0.15;        // share that a prediction must be below the budget to go up
  double marginPerRung = 0.03;   // more of it for every further rung in one go
  double upSeconds = 2;          // that a prediction must fit, and all of the window
  double provenSeconds = 30;     // of a rung that was gone up to: leaving it later is no failure
  double firstBackOffSeconds = 10, mostBackOffSeconds = 1200;
};

// What one frame took, ms. `governedMs` is the part that depends on the rung, the rest does not.
struct BudgetFrame {
  double ms = 0, governedMs = 0;
};

class BudgetController {
 public:
  static constexpr double kLeastMs = 1e-3, kMostMs = 1e5;  // other times of frames are not believed

  // `ladder` is not empty; by growing time (budgetLadder). `budgetMs` > 0. Begins with the most exact rung
  // that fits by the ladder's own times.
  BudgetController(std::vector<BudgetRung> ladder, double budgetMs, const BudgetRules& rules = {});

  // Of the frame that was drawn last, with the present rung. True: another rung is chosen from now on. Frames
  // whose times are not finite, not above kLeastMs or above kMostMs are ignored; a governed part that is not
  // within the frame counts as all of it.
  bool note(const BudgetFrame& frame);

  // What was measured says nothing of the frames to come: another scene, another size. The rung stays.
  void forgetFrames();

  const std::vector<BudgetRung>& ladder() const { return ladder_; }
  std::size_t rung() const { return rung_; }  // always below ladder().size()
  const BudgetRung& chosen() const { return ladder_[rung_]; }
  double budgetMs() const { return budgetMs_; }
  double medianMs() const;  // of the newest frames of this rung; 0 while there is none
  double predictedMs(std::size_t rung) const;
  std::int64_t changes() const { return changes_; }
  // False when the cheapest rung is chosen and exceeds the budget: nothing is left to turn.
  bool holds() const;

  // "32.4 of 33 ms: scale 1, clouds medium; the next better, scale 1, clouds high, would need 41 ms"
  std::string reason() const;

 private:
  struct Trial {  // of a rung, since it was gone up to and did not keep what was predicted
    int failures = 0;
    double blockedUntil = 0;  // s of frames
    double excess = 1;        // of what it took over what was predicted; > 0
  };
  double median(std::vector<double> of, std::size_t newest) const;
  bool exceeds() const;
  std::size_t lower() const;
  std::size_t higher() const;
  bool isOnTrial() const;  // gone up to, and not proven yet
  void noteFailure();
  void moveTo(std::size_t rung);

  std::vector<BudgetRung> ladder_;
  double budgetMs_;
  BudgetRules rules_;
  std::size_t rung_ = 0;
  std::vector<double> frameMs_, restMs_;  // the newest of this rung, at most `window`
  std::size_t settling_ = 0;
  double seconds_ = 0;         // of all frames that were believed
  double movedAt_ = 0;         // when the present rung was chosen, in these seconds
  double fitsSince_ = -1;      // since when a better rung fits; below 0: none does
  bool wentUp_ = false;        // by the last change
  std::size_t cameFrom_ = 0;   // before it
  double expectedMs_ = 0;      // of the present rung, when it was gone up to
  std::vector<Trial> trials_;  // one a rung
  std::int64_t changes_ = 0;
};

}  // namespace skydrop::accuracy
