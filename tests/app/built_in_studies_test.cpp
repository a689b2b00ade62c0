#include <gtest/gtest.h>

#include <cmath>

#include "app/studies/subjects.h"
#include "skydrop/accuracy/runner.h"

namespace skydrop::app {
namespace {

TEST(BuiltInStudies, canAllBeRun) {
  // Paths and values are those of the program, and no reference is one of the values.
  std::vector<accuracy::Study> studies;
  for (const std::string& name : accuracy::listStudies()) studies.push_back(accuracy::loadStudy(name));
  EXPECT_GE(studies.size(), 24u);
  Subjects subjects({160, 90});
  EXPECT_NO_THROW(accuracy::requireRunnable(studies, subjects.source(), {}));
}

// A study whose points are so cheap that a test can measure them.
accuracy::Observation observed(accuracy::Subject& subject, const accuracy::Assignments& set) {
  accuracy::Experiment experiment;
  experiment.set = set;
  experiment.timed = "cpu";
  EXPECT_FALSE(subject.checked(experiment).empty());
  return subject.observe(experiment);
}

TEST(BuiltInStudies, subjectsGiveTheSameBitsAgain) {
  // In any order, also where threads make land.
  const std::vector<std::pair<const char*, accuracy::Assignments>> all = {
      {"motion", {"body=flight", "rateHz=30"}},
      {"landing", {"solver=euler"}},
      {"land", {"what=normals"}},
      {"streaming", {"what=revisit", "cacheMiB=16", "workers=2"}},
      {"farNoise", {"arithmetic=floats", "distanceM=1e7"}},
      {"depth", {"format=unorm24"}},
      {"target", {"format=float11"}},
      {"noiseTexture", {"side=32"}},
      {"sky", {"quantity=singleScattering"}},
      {"march", {"steps=16"}}};
  for (const auto& [name, set] : all) {
    Subjects one({16, 9}), other({16, 9});
    const accuracy::Observation first = observed(*one.find(name), set);
    const accuracy::Observation again = observed(*other.find(name), set);
    EXPECT_EQ(accuracy::notFiniteAt(first), "") << name;
    EXPECT_EQ(first.values, again.values) << name;
    EXPECT_EQ(first.positions, again.positions) << name;
    EXPECT_FALSE(first.values.empty() && first.positions.empty() && first.directions.empty()) << name;
  }
}

TEST(BuiltInStudies, aTextureOfNoiseConvergesWithItsSide) {
  // Trilinear filtering is of order 2 in the texel; a wrong registration of texels would be of order 1.
  Subjects subjects({16, 9});
  accuracy::Subject& subject = *subjects.find("noiseTexture");
  const auto rmse = [&](const char* side) {
    const accuracy::Observation a = observed(subject, {side, "texels=float32"});
    const accuracy::Observation r = observed(subject, {"side=1024", "texels=float32"});
    double sum = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
      const double d = a.values[i] - r.values[i];
      sum += d * d;
    }
    return std::sqrt(sum);
  };
  EXPECT_GT(rmse("side=64") / rmse("side=128"), 3);
}

}  // namespace
}  // namespace skydrop::app
