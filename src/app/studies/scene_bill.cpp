#include "app/studies/scene_bill.h"

#include <algorithm>

#include "app/measure/bill.h"
#include "skydrop/core/quantile.h"

namespace skydrop::app {
namespace {

constexpr int kFramesOfARound = 5;
constexpr double kMostMsOfARound = 1500;  // of each game; slow frames are fewer

double median(const std::vector<double>& values) { return core::quantileOf(values, 0.5); }

}  // namespace

double SceneBill::paidShare() const {
  std::vector<double> shares;
  for (std::size_t i = 0; i < frames.size(); ++i) shares.push_back(paidMs(frames[i]) / frameMs[i]);
  return median(shares);
}

SceneBill billOf(MeasuredGame& game, int frames) {
  SceneBill bill;
  game.setMeasuring(true);
  game.frame();  // the first has queries to make
  for (int i = 0; i < frames; ++i) {
    bill.frameMs.push_back(game.frame());
    bill.frames.push_back(game.statistics());
  }
  game.setMeasuring(false);
  return bill;
}

FrameComparison compareFrames(MeasuredGame& base, MeasuredGame& other, int rounds) {
  const double slowest = std::max(base.frame(), other.frame());
  const int frames = std::clamp(static_cast<int>(kMostMsOfARound / slowest), 1, kFramesOfARound);
  std::vector<double> baseMs, otherMs, more, ratios;
  for (int round = 0; round < rounds; ++round) {
    std::vector<double> ofBase, ofOther;
    for (int i = 0; i < frames; ++i) {
      const bool baseFirst = (round + i) % 2 == 0;
      if (baseFirst) ofBase.push_back(base.frame());
      ofOther.push_back(other.frame());
      if (!baseFirst) ofBase.push_back(base.frame());
    }
    baseMs.push_back(median(ofBase)), otherMs.push_back(median(ofOther));
    more.push_back(otherMs.back() - baseMs.back());
    ratios.push_back(otherMs.back() / baseMs.back());
  }
  const auto [leastMore, mostMore] = std::ranges::minmax(more);
  const auto [leastRatio, mostRatio] = std::ranges::minmax(ratios);
  return {median(baseMs), median(otherMs), median(more), leastMore,
          mostMore,       median(ratios),  leastRatio,   mostRatio};
}

}  // namespace skydrop::app
