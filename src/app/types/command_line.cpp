#include "app/types/command_line.h"

#include <algorithm>

namespace skydrop::app {

bool sets(const CommandLine& line, std::string_view path) {
  return std::any_of(line.set.begin(), line.set.end(),
                     [&](const std::string& set) { return set.starts_with(std::string(path) + "="); });
}

}  // namespace skydrop::app
