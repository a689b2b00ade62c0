// Messages go to stderr, results to stdout. Any thread.
#pragma once

#include <string_view>

namespace skydrop::app {

// "skydrop: " and the text, as one printable line of bounded length (core/message.h).
void warn(std::string_view text);

}  // namespace skydrop::app
