// Results of studies, of a run that goes on or of several that are merged.
#include "fuzz/fuzz_input.h"
#include "skydrop/accuracy/result_file.h"

using namespace skydrop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = fuzz::textOf(data, size);
  fuzz::accepts("a.jsonl", [&] {
    bool cutOff = false;
    const std::string written = accuracy::resultText(accuracy::parseResults(text, "a.jsonl", &cutOff));
    fuzz::require(accuracy::resultText(accuracy::parseResults(written, "a.jsonl", &cutOff)) == written,
                  "results come back as they were written");
  });
  return 0;
}
