#include "app/studies/timed_frame.h"

#include <cmath>
#include <vector>

#include "app/measure/stopwatch.h"
#include "skydrop/core/quantile.h"

namespace skydrop::app {

TimedFrame drawTimed(SceneRenderer& sceneRenderer, const game::Snapshot& snapshot, Size size, int times) {
  sceneRenderer.draw(snapshot, size, Streaming::settled);
  std::vector<double> all;
  for (int i = 0; i < times; ++i) {
    sceneRenderer.renderer().finish();
    const Stopwatch watch;
    sceneRenderer.draw(snapshot, size, Streaming::asItComes);
    sceneRenderer.renderer().finish();
    all.push_back(watch.ms());
  }
  return {sceneRenderer.renderer().readBack(), core::quantileOf(all, 0.5)};
}

std::string clockOfTimedFrames(int times) {
  return "wall clock between glFinish calls, median of " + std::to_string(times);
}

double rootMeanSquare(const core::Image& a, const core::Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    if (i % 4 == 3) continue;
    const double difference = static_cast<double>(a.rgba[i]) - b.rgba[i];
    sum += difference * difference;
  }
  return std::sqrt(sum / (static_cast<double>(a.rgba.size()) * 0.75));
}

}  // namespace skydrop::app
