// Elevation files, which are recognised by ending and content.
#pragma once

#include <string>

#include "fuzz/fuzz_input.h"

namespace skydrop::fuzz {

// Opens the bytes under this name, looks at every cell as land would, and at its place on the earth.
void readElevation(const std::string& name, const std::uint8_t* data, std::size_t size);

}  // namespace skydrop::fuzz
