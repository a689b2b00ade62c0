#include "skydrop/core/flag_text.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace skydrop::core {
namespace {

enum class Mode { first, second };
constexpr std::string_view kModeNames[] = {"first", "second one"};  // a name that the shell would split

struct Sample {
  double length = 2.5, tiny = 1e-9, signedZero = 0;
  std::int64_t count = 4;
  bool on = true;
  Mode mode = Mode::first;
};
void describe(SettingsVisitor& visitor, Sample& sample) {
  visitor.number("length", sample.length, {"m", -1e300, 1e300, "A length."});
  visitor.number("tiny", sample.tiny, {"m", 0, 1, "A tiny length."});
  visitor.number("signedZero", sample.signedZero, {"m", -1, 1, "A number around zero."});
  visitor.integer("count", sample.count, {"1", 0, 9007199254740992, "A count."});
  visitor.flag("on", sample.on, {"A switch."});
  visitor.choice("mode", sample.mode, kModeNames, {"A choice."});
}

// The words that a POSIX shell makes of `text`.
std::vector<std::string> shellWords(const std::string& text) {
  const std::string command = "printf '%s\\000' " + text;
  FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) return {};
  std::vector<std::string> words;
  std::string word;
  for (int c; (c = std::fgetc(pipe)) != EOF;) {
    if (c != 0) {
      word += static_cast<char>(c);
    } else {
      words.push_back(std::exchange(word, {}));
    }
  }
  pclose(pipe);
  return words;
}

std::string flagsOver(const SettingsTable& table, const SettingsTable& base) {
  const SettingsTable* const bases[] = {&base};
  return setFlags(table, bases);
}

TEST(FlagText, theFlagsGiveTheSameBitsBackThroughAShell) {
  // Over random bit patterns: every field of the table that the flags build from the base equals the
  // original.
  std::mt19937_64 random(7);
  Sample base;
  const SettingsTable baseTable(base);
  for (int round = 0; round < 50; ++round) {
    Sample sample;
    sample.length = std::bit_cast<double>(random() & 0xbfffffffffffffffu);  // finite, below 2
    sample.tiny = std::ldexp(static_cast<double>(random()), -64);
    sample.signedZero = round % 2 == 0 ? -0.0 : 0.1 + 0.2;
    sample.count = static_cast<std::int64_t>(random() >> 11);
    sample.on = round % 3 != 0;
    sample.mode = round % 2 == 0 ? Mode::second : Mode::first;
    const SettingsTable table(sample);
    const std::vector<std::string> words = shellWords(flagsOver(table, baseTable));

    Sample back;
    const SettingsTable backTable(back);
    ASSERT_EQ(words.size() % 2, 0u);
    for (std::size_t i = 0; i < words.size(); i += 2) {
      EXPECT_EQ(words[i], "--set");
      setField(backTable, words[i + 1]);
    }
    for (std::size_t i = 0; i < table.fields().size(); ++i) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(backTable.fields()[i].get()),
                std::bit_cast<std::uint64_t>(table.fields()[i].get()))
          << table.fields()[i].path << " in round " << round;
    }
  }
}

TEST(FlagText, onlyWhatDiffersFromTheBaseIsNamed) {
  // The base is what the program starts from without flags, not the default.
  Sample base{.count = 9}, sample{.length = 0.1, .count = 9};
  EXPECT_EQ(flagsOver(SettingsTable(sample), SettingsTable(base)), "--set length=0.1");
  EXPECT_EQ(flagsOver(SettingsTable(base), SettingsTable(base)), "");
  sample.count = 4;
  sample.mode = Mode::second;
  EXPECT_EQ(flagsOver(SettingsTable(sample), SettingsTable(base)),
            "--set length=0.1 --set count=4 --set 'mode=second one'");
}

TEST(FlagText, theFlagsLeadFromEveryBaseToTheSameTable) {
  Sample one{.length = 1}, two{.length = 2, .count = 9}, sample{.length = 2};
  const SettingsTable oneTable(one), twoTable(two), table(sample);
  const SettingsTable* const bases[] = {&oneTable, &twoTable};
  EXPECT_EQ(setFlags(table, bases), "--set length=2 --set count=4");
}

TEST(FlagText, theShellReadsEveryQuotedWordAsItIs) {
  // Spaces, quotes, signs that expand, line ends and no characters at all.
  for (const std::string word : {"", "a b", "it's", "$HOME `id` \\ \" * ? ~ ! # & ; | < > ( ) { } [ ]",
                                 "line\nline", "''", "~", "\xc3\xa4"}) {
    EXPECT_EQ(shellWords(shellQuoted(word)), std::vector<std::string>{word}) << shellQuoted(word);
  }
  EXPECT_EQ(shellQuoted("streaming.pixelError=1e-05"), "streaming.pixelError=1e-05")
      << "plain words stay plain";
}

}  // namespace
}  // namespace skydrop::core
