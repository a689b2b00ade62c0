// The laboratory's distances, their operators and what is lit by them.
#include <gtest/gtest.h>

#include <cmath>

#include "skydrop/lab/distance_measure.h"
#include "skydrop/lab/shared.h"

namespace skydrop::lab {
namespace {

namespace f32 = core::shared::f32;
namespace f64 = core::shared::f64;
using glm::dvec3;

dvec3 placeOf(int i) {
  const auto part = [i](double step) { return std::fmod(0.37 + step * i, 1.0) * 4 - 2; };
  return {part(0.8191725133961645), part(0.6710436067037893), part(0.5497004779019703)};
}

TEST(LabDistance, shapesHaveTheDistancesOfTheirClosedForms) {
  EXPECT_DOUBLE_EQ(f64::sphereDistance({3, 0, 4}, 2), 3);
  EXPECT_DOUBLE_EQ(f64::boxDistance({4, 5, 0}, {1, 1, 1}), 5);       // to an edge
  EXPECT_DOUBLE_EQ(f64::boxDistance({0.2, 0, 0}, {1, 2, 3}), -0.8);  // inside
  EXPECT_DOUBLE_EQ(f64::torusDistance({0, 0, 0}, 2, 0.5), 1.5);
  EXPECT_DOUBLE_EQ(f64::torusDistance({2, 0, 0}, 2, 0.5), -0.5);
  EXPECT_DOUBLE_EQ(f64::planeDistance({5, 3, 1}, {0, 1, 0}, 1), 2);
  EXPECT_DOUBLE_EQ(f64::cylinderDistance({4, 5, 0}, 1, 1), 5);  // to the rim
  EXPECT_DOUBLE_EQ(f64::cylinderDistance({0, 0, 0}, 1, 2), -1);
}

TEST(LabDistance, mirroredPlacesHaveTheSameDistanceBitForBit) {
  for (int i = 0; i < 500; ++i) {
    const dvec3 p = placeOf(i), q(-p.x, -p.y, -p.z);
    EXPECT_EQ(f64::sphereDistance(p, 1), f64::sphereDistance(q, 1));
    EXPECT_EQ(f64::boxDistance(p, {1, 0.5, 0.7}), f64::boxDistance(q, {1, 0.5, 0.7}));
    EXPECT_EQ(f64::torusDistance(p, 1, 0.3), f64::torusDistance(q, 1, 0.3));
    EXPECT_EQ(f64::cylinderDistance(p, 0.8, 0.6), f64::cylinderDistance(q, 0.8, 0.6));
  }
}

TEST(LabDistance, floatIsDoubleToItsRounding) {
  for (int i = 0; i < 500; ++i) {
    const dvec3 p = placeOf(i);
    for (int scene = f64::kBallScene; scene <= f64::kTorusScene; ++scene)
      EXPECT_NEAR(f32::sceneDistance(scene, 0.5f, glm::vec3(p)), f64::sceneDistance(scene, 0.5, p), 2e-6)
          << scene;
  }
}

TEST(LabDistance, gradientsAreThoseOfTheDistances) {
  // Central differences of 1e-5 leave 1e-9 where the distance is smooth.
  constexpr double kStep = 1e-5;
  const auto differences = [](auto distance, const dvec3& p) {
    const dvec3 x(kStep, 0, 0), y(0, kStep, 0), z(0, 0, kStep);
    return dvec3(distance(p + x) - distance(p - x), distance(p + y) - distance(p - y),
                 distance(p + z) - distance(p - z)) /
           (2 * kStep);
  };
  for (int i = 0; i < 300; ++i) {
    const dvec3 p = placeOf(i);
    const dvec3 box(1, 0.5, 0.7);
    EXPECT_LT(glm::length(f64::sphereGradient(p) -
                          differences([](dvec3 q) { return f64::sphereDistance(q, 1); }, p)),
              1e-7);
    EXPECT_LT(glm::length(f64::torusGradient(p, 0.7) -
                          differences([](dvec3 q) { return f64::torusDistance(q, 0.7, 0.3); }, p)),
              1e-6);
    if (f64::boxDistance(p, box) < 1e-3) continue;
    EXPECT_LT(glm::length(f64::boxGradient(p, box) -
                          differences([&](dvec3 q) { return f64::boxDistance(q, box); }, p)),
              1e-6);
  }
}

TEST(LabDistance, unionsAreExactAndNoOperatorReachesBeyondTheSurface) {
  // A way of the distance never passes the surface; only exact distances end on it.
  EXPECT_LT(footError(f64::kShapesScene, 0).mostShort, 1e-8);
  EXPECT_LT(footError(f64::kUnionScene, 0).mostShort, 1e-8);
  EXPECT_GT(footError(f64::kDifferenceScene, 0).mostShort, 0.1);
  for (int scene = f64::kShapesScene; scene <= f64::kDifferenceScene; ++scene) {
    for (const double amount : {0.0, 0.5, 1.0}) EXPECT_LT(footError(scene, amount).mostBeyond, 1e-8) << scene;
  }
}

TEST(LabDistance, differencesConvergeInSecondOrderUntilTheyRound) {
  // A tenth of the epsilon leaves a hundredth of the error, in double down to 1e-5.
  for (const double epsilon : {1e-2, 1e-3, 1e-4}) {
    const double ratio = normalError(epsilon).inDouble / normalError(epsilon / 10).inDouble;
    EXPECT_NEAR(ratio, 100, 5) << epsilon;
  }
  EXPECT_GT(normalError(1e-7).inDouble, normalError(1e-6).inDouble);
  EXPECT_GT(normalError(1e-4).inFloat, normalError(1e-3).inFloat);
}

TEST(LabDistance, phongLightHasItsClosedForms) {
  const f64::PhongShares shares{0.1, 0.8, 0.5, 10};
  const dvec3 up(0, 1, 0), slanted(0, std::sqrt(0.5), std::sqrt(0.5));
  // From straight above, mirrored straight into the eye.
  EXPECT_DOUBLE_EQ(f64::phongLight(shares, up, up, up).x, 0.8);
  EXPECT_DOUBLE_EQ(f64::phongLight(shares, up, up, up).y, 0.5);
  EXPECT_NEAR(f64::phongLight(shares, up, slanted, up).x, 0.8 * std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(f64::phongLight(shares, up, slanted, up).y, 0.5 * std::pow(0.5, 5), 1e-15);
  EXPECT_EQ(f64::phongLight(shares, up, -up, up), glm::dvec2(0, 0));
}

TEST(LabDistance, hardShadowsAreThoseOfRaysInClosedForm) {
  // Of 3600 places at most one in a thousand, on the edge.
  const ShadowError hard = shadowError({}, 1e9);
  EXPECT_LE(hard.falseShade + hard.falseLight, 1e-3);
  // Softer ones have less light, and no light where the hard one has none.
  const ShadowError soft = shadowError({}, 7), softer = shadowError({}, 1.2);
  EXPECT_LT(soft.meanLight, hard.meanLight);
  EXPECT_LT(softer.meanLight, soft.meanLight);
  EXPECT_LE(softer.falseLight, 1e-3);
}

TEST(LabDistance, anOpenFloorIsOpenAndACornerIsNot) {
  // A level floor is as far away as the way along its normal.
  const dvec3 up(0, 1, 0);
  EXPECT_EQ(f64::opennessAt(f64::kUnionScene, 0, dvec3(30, 0, 0), up, 0.1, 3, 0.2), 1);
  // Beside a ball that touches the floor: distances fall short of the way.
  EXPECT_LT(f64::opennessAt(f64::kBallScene, 0, dvec3(0.2, 0, 0), up, 0.1, 3, 0.2), 0.8);
  EXPECT_EQ(f64::opennessAt(f64::kBallScene, 0, dvec3(0.2, 0, 0), up, 0.1, 0, 0.2), 1);
  // The usual three places are near the open share of the hemisphere.
  EXPECT_LT(occlusionError({}).rmsDifference, 0.05);
}

}  // namespace
}  // namespace skydrop::lab
