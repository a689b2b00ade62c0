#include "skydrop/core/file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "skydrop/core/error.h"
#include "skydrop/core/image.h"
#include "support/refusal.h"

namespace skydrop::core {
namespace {

namespace fs = std::filesystem;

// A folder of its own for each test, gone afterwards.
class FileTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("skydrop-file-test-" + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  fs::path folder_;
};

TEST_F(FileTest, whatIsWrittenReadsBack) {
  writeFileAtomically(folder_ / "a.txt", "first");
  writeFileAtomically(folder_ / "a.txt", "second\n");
  EXPECT_EQ(readTextFile(folder_ / "a.txt"), "second\n");
  EXPECT_EQ(entries(), 1u) << "a temporary file is left";
}

TEST_F(FileTest, aFailedWriteLeavesTheOldFileAndNoTemporary) {
  // The target is a folder, so the last rename fails.
  fs::create_directory(folder_ / "target");
  fs::create_directory(folder_ / "target" / "inner");
  EXPECT_THROW(writeFileAtomically(folder_ / "target", "x"), DataError);
  EXPECT_TRUE(fs::is_directory(folder_ / "target" / "inner"));
  EXPECT_EQ(entries(), 1u);
}

TEST_F(FileTest, aFolderThatTakesNoFilesIsAnError) {
  EXPECT_THROW(writeFileAtomically("/proc/skydrop/a.txt", "x"), DataError);
}

TEST_F(FileTest, missingFilesAndFoldersAreNamed) {
  EXPECT_EQ(test::refusalOf<DataError>([&] { readFile(folder_ / "none.bin"); }),
            (folder_ / "none.bin").string() + ": cannot open: No such file or directory");
  EXPECT_THROW(readFile(folder_), DataError);
}

TEST_F(FileTest, foldersAreMadeWithThoseTheyLieIn) {
  // All of a path that is missing is made, and making it again is no failure; a file in the way is named.
  makeFolder(folder_ / "outer" / "inner");
  makeFolder(folder_ / "outer" / "inner");
  EXPECT_TRUE(fs::is_directory(folder_ / "outer" / "inner"));
  writeFileAtomically(folder_ / "file", "x");
  EXPECT_EQ(test::refusalOf<DataError>([&] { makeFolder(folder_ / "file" / "inner"); }),
            (folder_ / "file" / "inner").string() + ": cannot make the folder: Not a directory");
}

TEST_F(FileTest, aFileBeyondTheLimitIsRefused) {
  writeFileAtomically(folder_ / "a.bin", std::string(1000, 'x'));
  EXPECT_EQ(readFile(folder_ / "a.bin", 1000).size(), 1000u);
  EXPECT_THROW(readFile(folder_ / "a.bin", 999), DataError);
}

TEST_F(FileTest, pngRoundTripKeepsEveryPixel) {
  Image image(7, 5);
  for (std::size_t i = 0; i < image.rgba.size(); ++i) image.rgba[i] = static_cast<std::uint8_t>(i * 37);
  writePng(folder_ / "a.png", image);
  const Image back = readPng(folder_ / "a.png");
  EXPECT_EQ(back.width, 7);
  EXPECT_EQ(back.height, 5);
  EXPECT_EQ(back.rgba, image.rgba);
}

TEST_F(FileTest, damagedPngsAreRefusedInOneLine) {
  std::vector<std::byte> bytes = encodePng(Image(16, 16));
  EXPECT_THROW(decodePng({}, "empty.png"), DataError);
  for (std::size_t length = 1; length < bytes.size() - 12; ++length) {  // 12 bytes: the end chunk, not needed
    EXPECT_THROW(decodePng(std::span(bytes).first(length), "cut.png"), DataError) << length;
  }
  for (std::size_t i = 16; i < 20; ++i) bytes[i] = std::byte{0xff};  // the width
  EXPECT_THROW(decodePng(bytes, "wide.png"), DataError);
}

}  // namespace
}  // namespace skydrop::core
