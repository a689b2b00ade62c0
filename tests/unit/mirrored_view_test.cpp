// The view of the eye's mirror image at the sea: it shows what calm water mirrors, upside down, as far down
// and out as an eye may stand.
#include "render/water/mirrored_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <vector>

#include "support/margin.h"

namespace skydrop::render {
namespace {

View viewAt(const glm::dvec3& position) {
  View view;
  view.position = position;
  const glm::dvec3 forward = glm::normalize(glm::dvec3(0.5, -0.2, -0.8));
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0.1, 1, 0)));
  view.worldToView = glm::transpose(glm::dmat3(right, glm::cross(right, forward), -forward));
  view.width = 320, view.height = 180;
  view.fovYRad = 1;
  return view;
}

// In pixels of the view, as the GPU works it out.
glm::dvec2 pixelOf(const View& view, const glm::vec3& relative) {
  const glm::vec4 clip = viewProjection(view) * glm::vec4(relative, 1);
  return (glm::dvec2(clip) / static_cast<double>(clip.w) * 0.5 + 0.5) * glm::dvec2(view.width, view.height);
}

TEST(MirroredView, O10_showsWhatCalmWaterMirrors) {
  // A place stands in the mirrored picture where its mirror image stands in the view, upside down: within a
  // fiftieth of a pixel, from 5 cm above the sea and 1e9 m out too.
  for (const glm::dvec3& eye : {glm::dvec3(0, 20, 0), {0, 0.05, 0}, {1e9, 0.05, -1e9}, {-1e9, 150, 1e9}}) {
    const View view = viewAt(eye), mirror = mirroredView(view, 0, 1);
    requireValid(mirror);
    EXPECT_EQ(glm::ivec2(mirror.width, mirror.height), glm::ivec2(view.width, view.height));
    EXPECT_EQ(mirror.position, glm::dvec3(eye.x, -eye.y, eye.z));
    for (const double ahead : {3.0, 40.0, 900.0}) {
      for (const double aside : {-0.3, 0.0, 0.4}) {
        const glm::dvec3 way = view.forward() + view.right() * aside;
        const glm::dvec3 place(eye.x + std::round(ahead * way.x), 0.15 * ahead,
                               eye.z + std::round(ahead * way.z));
        const glm::dvec3 image(place.x, -place.y, place.z);
        const glm::dvec2 seen = pixelOf(view, relativeToEye(view, image));
        const glm::dvec2 mirrored = pixelOf(mirror, relativeToEye(mirror, place));
        EXPECT_TRUE(test::holds("O10", glm::length(mirrored - glm::dvec2(seen.x, view.height - seen.y)),
                                test::below(0.02), "pixels"));
        // As water/mirror.glsl follows rays: from places relative to the eye of the scene.
        const glm::mat4 toPicture =
            glm::translate(viewProjection(mirror), relativeToEye(mirror, view.position));
        const glm::vec4 clip = toPicture * glm::vec4(relativeToEye(view, place), 1);
        const glm::dvec2 followed = (glm::dvec2(clip) / static_cast<double>(clip.w) * 0.5 + 0.5) *
                                    glm::dvec2(view.width, view.height);
        EXPECT_TRUE(test::holds("O10", glm::length(followed - mirrored), test::below(0.02), "pixels"));
      }
    }
  }
}

TEST(MirroredView, isAsFineAndAsWideAsItIsAskedFor) {
  // Pixels `spacing` times as wide, to rounding; a margin on both sides, rounded up to a pixel.
  const View view = viewAt({0, 5, 0});
  for (const int spacing : {1, 2, 4}) {
    const View mirror = mirroredView(view, 0.25, spacing);
    EXPECT_NEAR(mirror.pixelAngleRad(), spacing * view.pixelAngleRad(), 1e-12);
    EXPECT_EQ(mirror.width, 480 / spacing);
    EXPECT_EQ(mirror.height, (270 + spacing - 1) / spacing);
  }
}

TEST(MirroredView, isValidHoweverWideTheViewIs) {
  View view = viewAt({0, 5, 0});
  view.fovYRad = 2.8;
  view.width = 16384, view.height = 9216;
  requireValid(mirroredView(view, 1, 1));
}

TEST(MirroredView, partOfAPictureHasThePartOfItsMirror) {
  // Off its axis the rays of a part are those of the whole: to 1e-9.
  const View whole = viewAt({3, 9, -4}), part = partOf(whole, {96, 32}, 32, 1);
  const View mirror = mirroredView(part, 0, 1), mirrorOfWhole = mirroredView(whole, 0, 1);
  for (const glm::dvec2& pixel : {glm::dvec2(0.5, 0.5), {31.5, 12.5}}) {
    // From the top row where the picture stands upside down.
    const glm::dvec2 inWhole(96 + pixel.x, whole.height - (32 + 32 - pixel.y));
    EXPECT_LT(glm::length(rayDirection(mirror, pixel) - rayDirection(mirrorOfWhole, inWhole)), 1e-9);
  }
}

TEST(MirroredView, saysWhyAViewHasNothing) {
  EXPECT_FALSE(whyNothingIsMirrored(viewAt({0, 1e-9, 0})));
  EXPECT_EQ(whyNothingIsMirrored(viewAt({0, 0, 0})), "the view is below the sea");
  EXPECT_EQ(whyNothingIsMirrored(viewAt({0, kMirrorEndsM, 0})),
            "the view is too high for what water mirrors");
}

}  // namespace
}  // namespace skydrop::render
