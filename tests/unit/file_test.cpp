#include "skydrop/core/file.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <utility>
#include <vector>

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

TEST_F(FileTest, onlyRegularFilesAreReadAndNothingElseIsWaitedFor) {
  // Opening a pipe waits for a writer, reading /dev/zero never ends: each kind is refused at once, by name.
  const auto refusal = [](const fs::path& file) {
    return test::refusalOf<DataError>([&] { readTextFile(file, 100); });
  };
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(refusal(pipe), pipe.string() + ": cannot open: is a pipe, not a regular file");
  EXPECT_EQ(refusal("/dev/zero"), "/dev/zero: cannot open: is a device, not a regular file");
  EXPECT_EQ(refusal(folder_), folder_.string() + ": cannot open: is a folder");

  const fs::path socket = folder_ / "socket";
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  ASSERT_LT(socket.native().size(), sizeof address.sun_path);
  std::strcpy(address.sun_path, socket.c_str());
  const int listener = ::socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  EXPECT_EQ(refusal(socket), socket.string() + ": cannot open: is a socket, not a regular file");
  close(listener);

  // A link is what it leads to.
  fs::create_symlink(pipe, folder_ / "link");
  EXPECT_EQ(refusal(folder_ / "link"),
            (folder_ / "link").string() + ": cannot open: is a pipe, not a regular file");
  writeFileAtomically(folder_ / "a.txt", "text");
  fs::create_symlink("a.txt", folder_ / "good");
  EXPECT_EQ(readTextFile(folder_ / "good"), "text");
}

TEST_F(FileTest, aPathThatNoFileCanHaveIsRefusedInOneLine) {
  // A zero byte would end the name early, and another file would be read.
  writeFileAtomically(folder_ / "a.txt", "text");
  const std::string cut = (folder_ / "a.txt").string() + std::string(1, '\0') + ".json";
  EXPECT_EQ(test::refusalOf<DataError>([&] { readTextFile(cut); }),
            (folder_ / "a.txt").string() + "\\x00.json: cannot open: a zero byte cannot be in a path");
  const std::string line =
      test::refusalOf<DataError>([&] { readTextFile(folder_ / std::string(5000, 'x')); });
  EXPECT_LT(line.size(), 1000u);
  EXPECT_NE(line.find("name too long"), std::string::npos) << line;
}

TEST_F(FileTest, aHyphenNamesStandardInputWhereTheCommandLineDoes) {
  EXPECT_TRUE(isStandardInput("-"));
  EXPECT_FALSE(isStandardInput("./-"));
  EXPECT_EQ(inputName("-"), "standard input");
  EXPECT_EQ(inputName("a.json"), "a.json");
  writeFileAtomically(folder_ / "a.txt", "text");
  EXPECT_EQ(readTextInput(folder_ / "a.txt"), "text");
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
  // Cut anywhere, or with any one byte changed: no picture comes of it, and the line names the file.
  Image image(16, 16);
  for (std::size_t i = 0; i < image.rgba.size(); ++i) image.rgba[i] = static_cast<std::uint8_t>(i * i);
  const std::vector<std::byte> good = encodePng(image);
  const auto refusal = [](std::span<const std::byte> bytes) {
    return test::refusalOf<DataError>([&] { decodePng(bytes, "a.png"); });
  };
  for (std::size_t length = 0; length < good.size(); ++length)
    EXPECT_TRUE(refusal(std::span(good).first(length)).starts_with("a.png: ")) << length;
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (const std::byte change : {std::byte{0x01}, std::byte{0x20}, std::byte{0xff}}) {
      std::vector<std::byte> bytes = good;
      bytes[at] ^= change;
      EXPECT_TRUE(refusal(bytes).starts_with("a.png: ")) << at;
    }
  }
  const auto end = good.size() - 12;  // the end chunk
  EXPECT_EQ(refusal(std::span(good).first(end)), "a.png: chunk IEND: is missing: the file is cut off");
  EXPECT_EQ(refusal(std::span(good).first(end - 1)), "a.png: chunk IDAT: is cut off, as the file is");
  std::vector<std::byte> bytes = good;
  bytes[bytes.size() - 20] ^= std::byte{1};
  EXPECT_EQ(refusal(bytes), "a.png: chunk IDAT: its checksum is wrong");
  bytes = good;
  bytes.resize(bytes.size() + 100);
  EXPECT_EQ(refusal(bytes), "") << "what follows the end chunk is no part of the picture";
}

// Chunks with checksums that are right, whatever they hold.
std::vector<std::byte> pngOf(std::initializer_list<std::pair<std::string, std::string>> chunks) {
  std::string text = "\x89PNG\r\n\x1a\n";
  const auto word = [](std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xff);
    return bytes;
  };
  for (const auto& [type, data] : chunks) {
    std::uint32_t crc = 0xffffffffu;
    for (const char c : type + data) {
      crc ^= static_cast<unsigned char>(c);
      for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? 0xedb88320u ^ (crc >> 1) : crc >> 1;
    }
    text += word(static_cast<std::uint32_t>(data.size())) + type + data + word(~crc);
  }
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

