// JSON of any file: what is accepted can be written and read again.
#include "skydrop/core/json.h"

#include "fuzz/fuzz_input.h"

using namespace skydrop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = fuzz::textOf(data, size);
  fuzz::accepts("a.json", [&] {
    const nlohmann::json value = core::parseJson(text, "a.json");
    fuzz::require(core::parseJson(value.dump(), "a.json") == value, "JSON comes back as it was written");
  });
  return 0;
}
