// What the fuzz targets share. A target is one file with LLVMFuzzerTestOneInput: it hands the bytes to one
// reader, which accepts them or refuses them in one printable line. Anything else (another exception, a line
// that is none, a broken promise about what was accepted, a finding of a sanitizer) ends the program.
//
// Linked with libFuzzer by the preset `fuzz`, and into fuzz_replay of the usual suites (replay.cpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace skydrop::fuzz {

inline std::span<const std::byte> bytesOf(const std::uint8_t* data, std::size_t size) {
  return std::as_bytes(std::span(data, size));
}
// A copy: sanitizers see a reader that goes beyond its end.
inline std::string textOf(const std::uint8_t* data, std::size_t size) { return {data, data + size}; }
std::vector<std::string> linesOf(const std::uint8_t* data, std::size_t size);

// Ends the program with the sentence unless it holds.
void require(bool holds, std::string_view sentence);

// Runs the reader. False: it refused with a DataError, UsageError or RangeError of one printable line, which
// names `file` where that is not empty. Other exceptions pass.
bool accepts(std::string_view file, const std::function<void()>& read);

// For readers that take a path: a file with this name in a folder of this process, with the input in it.
std::filesystem::path inputFile(std::string_view name, const std::uint8_t* data, std::size_t size);
std::filesystem::path inputFolder();

// The PNG with the checksums that its chunks should have, which chance does not hit.
std::vector<std::byte> withPngChecksums(std::span<const std::byte> png);

}  // namespace skydrop::fuzz
