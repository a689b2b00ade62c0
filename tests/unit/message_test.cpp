#include "skydrop/core/message.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "skydrop/core/error.h"

namespace skydrop::core {
namespace {

// Nothing that ends a line, commands a terminal or is not UTF-8.
bool isPrintableLine(std::string_view text) {
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) return false;
  }
  return printable(text, text.size()) == text;
}

TEST(Message, everyHiddenByteIsShown) {
  // Controls, a zero byte, DEL, C1, direction overrides, zero-width characters, broken UTF-8; the rest stays.
  const std::string hidden("\n\r\t\x1b[2J\0\x7f|", 10);
  EXPECT_EQ(printable(hidden), "\\n\\r\\t\\x1b[2J\\x00\\x7f|");
  EXPECT_EQ(printable("a\u0085b\u202ec\u2066d\u200be\u2028f\ufeffg\u061ch"),
            "a\\u0085b\\u202ec\\u2066d\\u200be\\u2028f\\ufeffg\\u061ch");
  EXPECT_EQ(printable("\xff|\xc3|\xc0\x80|\xed\xa0\x80|\xf4\x90\x80\x80|\x9b"),
            "\\xff|\\xc3|\\xc0\\x80|\\xed\\xa0\\x80|\\xf4\\x90\\x80\\x80|\\x9b");
  EXPECT_EQ(printable("\U000e0041"), "\\U000e0041");
  const std::string plain = "C:\\new.json 'Höhe' 高度 ✈ 🛩";
  EXPECT_EQ(printable(plain), plain);
  EXPECT_EQ(printable(""), "");
}

TEST(Message, longTextsKeepBothEnds) {
  // Bounded whatever comes in; a text that fits is whole; a cut never falls into a character or an escape.
  const std::string text = "begin" + std::string(100000, 'x') + "end";
  const std::string line = printable(text);
  EXPECT_LE(line.size(), kLongestMessage);
  EXPECT_TRUE(line.starts_with("beginx")) << line;
  EXPECT_TRUE(line.ends_with("xend")) << line;
  EXPECT_NE(line.find("x...x"), std::string::npos);
  EXPECT_EQ(printable(std::string(kLongestMessage, 'y')), std::string(kLongestMessage, 'y'));
  for (std::size_t most = 0; most < 40; ++most) {
    for (const char* unit : {"é", "飛", "\x1b", "\u202e", "\xff"}) {
      std::string many;
      for (int i = 0; i < 50; ++i) many += unit;
      const std::string cut = printable(many, most);
      EXPECT_LE(cut.size(), std::max<std::size_t>(most, 3));
      EXPECT_TRUE(isPrintableLine(cut)) << cut;
    }
  }
}

TEST(Message, whatIsOneLineAlreadyStaysAsItIs) {
  // Errors are wrapped into others and printed at last: the second pass changes nothing.
  std::mt19937 random(9);
  for (int round = 0; round < 2000; ++round) {
    std::string text(random() % 3000, ' ');
    for (char& c : text) c = static_cast<char>(random() % 3 ? random() % 256 : 'a' + random() % 26);
    const std::string once = printable(text);
    EXPECT_TRUE(isPrintableLine(once)) << once;
    EXPECT_LE(once.size(), kLongestMessage);
    EXPECT_EQ(printable(once), once);
  }
}

TEST(Message, theLineNamesFilePlaceAndReason) {
  EXPECT_EQ(messageLine("a.json", "seed", "is negative"), "a.json: seed: is negative");
  EXPECT_EQ(messageLine("a.json", "", "is empty"), "a.json: is empty");
  EXPECT_EQ(messageLine("", "scene", "is missing"), "(no name): scene: is missing");
  EXPECT_EQ(messageLine("a\nb", "c\x1b", "d\n\n"), "a\\nb: c\\x1b: d");
  const std::string all(100000, 'z');
  EXPECT_LE(messageLine(all, all, all).size(), kLongestMessage);
}

TEST(Message, everyErrorSaysOneLine) {
  // Whoever throws needs not think of it.
  const std::string bad = "x\ny" + std::string(1, '\0') + "z" + std::string(5000, 'w');
  for (const std::string& line :
       {std::string(DataError(bad, bad, bad).what()), std::string(UsageError(bad).what()),
        std::string(RangeError(bad).what()), std::string(GraphicsUnavailable(bad).what())}) {
    EXPECT_TRUE(isPrintableLine(line)) << line;
    EXPECT_LE(line.size(), kLongestMessage);
    EXPECT_NE(line.find("x\\ny\\x00z"), std::string::npos) << line;
  }
}

}  // namespace
}  // namespace skydrop::core
