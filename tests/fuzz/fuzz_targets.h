// The targets of fuzz_replay by their names in targets.txt; CMake writes the list.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace skydrop::fuzz {

struct Target {
  std::string_view name;
  int (*run)(const std::uint8_t* data, std::size_t size);
};

std::span<const Target> targets();

}  // namespace skydrop::fuzz
