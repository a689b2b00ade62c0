#include "fuzz/fuzz_input.h"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "skydrop/core/error.h"
#include "skydrop/core/message.h"

namespace skydrop::fuzz {
namespace {

// Removed when the process ends as it should.
class OwnFolder {
 public:
  OwnFolder()
      : path_(std::filesystem::temp_directory_path() / ("skydrop-fuzz-" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(path_);
  }
  ~OwnFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

void requireLine(std::string_view file, const std::string& line) {
  require(!line.empty(), "a refusal says something");
  require(line == core::printable(line), "a refusal is one printable line: " + core::printable(line));
  require(line.find(file) != std::string::npos, "a refusal names the file: " + line);
}

std::uint32_t crcOf(std::span<const std::byte> bytes) {
  std::uint32_t crc = 0xffffffffu;
  for (const std::byte byte : bytes) {
    crc ^= std::to_integer<std::uint32_t>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
  }
  return ~crc;
}

}  // namespace

std::vector<std::string> linesOf(const std::uint8_t* data, std::size_t size) {
  std::vector<std::string> lines;
  std::string line;
  for (const char c : textOf(data, size)) {
    if (c == '\n') {
      lines.push_back(line);
      line.clear();
    } else {
      line += c;
    }
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

void require(bool holds, std::string_view sentence) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %.*s\n", static_cast<int>(sentence.size()), sentence.data());
  std::abort();
}

bool accepts(std::string_view file, const std::function<void()>& read) {
  try {
    read();
    return true;
  } catch (const core::DataError& error) {
    requireLine(file, error.what());
  } catch (const core::UsageError& error) {
    requireLine("", error.what());
  } catch (const core::RangeError& error) {
    requireLine("", error.what());
  }
  return false;
}

std::filesystem::path inputFolder() {
  static const OwnFolder folder;
  return folder.path();
}

std::filesystem::path inputFile(std::string_view name, const std::uint8_t* data, std::size_t size) {
  const std::filesystem::path file = inputFolder() / name;
  std::ofstream(file, std::ios::binary | std::ios::trunc) << textOf(data, size);
  return file;
}

std::vector<std::byte> withPngChecksums(std::span<const std::byte> png) {
  std::vector<std::byte> fixed(png.begin(), png.end());
  const auto word = [&](std::size_t at) {
    std::size_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | std::to_integer<std::size_t>(fixed[at + i]);
    return value;
  };
  for (std::size_t at = 8; at + 12 <= fixed.size();) {
    const std::size_t length = word(at);
    if (length > fixed.size() - at - 12) break;
    const std::uint32_t crc = crcOf(std::span(fixed).subspan(at + 4, length + 4));
    for (std::size_t i = 0; i < 4; ++i)
      fixed[at + 8 + length + i] = static_cast<std::byte>(crc >> (24 - 8 * i) & 0xff);
    at += 12 + length;
  }
  return fixed;
}

}  // namespace skydrop::fuzz
