// Weather files, which are recognised by their content.
#pragma once

#include "fuzz/fuzz_input.h"

namespace skydrop::fuzz {

// Reads the bytes as a weather file and looks whether what is accepted can be flown in.
void readWeather(const std::uint8_t* data, std::size_t size);

}  // namespace skydrop::fuzz
