// Weather files: what is read of each provider's answers, and that no damaged file ends the program.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/message.h"
#include "skydrop/forecast/forecast_of.h"
#include "skydrop/forecast/read_report.h"
#include "support/instrumented.h"
#include "support/mutant.h"
#include "support/paths.h"
#include "support/refusal.h"
#include "support/weather_answer.h"

namespace skydrop::forecast {
namespace {

using weather::Genus;

const sky::Instant kAbout = sky::parseInstant("2026-06-21T13:00Z");

std::string corpusFile(const std::string& name) {
  return test::sourceDir() + "/tests/corpus/weather/" + name;
}

Report reportOf(const std::string& name) {
  return readReport(core::readTextFile(corpusFile(name)), name, kAbout);
}

Report reportOfMetar(const std::string& groups) {
  return readReport("METAR LSZB 211220Z " + groups, "a.txt", kAbout);
}

Hour hourOfMetar(const std::string& groups) { return reportOfMetar(groups).hours[0]; }

TEST(WeatherReport, theThreeFormsOfTimeOfMeteoblueAreOne) {
  const Report local = reportOf("goodMeteoblue.json");
  EXPECT_EQ(sky::instantText({local.hours[0].utcMs}), "2026-06-20T22:00:00Z");
  EXPECT_EQ(local.place, "Example hill");
  EXPECT_EQ(local.elevationM, 858);
  for (const char* other : {"goodMeteoblueIso.json", "goodMeteoblueMilliseconds.json"}) {
    const Report report = reportOf(other);
    ASSERT_EQ(report.hours.size(), local.hours.size());
    for (std::size_t i = 0; i < local.hours.size(); ++i) {
      EXPECT_EQ(report.hours[i].utcMs, local.hours[i].utcMs) << other;
      EXPECT_EQ(report.hours[i].values, local.hours[i].values) << other;
    }
  }
}

TEST(WeatherReport, twoAnswersOfOnePlaceAreTheCombinedOne) {
  const Report combined = reportOf("goodMeteoblue.json");
  const Report both = merged({reportOf("goodMeteoblueClouds.json"), reportOf("goodMeteoblueBasic.json")});
  ASSERT_EQ(both.hours.size(), combined.hours.size());
  for (std::size_t i = 0; i < both.hours.size(); ++i) {
    EXPECT_EQ(both.hours[i].values, combined.hours[i].values);
    EXPECT_EQ(both.hours[i].phenomena, combined.hours[i].phenomena);
  }
}

TEST(WeatherReport, windIsReadInEveryUnitAndAsPointsOfTheCompass) {
  const auto speedOf = [](const char* unit, double value) {
    test::WeatherAnswer answer({"2026-06-21 00:00"});
    answer.set("windspeed", {value}).root["units"]["windspeed"] = unit;
    return *readReport(answer.text(), "a.json", kAbout).hours[0][Quantity::windMps];
  };
  EXPECT_DOUBLE_EQ(speedOf("ms-1", 10), 10);
  EXPECT_DOUBLE_EQ(speedOf("kmh", 36), 10);
  EXPECT_NEAR(speedOf("mph", 10), 4.4704, 1e-9);
  EXPECT_NEAR(speedOf("kn", 10), 5.14444, 1e-5);
  EXPECT_NEAR(speedOf("bft", 8), 18.9, 0.1) << "the middle of a fresh gale, 17.2 to 20.7 m/s";
  const auto fromOf = [](const nlohmann::json& value) {
    test::WeatherAnswer answer({"2026-06-21 00:00", "2026-06-21 01:00"});
    answer.set("winddirection", {value, 90});
    return *readReport(answer.text(), "a.json", kAbout).hours[0][Quantity::windFromDeg];
  };
  EXPECT_EQ(fromOf("SE"), 135);
  EXPECT_EQ(fromOf("NNW"), 337.5);
  EXPECT_EQ(fromOf(360), 0);
  EXPECT_EQ(fromOf(-10), 350);
}

TEST(WeatherReport, bothSpellingsOfOpenMeteoAreRead) {
  const Report report = reportOf("goodOpenMeteo.json");
  const Hour& hour = report.hours[6];
  EXPECT_NEAR(*hour[Quantity::lowCover], 1, 1e-9);
  EXPECT_NEAR(*hour[Quantity::middleCover], 0.9, 1e-9);
  EXPECT_NEAR(*hour[Quantity::windMps], 32 / 3.6, 0.01);
  EXPECT_TRUE(hour[Quantity::dewPointC] && hour[Quantity::gustMps]);
  EXPECT_NEAR(*hour[Quantity::snowShare], 1, 1e-9) << "0.98 cm of snow are 1.4 mm of water";
  ASSERT_EQ(hour.aloft.size(), 3u);
  EXPECT_EQ(hour.aloft[0].heightM, 1457) << "a level without a height has that of the standard atmosphere";
  EXPECT_EQ(hour.aloft[2].heightM, 10310);
  const Report unix = reportOf("goodOpenMeteoUnixtime.json");
  EXPECT_EQ(unix.hours[5].utcMs, report.hours[5].utcMs);
}

TEST(WeatherReport, groupsOfAMetarAreReadInAnyOrder) {
  const Hour hour = hourOfMetar("Q1012 22/M04 23008G20KT BKN090AC SCT040 FEW025TCU 190V270 -SHRA 9999");
  EXPECT_EQ(*hour[Quantity::pressureHpa], 1012);
  EXPECT_EQ(*hour[Quantity::dewPointC], -4);
  EXPECT_EQ(*hour[Quantity::windFromDeg], 230);
  EXPECT_NEAR(*hour[Quantity::gustMps], 20 * 1852.0 / 3600, 1e-9);
  ASSERT_EQ(hour.layers->size(), 3u);
  EXPECT_NEAR(hour.layers->front().baseM, 762, 0.1);
  EXPECT_TRUE(hour.layers->front().toweringCumulus && hour.phenomena->towers);
  EXPECT_EQ(*hour[Quantity::totalCover], 0.75);
  EXPECT_GT(*hour[Quantity::precipitationMm], 0);
  EXPECT_EQ(*hour[Quantity::convectiveMm], *hour[Quantity::precipitationMm]);
}

TEST(WeatherReport, visibilityOfAMetarIsReadInMetresAndStatuteMiles) {
  const auto metres = [](const char* group) {
    return hourOfMetar(std::string(group) + " Q1012")[Quantity::visibilityM].value_or(-1);
  };
  EXPECT_EQ(metres("1200"), 1200);
  EXPECT_EQ(metres("9999"), 30000);
  EXPECT_EQ(metres("CAVOK"), 30000);
  EXPECT_EQ(metres("P6SM"), 30000);
  EXPECT_EQ(metres("5KM"), 5000);
  EXPECT_NEAR(metres("3SM"), 4828, 1);
  EXPECT_NEAR(metres("1/2SM"), 804.7, 0.1);
  EXPECT_NEAR(metres("1 1/2SM"), 2414, 0.1);
  EXPECT_NEAR(metres("M1/4SM"), 402.3, 0.1);
  EXPECT_EQ(metres("////"), -1);
  EXPECT_EQ(metres("1500 R14/0600 1200SW"), 1500);
}

TEST(WeatherReport, whatAMetarDoesNotSayIsMissing) {
  const Hour hour = hourOfMetar("VRB03KT //// // ////// ///// Q////");
  EXPECT_NEAR(*hour[Quantity::windMps], 3 * 1852.0 / 3600, 1e-9);
  for (const Quantity quantity : {Quantity::windFromDeg, Quantity::visibilityM, Quantity::temperatureC,
                                  Quantity::pressureHpa, Quantity::totalCover})
    EXPECT_FALSE(hour[quantity]);
  EXPECT_FALSE(hour.layers);
  EXPECT_TRUE(hourOfMetar("CLR")[Quantity::totalCover]);
  EXPECT_FALSE(hourOfMetar("CAVOK RMK 25010KT")[Quantity::windMps]) << "remarks are no groups";
  EXPECT_EQ(*hourOfMetar("M01/M05 A2992")[Quantity::temperatureC], -1);
  EXPECT_NEAR(*hourOfMetar("A2992")[Quantity::pressureHpa], 1013.2, 0.1);
  const Report odd = reportOfMetar("201/16 ABCDEFGH CAVOK");
  ASSERT_EQ(odd.notes.size(), 2u);
  EXPECT_EQ(odd.notes[0], "line 1: '201/16' is not understood, and left out");
}

TEST(WeatherReport, severalReportsAreHoursInTheOrderOfTime) {
  const Report report = readReport(
      "METAR LSZB 211250Z 27010KT CAVOK 20/10 Q1010\n"
      "METAR LSZB 211220Z 26008KT CAVOK 19/10 Q1011=\n"
      "METAR COR LSZB 211250Z 27012KT CAVOK 20/10 Q1009\nMETAR LSZB 211320Z NIL\n",
      "a.txt", kAbout);
  ASSERT_EQ(report.hours.size(), 2u);
  EXPECT_EQ(*report.hours[0][Quantity::pressureHpa], 1011);
  EXPECT_EQ(*report.hours[1][Quantity::pressureHpa], 1009) << "the corrected one counts";
}

Hour hourWith(std::initializer_list<std::pair<Quantity, double>> values) {
  Hour hour;
  for (const auto& [quantity, value] : values) hour[quantity] = value;
  return hour;
}

TEST(WeatherOfHour, lowCloudBeginsWhereRisingAirCondenses) {
  const weather::State state =
      stateOf(hourWith({{Quantity::temperatureC, 20}, {Quantity::dewPointC, 12}, {Quantity::lowCover, 0.4}}),
              {500, false});
  EXPECT_EQ(state.layers[0].genus, Genus::cumulus);
  EXPECT_NEAR(state.layers[0].baseM, 500 + 8 * 125, 1e-9);
  EXPECT_NEAR(state.temperatureC, 20 + 0.0065 * 500, 1e-9);
  // The same moisture as relative humidity, 60.0 % (WMO 2008).
  const weather::State humid = stateOf(
      hourWith({{Quantity::temperatureC, 20}, {Quantity::humidity, 0.600}, {Quantity::lowCover, 0.4}}),
      {500, false});
  EXPECT_NEAR(humid.layers[0].baseM, state.layers[0].baseM, 10);
}

TEST(WeatherOfHour, sheetsTowersAndNimbostratusFollowCoverAndRain) {
  using Q = Quantity;
  EXPECT_EQ(stateOf(hourWith({{Q::lowCover, 0.9}}), {}).layers[0].genus, Genus::stratocumulus);
  EXPECT_EQ(stateOf(hourWith({{Q::middleCover, 0.9}}), {}).layers[2].genus, Genus::altostratus);
  EXPECT_EQ(stateOf(hourWith({{Q::highCover, 0.3}}), {}).layers[3].genus, Genus::cirrus);
  const auto towerOf = [](Hour hour) { return stateOf(hour, {}).layers[1]; };
  EXPECT_EQ(towerOf(hourWith({{Q::lowCover, 0.5}})).cover, 0);
  const Hour shower = hourWith({{Q::lowCover, 0.5}, {Q::precipitationMm, 1}, {Q::convectiveMm, 0.9}});
  EXPECT_EQ(towerOf(shower).genus, Genus::cumulus);
  EXPECT_GT(towerOf(shower).cover, 0);
  Hour storm = shower;
  storm.phenomena = Phenomena{.thunder = true};
  EXPECT_EQ(towerOf(storm).genus, Genus::cumulonimbus);
  EXPECT_GT(stateOf(storm, {}).lightningPerMinute, 0);
  const weather::State rain =
      stateOf(hourWith({{Q::lowCover, 0.8}, {Q::middleCover, 0.9}, {Q::precipitationMm, 2}}), {});
  EXPECT_EQ(rain.layers[2].genus, Genus::nimbostratus);
  EXPECT_EQ(rain.layers[1].cover, 0);
}

TEST(WeatherOfHour, precipitationFallsByTemperatureOrShareOfSnow) {
  const auto of = [](double temperature, std::optional<double> snow) {
    Hour hour = hourWith({{Quantity::temperatureC, temperature}, {Quantity::precipitationMm, 3}});
    hour[Quantity::snowShare] = snow;
    return stateOf(hour, {}).precipitation;
  };
  EXPECT_EQ(of(10, {}).rain, 3);
  EXPECT_EQ(of(-3, {}).snow, 3);
  EXPECT_EQ(of(1.5, {}).sleet, 3);
  EXPECT_EQ(of(10, 1).snow, 3) << "what the file says comes before the temperature";
  for (const double temperature : {-20.0, 0.5, 1.0, 2.0, 2.9, 30.0}) {
    const weather::Precipitation p = of(temperature, {});
    EXPECT_EQ(p.rain + p.snow + p.sleet, 3) << "none is lost";
  }
}

TEST(WeatherOfHour, fogFollowsVisibilityAndItsProbability) {
  using Q = Quantity;
  EXPECT_EQ(stateOf(hourWith({{Q::visibilityM, 1000}}), {}).fog.extinction, 0);
  const weather::State fog = stateOf(hourWith({{Q::visibilityM, 200}}), {400, false});
  EXPECT_NEAR(fog.fog.extinction, 3.912 / 200, 1e-9);
  EXPECT_EQ(fog.fog.topM, 600);
  EXPECT_EQ(stateOf(hourWith({{Q::fogProbability, 0.4}}), {}).fog.extinction, 0);
  EXPECT_GT(stateOf(hourWith({{Q::fogProbability, 0.6}}), {}).fog.extinction, 0);
  EXPECT_EQ(stateOf(hourWith({{Q::fogProbability, 0.9}, {Q::visibilityM, 20000}}), {}).fog.extinction, 0)
      << "a visibility that is known counts more";
}

TEST(WeatherOfHour, windAloftIsThatOfTheFileOrALawThatMirrorsAtTheEquator) {
  Hour hour = hourWith({{Quantity::windMps, 5}, {Quantity::windFromDeg, 355}});
  const weather::Wind north = stateOf(hour, {0, false}).wind, south = stateOf(hour, {0, true}).wind;
  EXPECT_NEAR(north.levels[0].directionDeg, 15, 1e-9);
  EXPECT_NEAR(south.levels[0].directionDeg, 335, 1e-9);
  EXPECT_GT(north.levels[2].speedMps, north.levels[0].speedMps);
  hour.aloft = {{1457, 12, 290}, {5574, 22, 300}, {10363, 39, 310}};
  const weather::Wind known = stateOf(hour, {}).wind;
  EXPECT_EQ(known.levels[1], (weather::WindLevel{5574, 22, 300}));
  EXPECT_EQ(known.levels[2], (weather::WindLevel{10363, 39, 310}));
}

struct CorpusFile {
  std::string name, text;
};

std::vector<CorpusFile> corpus() {
  std::vector<CorpusFile> files;
  for (const auto& entry : std::filesystem::directory_iterator(corpusFile("")))
    files.push_back({entry.path().filename().string(), core::readTextFile(entry.path())});
  std::ranges::sort(files, {}, &CorpusFile::name);
  return files;
}

// Why the text is refused, or empty. What is accepted gives a usable forecast.
std::string refusalOf(const std::string& text) {
  std::string line;
  try {
    Report report = readReport(text, "a.json", kAbout);
    for (const std::string& note : report.notes) EXPECT_LE(note.size(), core::kLongestMessage);
    forecastOf(std::move(report), std::nullopt, 1);
    return "";
  } catch (const core::DataError& error) {
    line = error.what();
  } catch (const std::exception& error) {
    ADD_FAILURE() << "lets out " << error.what();
  }
  EXPECT_TRUE(line.starts_with("a.json: ")) << line;
  EXPECT_EQ(line, core::printable(line));
  EXPECT_LE(line.size(), core::kLongestMessage);
  return line.empty() ? "?" : line;
}

TEST(WeatherCorpus, everyFileIsReadOrRefusedAsItsNameSays) {
  const std::vector<CorpusFile> files = corpus();
  EXPECT_GE(files.size(), 30u);
  for (const CorpusFile& file : files)
    EXPECT_EQ(refusalOf(file.text).empty(), file.name.starts_with("good")) << file.name;
}

std::string withAnotherNumber(std::string text, std::mt19937& random) {
  const char* const kNumbers[] = {"1e308", "-1e308", "-0.0",   "99999999999999999999",
                                  "null",  "true",   "\"NW\"", "[]"};
  const std::size_t from = text.find_first_of("0123456789", random() % text.size());
  if (from == std::string::npos) return text;
  const std::size_t end = text.find_first_not_of("0123456789.", from);
  return text.replace(from, end == std::string::npos ? 1 : end - from,
                      kNumbers[random() % std::size(kNumbers)]);
}

TEST(WeatherCorpus, mutantsAreReadOrRefusedInOneLine) {
  // Truncations, flipped, inserted and repeated bytes, numbers in the place of others; the sanitizers watch.
  std::mt19937 random(11);
  constexpr std::string_view kInteresting("\0\"[]{},:\\\xff\x1b-0e9./=", 19);
  int accepted = 0, refused = 0;
  for (const CorpusFile& file : corpus()) {
    for (int round = 0; round < test::repetitions(100); ++round) {
      const std::string text = random() % 5 == 0 ? withAnotherNumber(file.text, random)
                                                 : test::mutantOf(file.text, random, kInteresting);
      (refusalOf(text).empty() ? accepted : refused)++;
    }
  }
  // Shares, for the instrumented builds try fewer.
  EXPECT_GT(accepted, (accepted + refused) / 50);
  EXPECT_GT(refused, (accepted + refused) / 2);
}

}  // namespace
}  // namespace skydrop::forecast
