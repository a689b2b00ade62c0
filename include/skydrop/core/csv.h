#pragma once

#include <string>

namespace skydrop::core {

// A field of RFC 4180: in quotes where it needs them.
std::string csvField(const std::string& text);

}  // namespace skydrop::core
