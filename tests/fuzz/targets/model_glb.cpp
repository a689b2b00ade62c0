// Models: .glb.
#include "fuzz/model_input.h"

using namespace skydrop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::readModel(".glb", data, size);
  return 0;
}
