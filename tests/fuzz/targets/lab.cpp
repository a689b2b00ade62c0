// Pages of the laboratory: the page's name, then its knobs, a line each.
#include <cmath>

#include "fuzz/fuzz_input.h"
#include "skydrop/lab/page.h"

using namespace skydrop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<std::string> lines = fuzz::linesOf(data, size);
  if (lines.empty()) return 0;
  fuzz::accepts("", [&] {
    const lab::Page& page = lab::pageNamed(lines.front());
    const std::unique_ptr<lab::Knobs> knobs = page.makeKnobs();
    for (std::size_t i = 1; i < lines.size(); ++i) core::setField(knobs->table(), lines[i]);
    if (!page.plot) return;
    for (const lab::Curve& curve : page.plot(*knobs)) {
      for (const float value : curve) fuzz::require(std::isfinite(value), "a curve is finite");
    }
  });
  return 0;
}
