// Models: .gltf.
#include "fuzz/model_input.h"

using namespace skydrop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::readModel(".gltf", data, size);
  return 0;
}
