// A photograph over the picture in the real window.
#include <gtest/gtest.h>

#include "skydrop/core/image.h"
#include "support/temporary_folder.h"
#include "window/flown_game.h"

namespace skydrop::test {
namespace {

// Of one colour that nothing in the game has.
std::string writePhoto(const TemporaryFolder& folder) {
  core::Image photo(160, 90);
  for (std::size_t i = 0; i < photo.rgba.size(); i += 4) {
    photo.rgba[i] = photo.rgba[i + 2] = 255;
    photo.rgba[i + 3] = 255;
  }
  core::writePng(folder.path() / "photo.png", photo);
  return folder.path() / "photo.png";
}

// How much of it a pixel shows: 1 all, about 0 nothing.
double purpleAt(const core::Image& picture, double x, double y) {
  const std::uint8_t* pixel =
      picture.pixel(static_cast<int>(x * picture.width), static_cast<int>(y * picture.height));
  return (0.5 * (pixel[0] + pixel[2]) - pixel[1]) / 255;
}

TEST(PhotoWindow, itIsWipedLaidOverOrSetBesideAt640x360) {
  SKIP_WITHOUT_DISPLAY();
  const TemporaryFolder folder;
  const std::string photo = writePhoto(folder);
  {
    FlownGame flown({"--photo", photo, "--photo-view", "wipe", "--photo-share", "0.5", "--no-hud"});
    const core::Image wiped = flown.screenshot();
    ASSERT_EQ(wiped.width, 640);
    EXPECT_GT(purpleAt(wiped, 0.25, 0.5), 0.9);
    EXPECT_GT(purpleAt(wiped, 0.48, 0.9), 0.9);
    EXPECT_LT(purpleAt(wiped, 0.52, 0.9), 0.4);
    EXPECT_LT(purpleAt(wiped, 0.75, 0.5), 0.4);
  }
  FlownGame flown({"--photo", photo, "--photo-view", "beside", "--no-hud"});
  const core::Image beside = flown.screenshot();
  EXPECT_GT(purpleAt(beside, 0.25, 0.5), 0.9);
  EXPECT_GT(purpleAt(beside, 0.02, 0.02), 0.9) << "all of the left half";
  EXPECT_GT(purpleAt(beside, 0.48, 0.98), 0.9);
  EXPECT_LT(purpleAt(beside, 0.52, 0.5), 0.4);
  EXPECT_LT(purpleAt(beside, 0.75, 0.5), 0.4);
  // O goes on: hidden, laid over.
  flown.press("o");
  const core::Image hidden = flown.screenshot();
  EXPECT_LT(purpleAt(hidden, 0.25, 0.5), 0.4);
  flown.press("o");
  const core::Image over = flown.screenshot();
  EXPECT_GT(purpleAt(over, 0.25, 0.5), 0.4);
  EXPECT_GT(purpleAt(over, 0.75, 0.5), 0.4);
}

}  // namespace
}  // namespace skydrop::test
