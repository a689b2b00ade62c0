#include "skydrop/game/input_log.h"

#include <gtest/gtest.h>

#include <string>

#include "skydrop/core/error.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace skydrop::game {
namespace {

InputLog example() {
  InputLog log;
  log.program = "skydrop 0.1.0";
  log.scene = {"/some where/canyon \"quoted\"\n.json", "{\n  \"schema\": 1\n}\n"};
  log.seed = 0xffffffffffffffffull;
  log.settings = {{"aircraft.rollFactor", "0.8"}, {"aircraft.integrator", "rkmk4"}};
  log.appendCheckpoint(1);
  for (int i = 0; i < 100; ++i) log.append({.thrust = 1});
  log.appendChange({"aircraft.maxThrottle", "250"});
  for (int i = 0; i < 50; ++i) log.append({.pitch = -1, .roll = 0.5, .drop = i == 3});
  log.appendCheckpoint(0xfedcba9876543210ull);
  log.append({.reset = true});
  log.appendCheckpoint(0x0123456789abcdefull);
  log.ended = true;
  return log;
}

// A log of schema 1, as older versions wrote it.
constexpr const char* kSchema1 = R"({
"schema": 1,
"kind": "skydrop input log",
"program": "skydrop 0.1.0",
"scene": "terrain",
"seed": 18446744073709551615,
"finalHash": "0123456789abcdef",
"settings": [
["aircraft.rollFactor","0.8"],
["aircraft.integrator","rkmk4"]],
"changes": [
[100,"aircraft.maxThrottle","250"]],
"runs": [
[100,127,0,0,0,0,0],
[3,0,0,-127,64,0,0],
[1,0,0,-127,64,0,1],
[46,0,0,-127,64,0,0],
[1,0,0,0,0,0,2]]
}
)";

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
  // Header, scene, settings, changes, checkpoints and every step, through text and through a file.
  const InputLog log = example();
  EXPECT_EQ(decodeInputLog(encodeInputLog(log), "memory"), log);
  const test::TemporaryFolder folder;
  EXPECT_EQ(readInputLog(folder.write("flight.log", encodeInputLog(log))), log);
}

TEST(InputLog, logsOfSchema1AreStillRead) {
  // The scene by name, the final hash as the one checkpoint, and the same steps and changes.
  const InputLog log = decodeInputLog(kSchema1, "old.log"), same = example();
  EXPECT_EQ(log.scene, (InputLog::SceneRecord{"terrain", ""}));
  EXPECT_EQ(log.checkpoints, (std::vector<InputLog::Checkpoint>{{151, 0x0123456789abcdefull}}));
  EXPECT_TRUE(log.ended);
  EXPECT_EQ(log.runs, same.runs);
  EXPECT_EQ(log.changes, same.changes);
  EXPECT_EQ(log.settings, same.settings);
  EXPECT_EQ(log.seed, same.seed);
  const InputLog open =
      decodeInputLog(replaced(kSchema1, "\"finalHash\": \"0123456789abcdef\",\n", ""), "old.log");
  EXPECT_TRUE(open.checkpoints.empty());
  EXPECT_FALSE(open.ended);
}

TEST(InputLog, whatIsWrittenPieceByPieceIsTheWholeLog) {
  // Taken after every step, the pieces are rows of their own, and read as the same log as when taken at once.
  const InputLog log = example();
  InputLogWriter writer(log);
  std::string text;
  InputReplay replay(log);
  std::uint64_t step = 0;
  while (true) {
    const auto hash = replay.hashDue();
    if (hash && replay.finished()) writer.end(*hash);
    if (hash && !replay.finished()) writer.checkpoint(*hash);
    text += writer.take();
    if (replay.finished()) break;
    for (const SettingOverride& change : replay.changesDue()) writer.change(change);
    writer.append(quantise(replay.next()), 1);
    EXPECT_EQ(writer.stepCount(), ++step);
  }
  EXPECT_GT(text.size(), encodeInputLog(log).size());
  EXPECT_EQ(decodeInputLog(text, "memory"), log);
}

TEST(InputLog, ofSeveralChangesBeforeOneStepTheLastOfEachPathIsKept) {
  // A slider dragged while the game is paused changes a setting many times between two steps.
  InputLogWriter writer(example());
  for (int i = 0; i < 1000; ++i) {
    writer.change({"aircraft.rollFactor", std::to_string(i)});
    writer.change({"aircraft.pitchSpeed", std::to_string(2 * i)});
  }
  writer.append({}, 1);
  const InputLog log = decodeInputLog(writer.take(), "memory");
  EXPECT_EQ(log.changes, (std::vector<InputLog::Change>{{0, {"aircraft.rollFactor", "999"}},
                                                        {0, {"aircraft.pitchSpeed", "1998"}}}));
}

