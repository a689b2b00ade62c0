// Photographs: read, or refused in one line.
#include "skydrop/core/picture_file.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "core/jpeg_check.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "support/instrumented.h"
#include "support/mutants.h"
#include "support/paths.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace skydrop::core {
namespace {

std::filesystem::path corpus() { return test::sourceDir() + "/tests/corpus/pictures"; }

TEST(PictureFile, aPhotographHasTheColoursOfItsPixels) {
  // The formula of make_pictures.py: red grows downwards from 60 by 3 a row, but in every ninth column, green
  // from 120 by 4; within what quality 80 loses. A progressive one is the same picture.
  for (const char* name : {"goodBaseline.jpg", "goodProgressive.jpg"}) {
    const Image image = readPicture(corpus() / name);
    ASSERT_EQ(image.width, 48) << name;
    ASSERT_EQ(image.height, 32) << name;
    for (const int y : {4, 16, 28}) {
      const std::uint8_t* pixel = image.pixel(22, y);
      EXPECT_NEAR(pixel[0], 60 + 3 * y, 16) << name << y;
      EXPECT_NEAR(pixel[1], 120 + 4 * y, 12) << name << y;
      EXPECT_EQ(pixel[3], 255);
    }
  }
  const Image grey = readPicture(corpus() / "goodGreyWithRestarts.jpg");
  ASSERT_EQ(grey.width, 33);
  EXPECT_EQ(grey.pixel(5, 5)[0], grey.pixel(5, 5)[2]);
  EXPECT_NEAR(grey.pixel(5, 5)[0], 60, 12);
}

TEST(PictureFile, thePictureFormatIsThatOfTheContentNotOfTheName) {
  const test::TemporaryFolder folder;
  Image image(3, 2);
  image.pixel(2, 1)[1] = 77;
  writePng(folder.path() / "really.jpg", image);
  EXPECT_EQ(readPicture(folder.path() / "really.jpg").rgba, image.rgba);
  std::filesystem::copy_file(corpus() / "goodBaseline.jpg", folder.path() / "really.png");
  EXPECT_EQ(readPicture(folder.path() / "really.png").width, 48);
}

TEST(PictureFile, aPhotographWithoutItsEndMarkIsRefusedBeforeItIsDecoded) {
  // Cut before the mark, and with the mark of something else in its place: a decoder has all pixels by then.
  const std::vector<std::byte> whole = readFile(corpus() / "goodBaseline.jpg");
  ASSERT_EQ(whole.back(), std::byte{0xd9});
  EXPECT_EQ(checkJpeg(whole, "whole").width, 48);
  std::vector<std::byte> cut(whole.begin(), whole.end() - 2);
  EXPECT_TRUE(
      test::isOneLineAbout(test::refusalOf<DataError>([&] { checkJpeg(cut, "cut.jpg"); }), "cut.jpg"));
  for (const int byte : {0xff, 0xfe, 0x00, 0x02}) cut.push_back(std::byte(byte));  // an empty comment
  EXPECT_TRUE(test::isOneLineAbout(test::refusalOf<DataError>([&] { checkJpeg(cut, "comment.jpg"); }),
                                   "comment.jpg"));
}

TEST(PictureCorpus, everyPhotographIsReadOrRefusedAsItsNameSays) {
  std::size_t seen = 0;
  for (const auto& entry : std::filesystem::directory_iterator(corpus())) {
    const std::string name = entry.path().filename().string();
    ++seen;
    if (name.starts_with("good")) {
      EXPECT_GT(readPicture(entry.path()).width, 0) << name;
    } else {
      EXPECT_TRUE(test::isOneLineAbout(test::refusalOf<DataError>([&] { readPicture(entry.path()); }), name))
          << name;
    }
  }
  EXPECT_GE(seen, 20u);
}

TEST(PictureCorpus, mutantsOfPhotographsAreReadOrRefusedInOneLine) {
  const test::TemporaryFolder folder;
  for (const char* name : {"goodBaseline.jpg", "goodProgressive.jpg", "goodGreyWithRestarts.jpg"}) {
    const std::vector<std::byte> bytes = readFile(corpus() / name);
    const std::string good(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    test::forEachMutant(good, test::repetitions(400), [&](const std::string& mutant) {
      try {
        const Image image = decodePicture(std::as_bytes(std::span(mutant)), "mutant");
        EXPECT_EQ(image.rgba.size(),
                  static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4);
      } catch (const DataError& refusal) {
        EXPECT_TRUE(test::isOneLineAbout(refusal.what(), "mutant")) << refusal.what();
      }
    });
  }
}

}  // namespace
}  // namespace skydrop::core
