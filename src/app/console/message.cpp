#include "app/console/message.h"

#include <cstdio>
#include <string>

#include "skydrop/core/message.h"

namespace skydrop::app {

void warn(std::string_view text) {
  const std::string line = "skydrop: " + core::printable(text) + "\n";
  std::fwrite(line.data(), 1, line.size(), stderr);
}

}  // namespace skydrop::app