TEST(InputLog, equalStepsAreOneRun) {
  // A key held for 100 steps is one entry; an hour of nothing, written and checked once a second, is under
  // 200 kB, and comes back as one run.
  const InputLog log = example();
  EXPECT_EQ(log.runs.size(), 5u);
  EXPECT_EQ(log.stepCount(), 151u);
  InputLogWriter idle{InputLog{}};
  std::string text;
  for (int i = 0; i < 432000; ++i) {
    idle.append({}, 1);
    if (i % 120 == 119) idle.checkpoint(0xffffffffffffffffull), text += idle.take();
  }
  EXPECT_LT(text.size(), 200000u);
  EXPECT_EQ(decodeInputLog(text, "memory").runs.size(), 1u);
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

TEST(InputLog, everyTruncationIsTheLogUpToThere) {
  // Cut anywhere behind its header, a log is valid and holds what its whole lines hold: the steps, changes
  // and checkpoints of the uncut log up to there. Cut within the header it is refused in one line.
  const InputLog log = example();
  const std::string text = encodeInputLog(log);
  const std::size_t header = text.find('\n') + 1;
  std::size_t shorter = 0;
  for (std::size_t length = 0; length < text.size(); ++length) {
    const std::string cut = text.substr(0, length);
    if (length < header) {
      const std::string line = refusal(cut);
      ASSERT_NE(line.find("flight.json: line 1"), std::string::npos) << length << ": " << line;
      ASSERT_EQ(line.find('\n'), std::string::npos);
      continue;
    }
    const InputLog prefix = decodeInputLog(cut, "flight.json");
    ASSERT_FALSE(prefix.ended);
    ASSERT_LE(prefix.runs.size(), log.runs.size());
    for (std::size_t i = 0; i < prefix.runs.size(); ++i) ASSERT_EQ(prefix.runs[i], log.runs[i]) << length;
    for (std::size_t i = 0; i < prefix.changes.size(); ++i) ASSERT_EQ(prefix.changes[i], log.changes[i]);
    for (std::size_t i = 0; i < prefix.checkpoints.size(); ++i)
      ASSERT_EQ(prefix.checkpoints[i], log.checkpoints[i]);
    shorter += prefix.stepCount() < log.stepCount() ? 1 : 0;
  }
  EXPECT_GT(shorter, 0u);
  for (std::size_t length = 0; length + 2 < std::string(kSchema1).size(); ++length)
    ASSERT_NE(refusal(std::string(kSchema1).substr(0, length)).find("flight.json: line"), std::string::npos)
        << length;
}

TEST(InputLog, everyDamagedByteIsRefusedOrReadAsAnotherWholeLog) {
  // Each byte replaced by each of a few: either an error with a place, or a log that encodes and decodes to
  // itself.
  for (const std::string& text : {encodeInputLog(example()), std::string(kSchema1)}) {
    for (std::size_t at = 0; at < text.size(); ++at) {
      for (const char c : {'\0', '\n', '"', '[', ']', '{', '9', '-', ',', '\xff'}) {
        std::string damaged = text;
        damaged[at] = c;
        try {
          const InputLog log = decodeInputLog(damaged, "flight.json");
          const InputLog again = decodeInputLog(encodeInputLog(log), "again");
          ASSERT_EQ(again.runs, log.runs);
          ASSERT_EQ(again.checkpoints, log.checkpoints);
        } catch (const core::DataError& error) {
          ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        }
      }
    }
  }
}

TEST(InputLog, wrongValuesAreNamedWithTheirPlace) {
  // What is well-formed JSON and still no log: place and reason stand in the line.
  const std::string text = encodeInputLog(example());
  const auto expect = [](const std::string& bad, const std::string& place, const std::string& reason) {
    const std::string line = refusal(bad);
    EXPECT_NE(line.find(place), std::string::npos) << line;
    EXPECT_NE(line.find(reason), std::string::npos) << line;
  };
  expect(replaced(text, "\"schema\":2", "\"schema\":3"), "schema", "schemas 1 and 2");
  expect(replaced(text, "\"seed\":18446744073709551615", "\"seed\":-1"), "seed", "negative");
  expect(replaced(text, "\"seed\":18446744073709551615", "\"seed\":1.5"), "seed", "not whole");
  expect(replaced(text, "\"seed\":18446744073709551615,", ""), "seed", "missing");
  expect(replaced(text, "input log", "score table"), "kind", "skydrop input log");
  expect(replaced(text, "\"seed\"", "\"speed\""), "speed", "not a member");
  expect(replaced(text, "\"seed\"", "\"scene.text\""), "scene.text", "not a member");
  expect(replaced(text, "\"seed\"", "\"kind\""), "kind", "twice");
  expect(replaced(text, "\"source\"", "\"text\""), "text", "twice");
  expect(replaced(text, "\"source\"", "\"file\""), "scene.file", "not a member");
  expect(replaced(text, "\"scene\":{", "\"scene\":{\"digest\":{"), "scene.digest", "object");
  expect(replaced(text, "schema\\\": 1", "schema\\\": 2"), "scene.digest", "is not that of");
  expect(replaced(text, "\"digest\":\"", "\"digest\":\"x"), "scene.digest", "hexadecimal");
  expect(replaced(text, "[[\"aircraft", "[[1,\"aircraft"), "settings[0][0]", "number");
  expect(replaced(text, "[[\"aircraft", "[[[\"aircraft"), "settings[0][0]", "array");
  expect(replaced(text, "[[\"aircraft", "[[\"a\",\"aircraft"), "settings[0][2]", "text");
  expect(replaced(text, "[[\"aircraft", "[\"a\",[\"aircraft"), "settings[0]", "text");
  expect(replaced(text, "[100,127", "[100,128"), "line 3[1]", "128");
  expect(replaced(text, "[100,127", "[100,-1"), "line 3[1]", "-1");
  expect(replaced(text, "[100,127", "[0,127"), "line 3[0]", "outside");
  expect(replaced(text, "[100,127", "[-5,127"), "line 3[0]", "outside");
  expect(replaced(text, "[100,127", "[99999999999999999999999,127"), "line 3", "not whole");
  expect(replaced(text, "[100,127", "[18446744073709551615,127"), "line 3[0]", "outside");
  expect(replaced(text, "[100,127,", "[100,127,1,"), "line 3", "number");
  expect(replaced(text, "[100,127,", "[100,"), "line 3", "entries");
  expect(replaced(text, "[100,127,", "[100,null,"), "line 3", "null");
  expect(replaced(text, "[100,127,", "[100,[127],"), "line 3", "array");
  expect(replaced(text, "[100,127,", "{\"a\":[100,127,"), "line 3", "object");
  expect(replaced(text, "[100,127,0,0,0,0,0]", "[100]"), "line 3", "no row has named");
  expect(replaced(text, "[100,127,0,0,0,0,0]", ""), "line 3", "empty");
  expect(replaced(text, "[100,127,0,0,0,0,0]", "100"), "line 3", "number");
  expect(replaced(text, "\"check\",0", "\"check\",-1"), "line 2", "negative");
  expect(replaced(text, "\"check\",0", "\"check\",150"), "line 8", "ascend");
  expect(replaced(text, "\"check\",150", "\"check\",152"), "line", "ascend");
  expect(replaced(text, "\"check\",0", "\"wreck\",0"), "line 2", "no record");
  expect(replaced(text, "\"end\",151", "\"end\",152"), "line", "behind the last step");
  expect(replaced(text, "0123456789abcdef", "0123456789abcdefg"), "line", "hexadecimal");
  expect(text + "[1]\n", "line", "after the end");
  expect("[]", "top", "array");
  expect("7", "top", "number");
  expect(std::string(100000, '['), "top", "array");
  const std::string head = text.substr(0, text.find('\n') + 1);
  expect(head + std::string(100000, '[') + "\n", "line 2", "array");
  expect(replaced(text, "\"settings\":", "\"settings\":" + std::string(100000, '[')), "settings", "array");
  expect(replaced(text, "aircraft.rollFactor", std::string(5000, 'x')), "settings[0]", "4096");
  expect(replaced(text, "{\\n", std::string((1 << 20) + 1, 'x')), "scene.text", "1048576");

  const auto expect1 = [&](const std::string& what, const std::string& with, const std::string& place,
                           const std::string& reason) {
    expect(replaced(kSchema1, what, with), place, reason);
  };
  expect1("\"schema\": 1", "\"schema\": 7", "schema", "schemas 1 and 2");
  expect1("\"schema\": 1,", "", "schema", "missing");
  expect1("\"seed\"", "\"scene\": \"twice\", \"seed\"", "scene", "twice");
  expect1("[100,127", "[100,128", "runs[0][1]", "128");
  expect1("[100,127", "[-5,127", "runs[0][0]", "negative");
  expect1("[100,127,", "[100,", "runs[0]", "entries");
  expect1("[100,\"aircraft", "[900,\"aircraft", "changes", "behind the last step");
  expect1("0123456789abcdef", "0123456789abcdefg", "finalHash", "hexadecimal");
}

TEST(InputLog, aFileThatClaimsMoreThanADayIsRefusedAndNoneIsWritten) {
  // Two runs that together are longer than the limit: refused by the sum, without a loop over it; the writer
  // says so before it gets there.
  InputLog log = example();
  log.checkpoints.clear();
  log.ended = false;
  log.append({.brake = 127}, InputLog::kMaxSteps - 10);
  EXPECT_NE(refusal(encodeInputLog(log)).find("outside"), std::string::npos);
  InputLogWriter writer{InputLog{}};
  writer.append({}, InputLog::kMaxSteps - 1);
  EXPECT_FALSE(writer.isFull());
  writer.append({}, 1);
  EXPECT_TRUE(writer.isFull());
  EXPECT_EQ(decodeInputLog(writer.take(), "memory").stepCount(), InputLog::kMaxSteps);
}

TEST(InputLog, aMissingFileIsAnErrorThatNamesIt) {
  // Reading what is not there is bad data, not an empty flight.
  EXPECT_THROW(readInputLog("/nonexistent/flight.json"), core::DataError);
}

}  // namespace
}  // namespace skydrop::game
