#include "skydrop/game/input_log.h"

#include <gtest/gtest.h>

#include <string>

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace skydrop::game {
namespace {

InputLog example() {
  InputLog log;
  log.program = "skydrop 0.1.0";
  log.scene = "terrain \"quoted\"\n";
  log.seed = 0xffffffffffffffffull;
  log.settings = {{"aircraft.rollFactor", "0.8"}, {"aircraft.integrator", "rkmk4"}};
  for (int i = 0; i < 100; ++i) log.append({.thrust = 1});
  log.appendChange({"aircraft.maxThrottle", "250"});
  for (int i = 0; i < 50; ++i) log.append({.pitch = -1, .roll = 0.5, .drop = i == 3});
  log.append({.reset = true});
  log.finalHash = 0x0123456789abcdefull;
  return log;
}

// The line that a log is refused with; empty when it is accepted.
std::string refusal(const std::string& text) {
  return test::refusalOf<core::DataError>([&] { decodeInputLog(text, "flight.json"); });
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

TEST(InputLog, everythingComesBackFromTheFile) {
  // Header, settings, changes and every step, through text and through a file.
  const InputLog log = example();
  EXPECT_EQ(decodeInputLog(encodeInputLog(log), "memory"), log);
  const test::TemporaryFolder folder;
  writeInputLog(folder.path() / "flight.json", log);
  EXPECT_EQ(readInputLog(folder.path() / "flight.json"), log);
}

TEST(InputLog, equalStepsAreOneRun) {
  // A key held for 100 steps is one entry, and an hour of nothing is a short file.
  const InputLog log = example();
  EXPECT_EQ(log.runs.size(), 5u);
  EXPECT_EQ(log.stepCount(), 151u);
  InputLog idle;
  for (int i = 0; i < 432000; ++i) idle.append({});
  EXPECT_LT(encodeInputLog(idle).size(), 300u);
}

TEST(InputLog, replayHandsOutEveryStepAndEachChangeOnceBeforeItsStep) {
  // The steps in order, the change before step 100, neutral controls after the end.
  const InputLog log = example();
  InputReplay replay(log);
  for (int i = 0; i < 151; ++i) {
    ASSERT_FALSE(replay.finished());
    EXPECT_EQ(replay.changesDue().size(), i == 100 ? 1u : 0u) << i;
    const Controls c = replay.next();
    EXPECT_EQ(c.thrust, i < 100 ? 1 : 0);
    EXPECT_EQ(c.drop, i == 103);
    EXPECT_EQ(c.reset, i == 150);
  }
  EXPECT_TRUE(replay.finished());
  EXPECT_EQ(replay.next(), Controls{});
}

TEST(InputLog, everyTruncationIsRefusedWithFileAndPlace) {
  // Cut anywhere, the file is refused in one line that names it and the place; never accepted, never a crash.
  const std::string text = encodeInputLog(example());
  for (std::size_t length = 0; length + 2 < text.size(); ++length) {
    const std::string line = refusal(text.substr(0, length));
    ASSERT_NE(line.find("flight.json"), std::string::npos) << length;
    ASSERT_NE(line.find("line "), std::string::npos) << line;
    ASSERT_EQ(line.find('\n'), std::string::npos);
  }
}

TEST(InputLog, everyDamagedByteIsRefusedOrReadAsAnotherWholeLog) {
  // Each byte replaced by each of a few: either an error with a place, or a log that encodes and decodes to
  // itself.
  const std::string text = encodeInputLog(example());
  for (std::size_t at = 0; at < text.size(); ++at) {
    for (const char c : {'\0', '"', '[', ']', '{', '9', '-', ',', '\xff'}) {
      std::string damaged = text;
      damaged[at] = c;
      try {
        const InputLog log = decodeInputLog(damaged, "flight.json");
        ASSERT_EQ(decodeInputLog(encodeInputLog(log), "again"), log);
      } catch (const core::DataError&) {
      }
    }
  }
}

TEST(InputLog, wrongValuesAreNamedWithTheirPlace) {
  // What is well-formed JSON and still no log of this schema: place and reason stand in the line.
  const std::string text = encodeInputLog(example());
  const auto expect = [](const std::string& bad, const std::string& place, const std::string& reason) {
    const std::string line = refusal(bad);
    EXPECT_NE(line.find(place), std::string::npos) << line;
    EXPECT_NE(line.find(reason), std::string::npos) << line;
  };
  expect(replaced(text, "\"schema\": 1", "\"schema\": 2"), "schema", "only schema 1");
  expect(replaced(text, "\"schema\": 1,", ""), "schema", "missing");
  expect(replaced(text, "input log", "score table"), "kind", "skydrop input log");
  expect(replaced(text, "\"seed\": 18446744073709551615", "\"seed\": -1"), "seed", "negative");
  expect(replaced(text, "\"seed\": 18446744073709551615", "\"seed\": 1.5"), "seed", "not whole");
  expect(replaced(text, "\"seed\"", "\"speed\""), "speed", "not a member");
  expect(replaced(text, "\"seed\"", "\"scene\": \"twice\", \"seed\""), "scene", "twice");
  expect(replaced(text, "[100,127", "[100,128"), "runs[0][1]", "128");
  expect(replaced(text, "[100,127", "[100,-1"), "runs[0][1]", "-1");
  expect(replaced(text, "[100,127", "[0,127"), "runs[0][0]", "outside");
  expect(replaced(text, "[100,127", "[-5,127"), "runs[0][0]", "negative");
  expect(replaced(text, "[100,127", "[99999999999999999999999,127"), "runs[0][0]", "not whole");
  expect(replaced(text, "[100,127", "[18446744073709551615,127"), "runs[0][0]", "outside");
  expect(replaced(text, "[100,127,", "[100,127,1,"), "runs[0][7]", "number");
  expect(replaced(text, "[100,127,", "[100,"), "runs[0]", "entries");
  expect(replaced(text, "[100,127,", "[100,null,"), "runs[0][1]", "null");
  expect(replaced(text, "[100,\"aircraft", "[900,\"aircraft"), "changes", "behind the last step");
  expect(replaced(text, "0123456789abcdef", "0123456789abcdefg"), "finalHash", "hexadecimal");
  expect("[]", "top", "array");
  expect("7", "top", "number");
  expect("{\"runs\": {}}", "runs", "object");
  expect(std::string(100000, '['), "top", "array");
  expect("{\"scene\": \"" + std::string(5000, 'x') + "\"}", "scene", "4096");
}

TEST(InputLog, aFileThatClaimsMoreThanADayIsRefused) {
  // Two runs that together are longer than the limit: refused by the sum, without a loop over it.
  InputLog log = example();
  log.runs.push_back({InputLog::kMaxSteps - 10, {}});
  EXPECT_NE(refusal(encodeInputLog(log)).find("outside"), std::string::npos);
}

TEST(InputLog, aMissingFileIsAnErrorThatNamesIt) {
  // Reading what is not there is bad data, not an empty flight.
  EXPECT_THROW(readInputLog("/nonexistent/flight.json"), core::DataError);
}

}  // namespace
}  // namespace skydrop::game
