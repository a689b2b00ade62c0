// Parts of a picture as views of their own (render::partOf).
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "render/frame/visibility.h"
#include "skydrop/core/error.h"
#include "skydrop/render/frame/view.h"

namespace skydrop::render {
namespace {

View whole() {
  View view;
  view.width = 101, view.height = 37;
  view.fovYRad = 1.1;
  return view;
}

TEST(ViewPart, hasTheRaysOfTheWhole) {
  // To 1e-12: rounding alone. Of coarse pixels the ray is that of their middle.
  const View view = whole();
  for (const auto& [corner, side, pixelSize] :
       {std::tuple(glm::ivec2(0, 0), 16, 1), {glm::ivec2(96, 32), 8, 1}, {glm::ivec2(-8, 16), 8, 4}}) {
    const View part = partOf(view, corner, side, pixelSize);
    requireValid(part);
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        const glm::dvec2 middle(x + 0.5, y + 0.5);
        const glm::dvec3 ray = rayDirection(part, middle),
                         expected = rayDirection(view, glm::dvec2(corner) + middle * double(pixelSize));
        ASSERT_LT(glm::length(ray - expected), 1e-12);
        // Where the ray's points are drawn. Matrices are single precision: to a thousandth of a pixel.
        const glm::vec4 clip = viewProjection(part) * glm::vec4(ray * 50.0, 1);
        const glm::dvec2 pixel = (glm::dvec2(clip) / double(clip.w) + 1.0) * (0.5 * side);
        ASSERT_LT(glm::length(pixel - middle), 1e-3);
      }
    }
    EXPECT_NEAR(part.pixelAngleRad(), view.pixelAngleRad() * pixelSize, 1e-12);
  }
}

TEST(ViewPart, whatIsSeenInThePictureIsSeenInThePartThatHoldsIt) {
  // A small ball along the ray of every fourth pixel: visible in its part, and not in one two sides away.
  const View view = whole();
  constexpr int kSide = 8;
  const auto partAt = [&](int x, int y) {
    return partOf(view, {x / kSide * kSide, y / kSide * kSide}, kSide, 1);
  };
  for (int y = 1; y < view.height; y += 4) {
    for (int x = 1; x < view.width; x += 4) {
      const glm::dvec3 place = view.position + 100.0 * rayDirection(view, {x + 0.5, y + 0.5});
      EXPECT_TRUE(isPotentiallyVisible(partAt(x, y), place, 1)) << x << ' ' << y;
      EXPECT_FALSE(isPotentiallyVisible(partAt((x + 3 * kSide) % 104, y), place, 1)) << x << ' ' << y;
      const View part = partAt(x, y);
      const PixelBox box =
          pixelsOf(part, bodyMatrix(part, place, glm::dquat(1, 0, 0, 0)), glm::dvec3(-0.1), glm::dvec3(0.1));
      EXPECT_LE(box.lowX, x % kSide);
      EXPECT_GT(box.highX, x % kSide);
      EXPECT_LE(box.lowY, y % kSide);
      EXPECT_GT(box.highY, y % kSide);
    }
  }
}

TEST(ViewPart, anAxisThatIsNotFiniteIsRefused) {
  View view = whole();
  view.offAxis.y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(requireValid(view), core::RangeError);
}

}  // namespace
}  // namespace skydrop::render
