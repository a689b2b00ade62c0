// Input logs: what is accepted comes back as it was written, and can be flown step by step.
#include "fuzz/fuzz_input.h"
#include "skydrop/game/input_log.h"

using namespace skydrop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = fuzz::textOf(data, size);
  fuzz::accepts("a.log", [&] {
    const game::InputLog log = game::decodeInputLog(text, "a.log");
    fuzz::require(log.stepCount() <= game::InputLog::kMaxSteps, "a log has an end");
    game::InputReplay replay(log);
    for (int step = 0; step < 1000 && !replay.finished(); ++step) {
      replay.hashDue();
      replay.changesDue();
      replay.next();
    }
    if (log.scene.text.empty()) return;  // schema 1 is read only
    fuzz::require(game::decodeInputLog(game::encodeInputLog(log), "a.log") == log, "a log comes back");
  });
  return 0;
}
