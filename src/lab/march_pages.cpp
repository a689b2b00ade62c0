// Where a ray meets a surface: constant steps, halving, sphere tracing.
#include <algorithm>
#include <cstdio>

#include "lab/chapters.h"
#include "skydrop/lab/march_measure.h"

namespace skydrop::lab {
namespace {

constexpr double kFirstStride = 0.8;
constexpr int kRows = 7;

// What a method's error is set by: its stride, or its tolerance.
MarchKnobs refined(const MarchKnobs& knobs, int method, int row) {
  MarchKnobs refined = knobs;
  const double share = std::pow(0.25, row);
  if (method == core::shared::f64::kConstantStep)
    refined.stride = kFirstStride * share;
  else
    refined.tolerance = 0.1 * share;
  refined.mostSteps = 1000000;
  return refined;
}

template <int method>
Figures measure(const MarchKnobs& knobs) {
  Figures figures;
  figures.columns = {method == core::shared::f64::kConstantStep ? "stride" : "tolerance",
                     "steps a ray",
                     "mean error",
                     "largest error",
                     "mean error (float)",
                     "missed or false"};
  for (int row = 0; row < kRows; ++row) {
    const MarchKnobs finer = refined(knobs, method, row);
    const MarchError error = marchError(finer, method), inFloat = marchErrorInFloat(finer, method);
    figures.rows.push_back({method == core::shared::f64::kConstantStep ? finer.stride : finer.tolerance,
                            error.stepsPerRay, error.meanError, error.largestError, inFloat.meanError,
                            error.wrongShare});
  }
  const MarchError now = marchError(knobs, method);
  char text[200];
  std::snprintf(text, sizeof text,
                "%.1f steps a ray, mean error %.2g and largest %.2g units, %.2g %% of rays wrong",
                now.stepsPerRay, now.meanError, now.largestError, 100 * now.wrongShare);
  figures.summary = text;
  return figures;
}

Page march(std::string_view name, std::string_view title, std::string_view variant, std::string_view text) {
  return {.name = name, .title = title, .chapter = "march", .variant = variant, .text = text};
}

}  // namespace

std::vector<Page> marchPages() {
  using namespace core::shared::f64;
  return {
      withKnobs<MarchKnobs>(
          march("constant-step", "Constant step", "MARCH_METHOD 0",
                "A ray goes on by equal steps until it is inside. The error is up to a whole step, seen as "
                "rings, and "
                "what is thinner than a step can be missed. Left the picture, top right how many steps each "
                "ray took "
                "(blue none, red all that were allowed), below a cut with the places of one ray."),
          {}, measure<kConstantStep>),
      withKnobs<MarchKnobs>(march("halving", "Halving with reversed direction", "MARCH_METHOD 1",
                                  "Inside, the step is halved and the ray goes back; outside it goes on. The "
                                  "error is the last step, "
                                  "however long the first was, but places are visited again and again, and "
                                  "thin bodies are missed as "
                                  "before."),
                            {}, measure<kHalving>),
      withKnobs<MarchKnobs>(
          march("sphere-tracing", "Sphere tracing", "MARCH_METHOD 2",
                "The distance to the scene is as far as a ray may go without meeting anything: the circles "
                "of the "
                "cut. Steps are long in the open and short near surfaces; rays that graze one take most."),
          {}, measure<kSphereTracing>)};
}

}  // namespace skydrop::lab