TEST_F(FileTest, pngsKeepWhatIsSaidAboutThem) {
  using namespace std::string_literals;
  Image image(3, 2);
  for (std::size_t i = 0; i < image.rgba.size(); ++i) image.rgba[i] = static_cast<std::uint8_t>(i * 11);
  const std::vector<PictureText> texts = {
      {"Software", "skydrop"}, {"Title", "a line\nand \xc3\xa9"}, {"Empty", ""}};
  const std::vector<std::byte> file = encodePng(image, texts);
  EXPECT_EQ(readPngTexts(file, "a.png"), texts);
  EXPECT_EQ(decodePng(file, "a.png").rgba, image.rgba);
  EXPECT_TRUE(readPngTexts(encodePng(image), "a.png").empty());
  // Those of other programs; what is compressed or malformed is left out, and the picture is still one.
  const std::string header = "\0\0\0\1\0\0\0\1\x08\0\0\0\0"s;
  const std::string pixels = "\x78\x01\x01\x02\0\xfd\xff\0\x40\0\x42\0\x41"s;
  const std::vector<std::byte> foreign = pngOf({{"IHDR", header},
                                                {"tEXt", "Author\0somebody"s},
                                                {"iTXt", "Title\0\0\0en\0Titel\0of two"s},
                                                {"iTXt", "Packed\0\1\0\0\0xyz"s},
                                                {"tEXt", "no null"s},
                                                {"iTXt", "Cut\0"s},
                                                {"iTXt", ""s},
                                                {"IDAT", pixels},
                                                {"tEXt", "Late\0behind"s},
                                                {"IEND", ""}});
  const std::vector<PictureText> expected = {{"Author", "somebody"}, {"Title", "of two"}, {"Late", "behind"}};
  EXPECT_EQ(readPngTexts(foreign, "b.png"), expected);
  EXPECT_EQ(int{decodePng(foreign, "b.png").pixel(0, 0)[0]}, 0x40);
}

TEST_F(FileTest, pngsWhosePixelsAreNotWhatTheyShouldBeAreRefused) {
  // The chunks are sound here: what is inside them is not.
  using namespace std::string_literals;
  const auto refusal = [](const std::vector<std::byte>& bytes) {
    return test::refusalOf<DataError>([&] { decodePng(bytes, "a.png"); });
  };
  const std::string header = "\0\0\0\1\0\0\0\1\x08\0\0\0\0"s;      // one grey pixel
  const std::string stored = "\x78\x01\x01\x02\0\xfd\xff\0\x40"s;  // its row: no filter, 0x40, not compressed
  const std::string good = stored + "\0\x42\0\x41"s;
  EXPECT_EQ(refusal(pngOf({{"IHDR", header}, {"IDAT", good}, {"IEND", ""}})), "");
  EXPECT_EQ(
      refusal(pngOf({{"IHDR", header}, {"IDAT", good.substr(0, 5)}, {"IDAT", good.substr(5)}, {"IEND", ""}})),
      "");
  EXPECT_EQ(refusal(pngOf({{"IHDR", header}, {"IDAT", stored + "\0\x42\0\x42"s}, {"IEND", ""}})),
            "a.png: pixels: their checksum is wrong");
  EXPECT_EQ(refusal(pngOf({{"IHDR", "\0\0\0\1\0\0\0\2\x08\0\0\0\0"s}, {"IDAT", good}, {"IEND", ""}})),
            "a.png: pixels: are cut off: there are fewer than the header says");
  EXPECT_EQ(refusal(pngOf({{"IHDR", "\0\0\x20\0\0\0\x20\0\x08\6\0\0\0"s}, {"IDAT", good}, {"IEND", ""}})),
            "a.png: pixels: are cut off: there are fewer than the header says")
      << "before 256 MiB are allocated";
  EXPECT_EQ(refusal(pngOf({{"IDAT", good}, {"IHDR", header}, {"IEND", ""}})),
            "a.png: chunk IHDR: is not the first");
  EXPECT_EQ(refusal(pngOf({{"IHDR", header}, {"IHDR", header}, {"IDAT", good}, {"IEND", ""}})),
            "a.png: chunk IHDR: is there twice");
  EXPECT_EQ(refusal(pngOf({{"IHDR", header}, {"IEND", ""}})), "a.png: chunk IDAT: is missing");
  EXPECT_EQ(refusal(pngOf({{"IHDR", header.substr(1)}, {"IDAT", good}, {"IEND", ""}})),
            "a.png: chunk IHDR: is of the wrong length");
  EXPECT_NE(refusal(pngOf({{"IHDR", "\0\0\0\0\0\0\0\1\x08\0\0\0\0"s}, {"IDAT", good}, {"IEND", ""}})), "");
  EXPECT_NE(refusal(pngOf({{"IHDR", "\0\0\0\1\0\0\0\1\x07\0\0\0\0"s}, {"IDAT", good}, {"IEND", ""}})), "");
}

}  // namespace
}  // namespace skydrop::core
