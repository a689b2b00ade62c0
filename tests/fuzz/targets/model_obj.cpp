// Models: .obj.
#include "fuzz/model_input.h"

using namespace skydrop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::readModel(".obj", data, size);
  return 0;
}
