// A photograph beside a rendered picture: where it lies, what is written, what is refused.
#include "app/cli/photo_comparison.h"

#include <gtest/gtest.h>

#include <cmath>

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

core::Image plain(int width, int height, int grey) {
  core::Image image(width, height);
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    image.rgba[i] = static_cast<std::uint8_t>(i % 4 == 3 ? 255 : grey);
  return image;
}

// Each column as bright as its heading, 0 at its left edge.
core::Image headings() {
  core::Image image = plain(360, 180, 0);
  for (int y = 0; y < 180; ++y) {
    for (int x = 0; x < 360; ++x) image.pixel(x, y)[0] = static_cast<std::uint8_t>(x * 255 / 360);
  }
  return image;
}

render::View viewTo(double headingDeg) {
  // Columns of worldToView are the world's axes as the view has them: right, up, back.
  const double a = headingDeg * M_PI / 180;
  render::View view;
  view.width = 61, view.height = 41;
  view.fovYRad = 0.8;
  const glm::dvec3 right(std::cos(a), 0, std::sin(a)), up(0, 1, 0), back(-std::sin(a), 0, std::cos(a));
  view.worldToView = glm::transpose(glm::dmat3(right, up, back));
  return view;
}

TEST(Photo, aPanoramaShowsTheHeadingThatTheCameraLooksTo) {
  // East is 90 degrees from the left edge of one that begins in the north, 180 of one that begins in the
  // west.
  PhotoRequest request;
  request.panoramaFromDegrees = 0;
  const auto middle = [&](double heading) {
    return int{asSeen(headings(), request, viewTo(heading)).pixel(30, 20)[0]};
  };
  EXPECT_NEAR(middle(90), 90 * 255 / 360.0, 2);
  EXPECT_NEAR(middle(200), 200 * 255 / 360.0, 2);
  request.panoramaFromDegrees = 270;
  EXPECT_NEAR(middle(90), 180 * 255 / 360.0, 2);
  const core::Image seen = asSeen(headings(), request, viewTo(90));
  EXPECT_LT(seen.pixel(5, 20)[0], seen.pixel(55, 20)[0]) << "headings grow to the right";
}

TEST(Photo, aNarrowPhotographCoversItsOwnFieldAndNothingElse) {
  PhotoRequest request;
  request.fieldDegrees = 30;
  const render::View view = viewTo(0);
  const core::Image seen = asSeen(plain(40, 40, 200), request, view);
  const double pixels = std::tan(M_PI / 12) / (std::tan(view.fovYRad / 2) * view.aspect()) * 61;
  int covered = 0;
  for (int x = 0; x < 61; ++x) covered += seen.pixel(x, 20)[3] == 255;
  EXPECT_NEAR(covered, pixels, 1);
  EXPECT_EQ(seen.pixel(0, 0)[3], 0);
}

TEST(Photo, itIsLaidOverWipedOrSetBeside) {
  const core::Image dark = plain(10, 4, 40), bright = plain(10, 4, 240);
  EXPECT_EQ(together(dark, bright, PhotoView::overlay, 0.25).pixel(3, 2)[0], 90);
  const core::Image wiped = together(dark, bright, PhotoView::wipe, 0.3);
  EXPECT_EQ(wiped.pixel(2, 1)[0], 240);
  EXPECT_EQ(wiped.pixel(3, 1)[0], 40);
  const core::Image beside = together(dark, bright, PhotoView::beside, 0.3);
  ASSERT_EQ(beside.width, 20);
  EXPECT_EQ(beside.pixel(9, 1)[0], 240);
  EXPECT_EQ(beside.pixel(10, 1)[0], 40);
  EXPECT_EQ(together(dark, bright, PhotoView::none, 0.3).rgba, dark.rgba);
}

TEST(Photo, eachFrameIsALineOfTheTableAndAPlotShowsThem) {
  const test::TemporaryFolder folder;
  PhotoRequest request;
  request.file = folder.path() / "photo.png";
  request.table = folder.path() / "day.csv";
  request.plot = folder.path() / "day.png";
  core::writePng(request.file, plain(61, 41, 100));
  PhotoComparison comparison(request);
  const render::View view = viewTo(0);
  EXPECT_NE(comparison.compare(plain(61, 41, 100), view, 0, 0).find("brightness 0.000 0.000"),
            std::string::npos);
  EXPECT_NE(comparison.compare(plain(61, 41, 202), view, 1, 3600).find("brightness 1.000 0.397"),
            std::string::npos);
  comparison.finish();
  const std::string table = core::readTextFile(*request.table);
  EXPECT_TRUE(table.starts_with("frame,seconds,chiSquare brightness,")) << table;
  EXPECT_NE(table.find("\n0,0,0,"), std::string::npos) << table;
  EXPECT_NE(table.find("\n1,3600,1,"), std::string::npos) << table;
  const core::Image plot = core::readPng(*request.plot);
  int coloured = 0;
  for (std::size_t i = 0; i < plot.rgba.size(); i += 4) coloured += plot.rgba[i] != plot.rgba[i + 2];
  EXPECT_GT(coloured, 100);
}

TEST(Photo, aMaskOfAnotherSizeOrThatLeavesNothingIsRefusedInOneLine) {
  const test::TemporaryFolder folder;
  PhotoRequest request;
  request.file = folder.path() / "photo.png";
  request.mask = folder.path() / "mask.png";
  core::writePng(request.file, plain(61, 41, 100));
  core::writePng(*request.mask, plain(60, 41, 255));
  EXPECT_TRUE(test::isOneLineAbout(
      test::refusalOf<core::DataError>([&] { PhotoComparison comparison(request); }), "mask.png"));
  core::writePng(*request.mask, plain(61, 41, 0));
  PhotoComparison comparison(request);
  EXPECT_TRUE(test::isOneLineAbout(
      test::refusalOf<core::DataError>([&] { comparison.compare(plain(61, 41, 100), viewTo(0), 0, 0); }),
      "photo.png"));
}

}  // namespace
}  // namespace skydrop::app
