// Damaged copies of a file, the same ones in every run.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace skydrop::test {

// Hands out truncations (at most 24, evenly), and `rounds` copies with one kind of damage each: up to four
// bytes changed, a little-endian word set to a size that lies, a piece taken out or put in twice, a number in
// a text replaced.
void forEachMutant(const std::string& good, int rounds, const std::function<void(const std::string&)>& use);

// Writes a file without waiting for the disk, which thousands of mutants would; returns its whole name.
std::string writePlainly(const std::filesystem::path& file, const std::string& content);

}  // namespace skydrop::test
