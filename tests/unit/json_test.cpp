#include "skydrop/core/json.h"

#include <gtest/gtest.h>

#include <string>

#include "skydrop/core/error.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace skydrop::core {
namespace {

using nlohmann::json;

std::string refusal(std::string_view text, const JsonLimits& limits = {}) {
  return test::refusalOf<DataError>([&] { parseJson(text, "a.json", limits); });
}

std::string nested(int depth, const char* open, const char* close) {
  std::string text;
  for (int i = 0; i < depth; ++i) text += open;
  text += "1";
  for (int i = 0; i < depth; ++i) text += close;
  return text;
}

TEST(Json, theTreeIsTheLibrarys) {
  // Every kind of value, at every kind of place: the same tree as the library's own reader makes.
  for (const char* text :
       {"7", "-7", "1.5e3", "18446744073709551615", "123456789012345678901234567890", "true", "null",
        "\"a\\u00e9\"", "[]", "{}", "[[], {}, [1, [2]], {\"a\": {\"b\": [null, false]}, \"c\": \"d\"}]",
        " \r\n\t[1] "}) {
    EXPECT_EQ(parseJson(text, "a.json"), json::parse(text)) << text;
    EXPECT_EQ(parseJson(text, "a.json").type(), json::parse(text).type()) << text;
  }
  EXPECT_EQ(parseJson("\xef\xbb\xbf[1]", "a.json"), json({1})) << "a byte order mark is skipped";
}

TEST(Json, depthIsBoundedBeforeAnythingIsBuilt) {
  // Destructors and dump() of deep trees recurse: 60 000 levels end in a segmentation fault.
  EXPECT_EQ(refusal(nested(32, "[", "]")), "");
  EXPECT_EQ(refusal(nested(33, "[", "]")), "a.json: line 1, column 33: nested deeper than 32 levels");
  EXPECT_EQ(refusal(nested(33, "{\"a\":", "}")), "a.json: line 1, column 161: nested deeper than 32 levels");
  EXPECT_EQ(refusal(nested(60000, "[", "]")), "a.json: line 1, column 33: nested deeper than 32 levels");
  EXPECT_EQ(refusal(std::string(500000, '[')), "a.json: line 1, column 33: nested deeper than 32 levels");
  EXPECT_EQ(refusal("[[1]]", {.depth = 1}), "a.json: line 1, column 2: nested deeper than 1 levels");
}

TEST(Json, sizeAndCountAreBounded) {
  EXPECT_EQ(refusal("[1, 2, 3]", {.bytes = 8}), "a.json: size: more than 8 bytes");
  EXPECT_EQ(refusal("[1, 2, 3]", {.values = 4}), "");
  EXPECT_EQ(refusal("[1, 2, 3, 4]", {.values = 4}), "a.json: line 1, column 12: more than 4 values");
  EXPECT_EQ(refusal("{\"a\": 1, \"b\": 2}", {.values = 4}), "a.json: line 1, column 16: more than 4 values");
}

TEST(Json, aNameThatIsDefinedTwiceIsRefused) {
  // Two readers may read such a file two ways. The same name in two objects is none of that.
  EXPECT_EQ(refusal("{\"a\": 1,\n \"b\": {\"a\": 2, \"c\": 3, \"a\": 2}}"),
            "a.json: line 2, column 26: 'a' is defined twice");
  EXPECT_EQ(refusal("{\"a\": 1, \"\\u0061\": 1}"), "a.json: line 1, column 17: 'a' is defined twice");
  EXPECT_EQ(refusal("[{\"a\": 1}, {\"a\": {\"a\": 1}}, {\"b\": {\"a\": 1}, \"a\": 1}]"), "");
}

TEST(Json, brokenTextsAreNamedWithLineAndColumn) {
  const auto begins = [](std::string_view text, const std::string& line) {
    const std::string said = refusal(text);
    EXPECT_TRUE(said.starts_with(line)) << said << "\nnot: " << line;
  };
  begins("", "a.json: line 1, column 1: is empty");
  begins(" \n ", "a.json: line 2, column 1: is empty");
  begins("{\n  \"a\": 1,\n}", "a.json: line 3, column 1: syntax error");
  begins("[1] [2]", "a.json: line 1, column 5: syntax error");
  begins("[1]x", "a.json: line 1, column 4: syntax error");
  begins("[1e999]", "a.json: line 1, column 7: number overflow parsing '1e999'");
  begins("[-1e999]", "a.json: line 1, column 8: number overflow parsing '-1e999'");
  begins("[NaN]", "a.json: line 1, column 2: syntax error");
  begins("[\"\xff\"]", "a.json: line 1, column 3: syntax error");
  begins("[\"\xed\xa0\x80\"]", "a.json: line 1, column ");
  begins("[\"\\ud800\"]", "a.json: line 1, column ");
  begins("[\"\x1b[2J\"]", "a.json: line 1, column 3: syntax error");
  begins("// a comment\n1", "a.json: line 1, column 1: syntax error");
  begins(std::string_view("\xff\xfe[\0]\0", 6), "a.json: line 1, column 1: is UTF-16");
  begins(std::string_view("[1]\0[2]", 7), "a.json: line 1, column 4: a zero byte");
  begins(std::string_view("\n[\"a\0b\"]", 8), "a.json: line 2, column 4: a zero byte");
}

TEST(Json, aFileIsReadWithItsLimits) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(readJson(folder.write("a.json", "{\"a\": 1}")), json({{"a", 1}}));
  const std::string large = folder.write("b.json", "[1, 2, 3]");
  EXPECT_EQ(test::refusalOf<DataError>([&] { readJson(large, {.bytes = 8}); }),
            large + ": too large: more than 8 bytes");
  EXPECT_THROW(readJson(folder.path() / "none.json"), DataError);
}

TEST(Json, valuesAreHeldToWhatTheyMustBe) {
  const auto number = [](const json& value) {
    return test::refusalOf<DataError>([&] { jsonNumber(value, "a.json", "speed", 0, 300); });
  };
  EXPECT_EQ(number(300), "");
  EXPECT_EQ(number("x"), "a.json: speed: \"x\" is not a number");
  EXPECT_EQ(number(300.5), "a.json: speed: 300.5 is out of range 0.0 to 300.0");
  EXPECT_EQ(test::refusalOf<DataError>([] { jsonWhole(1.5, "a.json", "seed", 0, 9); }),
            "a.json: seed: 1.5 is not a whole number");
  EXPECT_EQ(test::refusalOf<DataError>([] { jsonText(1.5, "a.json", "name"); }),
            "a.json: name: is not a text");
}

}  // namespace
}  // namespace skydrop::core
