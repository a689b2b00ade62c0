// Models, with the files of tests/corpus/models beside them that they may name.
#pragma once

#include <string>

#include "fuzz/fuzz_input.h"

namespace skydrop::fuzz {

// Imports the bytes as a model with this ending and looks whether what is accepted is sound.
void readModel(const std::string& ending, const std::uint8_t* data, std::size_t size);

}  // namespace skydrop::fuzz
