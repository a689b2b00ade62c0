// A photograph beside a rendered picture: where it lies, what is written, what is refused.
#include "app/cli/photo_comparison.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>

#include "app/cli/photo_sky.h"
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

TEST(Photo, besideItThePictureShowsItsMiddleAndThePhotographTheSame) {
  // A quarter of the width further right a moved view has the rays of the view; there a photograph lies too.
  const render::View view = viewTo(30), moved = withRoomToTheLeft(view);
  PhotoRequest request;
  request.fieldDegrees = 50;
  const core::Image photo = plain(60, 40, 0);
  for (const double x : {15.25, 30.5, 40.0}) {
    const glm::dvec2 there(x + 0.25 * view.width, 11);
    EXPECT_LT(glm::length(render::rayDirection(moved, there) - render::rayDirection(view, {x, 11})), 1e-12);
    const glm::dvec2 before = photoPlaceOf(photo, request, view, {x, 11}),
                     after = photoPlaceOf(photo, request, moved, there);
    EXPECT_NEAR(after.x, before.x, 1e-12);
    EXPECT_NEAR(after.y, before.y, 1e-12);
  }
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

TEST(Photo, theSkyOfAFrameIsWhereNeitherLandNorSeaIs) {
  const render::View view = viewTo(0);
  std::vector<float> depth(static_cast<std::size_t>(view.width * view.height), 0.0F);
  depth[static_cast<std::size_t>(30 * view.width + 7)] = 0.01F;  // a mountain, 30 rows from below
  const core::Image sky = skyOfFrame(view, depth);
  EXPECT_EQ(sky.pixel(8, 10)[0], 255);
  EXPECT_EQ(sky.pixel(7, view.height - 1 - 30)[0], 0) << "land";
  EXPECT_EQ(sky.pixel(8, 30)[0], 0) << "the sea, below the horizon";
  EXPECT_EQ(skyOfFrame(view, {}).pixel(8, 40)[0], 255) << "where there is no land there is no sea";
}

TEST(Photo, theSkyOfAPhotographIsFoundWithinAFewPixelsInAHundred) {
  // Photographs whose sky is known: hills of woods and fields with grain before a sky that grows lighter
  // downwards; with soft clouds; in haze. Measured: the share of pixels on the wrong side.
  std::mt19937 random(5);
  std::uniform_int_distribution<int> grain(-9, 9);
  const std::array<double, 3> most = {0.015, 0.015, 0.015};
  for (int kind = 0; kind < 3; ++kind) {
    core::Image photo = plain(240, 160, 0);
    std::vector<bool> isSky;
    for (int y = 0; y < 160; ++y) {
      for (int x = 0; x < 240; ++x) {
        const double ridge = 90 + 18 * std::sin(x / 31.0) + 7 * std::sin(x / 9.0);
        const bool sky = y < ridge;
        isSky.push_back(sky);
        const double cloud =
            kind == 1 ? std::max(0.0, std::sin(x / 37.0 + 1) * std::sin(y / 23.0 + 0.5)) * 60 : 0;
        const double haze = kind == 2 ? 0.5 : 0;
        const std::array<double, 3> above = {90 + 0.6 * y + cloud, 130 + 0.5 * y + cloud, 200 + 0.2 * y};
        const double wood = (x / 13 + y / 8) % 3 == 0 ? 25 : 0;
        const std::array<double, 3> below = {50 + wood, 75 + wood, 45.0};
        for (std::size_t c = 0; c < 3; ++c) {
          const double value = sky ? above[c] : below[c] + haze * (170 - below[c]);
          const int noise = grain(random) / (sky ? 4 : 1);
          photo.pixel(x, y)[c] = static_cast<std::uint8_t>(std::clamp(value + noise, 0.0, 255.0));
        }
      }
    }
    const core::Image mask = skyOfPhoto(photo);
    int wrong = 0;
    for (std::size_t i = 0; i < isSky.size(); ++i) wrong += (mask.rgba[4 * i] >= 128) != isSky[i];
    const double share = wrong / double(isSky.size());
    RecordProperty("wrong" + std::to_string(kind), std::to_string(share));
    std::printf("sky of photograph %d: %.4f of the pixels on the wrong side\n", kind, share);
    EXPECT_LE(share, most[static_cast<std::size_t>(kind)]) << kind;
  }
}

TEST(Photo, distancesAreThoseOfTheSkyAndOfTheLand) {
  // The photograph has the sky of the picture and other land.
  const test::TemporaryFolder folder;
  PhotoRequest request;
  request.file = folder.path() / "photo.png";
  request.table = folder.path() / "day.csv";
  request.sky = PhotoSky::frame;
  core::Image photo = plain(61, 41, 100), picture = plain(61, 41, 100);
  for (int y = 25; y < 41; ++y)
    for (int x = 0; x < 61; ++x) photo.pixel(x, y)[0] = photo.pixel(x, y)[1] = photo.pixel(x, y)[2] = 202;
  core::writePng(request.file, photo);
  const std::vector<float> none(61 * 41, 0.0F);
  const core::Image sky = skyOfFrame(viewTo(0), none);
  PhotoComparison comparison(request);
  ASSERT_TRUE(comparison.wantsSky());
  const std::string line = comparison.compare(picture, viewTo(0), 0, 0, std::nullopt, &sky);
  EXPECT_NE(line.find("sky, chi-square and earth mover's: brightness 0.000 0.000"), std::string::npos)
      << line;
  EXPECT_EQ(line.find("land: brightness 0.000"), std::string::npos) << line;
  comparison.finish();
  EXPECT_NE(core::readTextFile(*request.table).find("land chiSquare brightness"), std::string::npos);
}

TEST(Photo, ofADayOfPhotographsTheNearestInTimeIsCompared) {
  EXPECT_EQ(sky::instantText(*timeInName("bern_20260621T1300.jpg")), "2026-06-21T13:00:00Z");
  EXPECT_EQ(sky::instantText(*timeInName("2026-06-21_13-05-30 west.jpg")), "2026-06-21T13:05:30Z");
  EXPECT_EQ(timeInName("IMG_1234.jpg"), std::nullopt);
  EXPECT_EQ(timeInName("20261321T1300.jpg"), std::nullopt);
  const test::TemporaryFolder folder;
  PhotoRequest request;
  request.file = folder.path() / "cam_20260621T0800.png";
  request.others = {folder.path() / "cam_20260621T1200.png"};
  request.table = folder.path() / "day.csv";
  request.plot = folder.path() / "day.svg";
  core::writePng(request.file, plain(61, 41, 100));
  core::writePng(request.others[0], plain(61, 41, 202));
  PhotoComparison comparison(request);
  const auto at = [](const char* text) { return std::optional(sky::parseInstant(text)); };
  EXPECT_NE(
      comparison.compare(plain(61, 41, 100), viewTo(0), 0, 0, at("2026-06-21T09:59")).find("0.000 0.000"),
      std::string::npos);
  EXPECT_NE(
      comparison.compare(plain(61, 41, 202), viewTo(0), 1, 7200, at("2026-06-21T10:01")).find("0.000 0.000"),
      std::string::npos);
  EXPECT_THROW(comparison.compare(plain(61, 41, 202), viewTo(0), 2, 1), core::DataError) << "without a clock";
  comparison.finish();
  const std::string table = core::readTextFile(*request.table);
  EXPECT_NE(table.find(",2026-06-21T09:59:00Z,\"cam_20260621T0800.png\""), std::string::npos) << table;
  EXPECT_NE(table.find(",2026-06-21T10:01:00Z,\"cam_20260621T1200.png\""), std::string::npos) << table;
  const std::string plot = core::readTextFile(*request.plot);
  EXPECT_TRUE(plot.starts_with("<svg")) << plot;
  EXPECT_NE(plot.find(">09:59<"), std::string::npos);
  request.others = {folder.path() / "IMG_1.png"};
  EXPECT_TRUE(test::isOneLineAbout(test::refusalOf<core::DataError>([&] { PhotoComparison none(request); }),
                                   "IMG_1.png"));
}

}  // namespace
}  // namespace skydrop::app
