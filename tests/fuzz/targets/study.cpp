// Studies.
#include "skydrop/accuracy/study.h"

#include "fuzz/fuzz_input.h"

using namespace skydrop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = fuzz::textOf(data, size);
  fuzz::accepts("a.json", [&] {
    const accuracy::Study study = accuracy::parseStudy(text, "a.json");
    fuzz::require(!study.points.empty() && study.points.size() <= accuracy::kMostPoints,
                  "a study has points");
    fuzz::require(!study.cases.empty() && study.cases.size() <= accuracy::kMostCases, "a study has cases");
  });
  return 0;
}
