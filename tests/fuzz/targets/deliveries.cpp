// The best deliveries of a player: what is left of a file are results, and they can be saved again.
#include "app/settings/best_results.h"
#include "fuzz/fuzz_input.h"

using namespace skydrop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::filesystem::path file = fuzz::inputFile("deliveries.json", data, size);
  fuzz::accepts("deliveries.json", [&] {
    app::BestResults best(file.parent_path());
    best.load();
    for (const app::BestResult& result : best.all())
      fuzz::require(result.points >= 1 && result.points <= 100000, "points are in their range");
    best.add({500, 12, 90, "fair"});
    best.save();
  });
  return 0;
}
