#include "skydrop/core/settings_table.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "skydrop/core/error.h"
#include "support/refusal.h"

namespace skydrop::core {
namespace {

enum class Mode { first, second, third };
constexpr std::array<std::string_view, 3> kModeNames = {"first", "second", "third"};

struct Layer {
  double base = 100;
};
void describe(SettingsVisitor& visitor, Layer& layer) {
  visitor.number("base", layer.base, {"m", 0, 20000, "Height of the base."});
}

struct Sample {
  double length = 2.5;
  std::int64_t count = 4;
  bool on = true;
  Mode mode = Mode::second;
  std::array<Layer, 2> layers;
};
void describe(SettingsVisitor& visitor, Sample& sample) {
  visitor.number("length", sample.length, {"m", 0.1, 10, "A length."});
  visitor.integer("count", sample.count, {"1", 0, 100, "A count."});
  visitor.flag("on", sample.on, {"A switch."});
  visitor.choice("mode", sample.mode, kModeNames, {"A choice."});
  visitor.group("layers", sample.layers, "The layers.");
}

// A number that is written as hours and minutes.
struct Meeting {
  std::int64_t minutes = 90;
};
constexpr WrittenForm kClock = {
    .write =
        [](double value) {
          const int minutes = static_cast<int>(value);
          return std::to_string(minutes / 60) + "h" + std::to_string(minutes % 60);
        },
    .read =
        [](std::string_view text, double& value) {
          const std::size_t h = text.find('h');
          if (h == std::string_view::npos) return std::string("is not such as 1h30");
          value = std::stoi(std::string(text.substr(0, h))) * 60 + std::stoi(std::string(text.substr(h + 1)));
          return std::string();
        }};
void describe(SettingsVisitor& visitor, Meeting& meeting) {
  visitor.integer("minutes", meeting.minutes,
                  {.unit = "1", .min = 0, .max = 600, .help = "When it begins.", .written = &kClock});
}

TEST(SettingsTable, aFieldWithAFormOfItsOwnIsReadAndWrittenInIt) {
  // By --set, in files and in refusals alike; in JSON it is a text, and a bare number is none.
  Meeting meeting;
  const SettingsTable table(meeting);
  setField(table, "minutes=2h5");
  EXPECT_EQ(meeting.minutes, 125);
  EXPECT_EQ(fieldText(table.at("minutes")), "2h5");
  EXPECT_EQ(toJson(table).dump(), R"({"minutes":"2h5"})");
  applyJson(table, nlohmann::json::parse(R"({"minutes": "3h0"})"), "a.json");
  EXPECT_EQ(meeting.minutes, 180);
  EXPECT_EQ(test::refusalOf<RangeError>([&] { setField(table, "minutes=180"); }),
            "minutes: '180' is not such as 1h30");
  EXPECT_EQ(test::refusalOf<RangeError>([&] { setField(table, "minutes=11h0"); }),
            "minutes: '11h0' is out of range 0h0 to 10h0");
  const auto json = [&](const char* text) {
    return test::refusalOf<DataError>([&] { applyJson(table, nlohmann::json::parse(text), "a.json"); });
  };
  EXPECT_EQ(json(R"({"minutes": 180})"), "a.json: minutes: 180 is not a text in quotes");
  EXPECT_EQ(json(R"({"minutes": "noon"})"), "a.json: minutes: \"noon\" is not such as 1h30");
  EXPECT_EQ(json(R"({"minutes": "99h0"})"), "a.json: minutes: \"99h0\" is out of range 0h0 to 10h0");
  EXPECT_EQ(meeting.minutes, 180);
}

TEST(SettingsTable, listsEveryFieldWithPathAndDefault) {
  Sample sample;
  sample.length = 7;
  const SettingsTable table(sample);
  ASSERT_EQ(table.fields().size(), 6u);
  EXPECT_EQ(table.fields()[5].path, "layers.1.base");
  EXPECT_EQ(table.at("length").get(), 7);
  EXPECT_EQ(table.at("length").defaultValue, 2.5);
  table.at("length").reset();
  EXPECT_EQ(sample.length, 2.5);
}

TEST(SettingsTable, assignmentsFromTextReachTheStruct) {
  Sample sample;
  const SettingsTable table(sample);
  setField(table, "length=.75");
  setField(table, "count=9");
  setField(table, "on=false");
  setField(table, "mode=third");
  setField(table, "layers.1.base=1555");
  EXPECT_EQ(sample.length, .75);
  EXPECT_EQ(sample.count, 9);
  EXPECT_FALSE(sample.on);
  EXPECT_EQ(sample.mode, Mode::third);
  EXPECT_EQ(sample.layers[1].base, 1555);
}

TEST(SettingsTable, refusesWhatIsUnknownOrOutOfRangeInOneLineAndChangesNothing) {
  Sample sample;
  const SettingsTable table(sample);
  const auto refusal = [&](const char* text) {
    return test::refusalOf<std::exception>([&] { setField(table, text); });
  };
  EXPECT_EQ(refusal("lenght=1"), "unknown setting 'lenght'; the nearest are 'length', 'count' and 'on'");
  EXPECT_EQ(refusal("length=11"), "length: '11' is out of range 0.1 to 10 m");
  EXPECT_EQ(refusal("length=nan"), "length: 'nan' is not a finite number");
  EXPECT_EQ(refusal("length=1m"), "length: '1m' is not a number");
  EXPECT_EQ(refusal("count=1.5"), "count: '1.5' is not a whole number");
  EXPECT_EQ(refusal("on=1"), "on: '1' is not true or false");
  EXPECT_EQ(refusal("mode=fourth"), "mode: 'fourth' is not one of first second third");
  EXPECT_EQ(refusal("length"), "'length' is not of the form PATH=VALUE");
  EXPECT_EQ(toJson(table, true), nlohmann::json::object());
}

TEST(SettingsTable, jsonRoundTripKeepsEveryBit) {
  Sample sample;
  sample.length = 0.1 + 0.2;
  sample.mode = Mode::first;
  sample.layers[0].base = 1.0 / 3.0;
  Sample copy;
  applyJson(SettingsTable(copy), nlohmann::json::parse(toJson(SettingsTable(sample)).dump()), "copy.json");
  EXPECT_EQ(copy.length, sample.length);
  EXPECT_EQ(copy.mode, sample.mode);
  EXPECT_EQ(copy.layers[0].base, sample.layers[0].base);
}

TEST(SettingsTable, arraysAreReadByIndexOrAsLists) {
  Sample sample;
  applyJson(SettingsTable(sample), nlohmann::json::parse(R"({"layers": [{"base": 1}, {"base": 2}]})"),
            "a.json");
  EXPECT_EQ(sample.layers[1].base, 2);
}

TEST(SettingsTable, aBadJsonObjectNamesFileAndPlaceAndChangesNothing) {
  Sample sample;
  const SettingsTable table(sample);
  const auto apply = [&](const char* text) {
    return test::refusalOf<std::exception>([&] { applyJson(table, nlohmann::json::parse(text), "a.json"); });
  };
  EXPECT_EQ(apply(R"({"length": 3, "layers": {"0": {"base": -5}}})"),
            "a.json: layers.0.base: -5 is out of range 0 to 20000 m");
  EXPECT_EQ(apply(R"({"length": 3, "nothing": 1})"),
            "a.json: nothing: unknown setting; the nearest are 'count', 'on' and 'length'");
  EXPECT_EQ(apply(R"({"length": "3"})"), "a.json: length: \"3\" is not a number");
  EXPECT_EQ(apply(R"({"mode": 2})"), "a.json: mode: 2 is not a name in quotes");
  EXPECT_EQ(apply(R"([1])"), "a.json: settings: is not an object");
  EXPECT_EQ(sample.length, 2.5);
}

struct Moved {
  double now = 1;
  Layer layer;
};
void describe(SettingsVisitor& visitor, Moved& moved) {
  visitor.number("now", moved.now,
                 {.unit = "1", .min = 0, .max = 10, .help = "A number.", .aliases = "figure"});
  visitor.group("layer", moved.layer, "The layer.");
  visitor.renamed("before", "now");
  visitor.renamed("old.height", "layer.base");
}

TEST(SettingsTable, formerNamesStillReachTheField) {
  Moved moved;
  const SettingsTable table(moved);
  setField(table, "before=3");
  EXPECT_EQ(moved.now, 3);
  EXPECT_EQ(&table.at("old.height"), &table.at("layer.base"));
  EXPECT_EQ(table.at("before").aliases, "figure, before") << "the search finds it too";
  EXPECT_TRUE(table.isGroup("old"));
  EXPECT_FALSE(table.isGroup("ol"));
  applyJson(table, {{"before", 4}, {"old", {{"height", 5}}}}, "file.json");
  EXPECT_EQ(moved.now, 4);
  EXPECT_EQ(moved.layer.base, 5);
  EXPECT_EQ(toJson(table, true), (nlohmann::json{{"now", 4.0}, {"layer", {{"base", 5.0}}}}));
  const std::string reason = test::refusalOf<DataError>([&] {
    applyJson(table, {{"old", {{"width", 5}}}}, "file.json");
  });
  EXPECT_NE(reason.find("old.width: unknown setting"), std::string::npos) << reason;
}

TEST(SettingsTable, ofAFormerAndACurrentNameTheCurrentOneCounts) {
  // Whatever their order in the file: "before" comes first by the alphabet, "old" last.
  Moved moved;
  const SettingsTable table(moved);
  applyJson(table, {{"before", 4}, {"now", 6}, {"layer", {{"base", 7}}}, {"old", {{"height", 5}}}},
            "file.json");
  EXPECT_EQ(moved.now, 6);
  EXPECT_EQ(moved.layer.base, 7);
}

}  // namespace
}  // namespace skydrop::core
