// Every reader of JSON against hostile files: tests/corpus/json, and mutants of each.
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "render/models/plain_model.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/json.h"
#include "skydrop/core/message.h"
#include "skydrop/core/settings_file.h"
#include "skydrop/core/settings_table.h"
#include "skydrop/game/input_log.h"
#include "skydrop/scene/scene.h"
#include "skydrop/stability/hard_case.h"
#include "support/mutant.h"
#include "support/paths.h"
#include "support/temporary_folder.h"

namespace skydrop {
namespace {

struct Layer {
  double base = 0;
};
void describe(core::SettingsVisitor& visitor, Layer& layer) {
  visitor.number("base", layer.base, {"m", 0, 9, "A height."});
}

struct Aircraft {
  double rollFactor = 1;
};
void describe(core::SettingsVisitor& visitor, Aircraft& aircraft) {
  visitor.number("rollFactor", aircraft.rollFactor, {"1", 0, 2, "A factor."});
}

struct Sample {
  Aircraft aircraft;
  std::array<Layer, 2> layers;
  double speed = 1;
  bool on = false;
};
void describe(core::SettingsVisitor& visitor, Sample& sample) {
  visitor.group("aircraft", sample.aircraft, "A group.");
  visitor.group("layers", sample.layers, "A list.");
  visitor.number("speed", sample.speed, {"m/s", 0, 9, "A speed."});
  visitor.flag("on", sample.on, {"A switch."});
}

void apply(const nlohmann::json& settings) {
  Sample sample;
  core::applyJson(core::SettingsTable(sample), settings, "a.json");
}

struct Reader {
  std::string name;
  std::function<void(const std::string&)> read;
  std::string file = "a.json";  // as its messages name it
};

// Models are read from a file only.
std::string modelFile() {
  static const test::TemporaryFolder folder;
  return folder.path() / "a.gltf";
}

const std::vector<Reader>& readers() {
  static const std::vector<Reader> kReaders = {
      {"Json",
       [](const std::string& text) {
         // What is accepted can be written and destroyed, whatever its shape.
         core::parseJson(core::parseJson(text, "a.json").dump(), "a.json");
       }},
      {"Scene",
       [](const std::string& text) {
         apply(core::parseJson(scene::parseScene(text, "a.json").settingsJson, "a.json"));
       }},
      {"Settings",
       [](const std::string& text) { apply(core::parseSettings(text, "a.json", {})["settings"]); }},
      {"KeptSettings",
       [](const std::string& text) {
         apply(core::parseSettings(text, "a.json", {}, core::UnknownMembers::keep)["settings"]);
       }},
      {"HardCases",
       [](const std::string& text) { stability::hardCasesText(stability::parseHardCases(text, "a.json")); }},
      {"Log", [](const std::string& text) { game::decodeInputLog(text, "a.json"); }},
      {"Model",
       [](const std::string& text) {
         std::ofstream(modelFile(), std::ios::binary) << text;
         render::readPlainGltf(modelFile(), render::ModelFormat::gltf);
       },
       modelFile()},
  };
  return kReaders;
}

// Why the text is refused, or empty. Anything but a DataError of one printable line that names the file is a
// failure.
std::string refusalBy(const Reader& reader, const std::string& text) {
  std::string line;
  try {
    reader.read(text);
    return line;
  } catch (const core::DataError& error) {
    line = error.what();
  } catch (const std::exception& error) {
    ADD_FAILURE() << reader.name << " lets out " << error.what();
  }
  EXPECT_TRUE(line.starts_with(reader.file + ": ")) << reader.name << ": " << line;
  EXPECT_EQ(line, core::printable(line)) << reader.name;
  EXPECT_LE(line.size(), core::kLongestMessage) << reader.name;
  return line.empty() ? "?" : line;
}

struct CorpusFile {
  std::string name, text;
};

std::vector<CorpusFile> corpus() {
  std::vector<CorpusFile> files;
  for (const auto& entry : std::filesystem::directory_iterator(test::sourceDir() + "/tests/corpus/json"))
    files.push_back({entry.path().stem().string(), core::readTextFile(entry.path())});
  std::ranges::sort(files, {}, &CorpusFile::name);
  return files;
}

TEST(JsonCorpus, everyFileIsAcceptedOrRefusedAsItsNameSays) {
  // good<Reader>... is read by that reader; broken... is no JSON that anybody reads; odd... is JSON, and none
  // of our files.
  const std::vector<CorpusFile> files = corpus();
  EXPECT_GE(files.size(), 50u);
  for (const CorpusFile& file : files) {
    bool isGood = false;
    for (const Reader& reader : readers()) {
      const std::string line = refusalBy(reader, file.text);
      if (file.name.starts_with("good" + reader.name)) {
        EXPECT_EQ(line, "") << file.name << ", " << reader.name;
        isGood = true;
      }
      if (file.name.starts_with("broken")) {
        EXPECT_NE(line, "") << file.name << ", " << reader.name;
      }
      if (file.name.starts_with("odd") && reader.name != "Json" && reader.name != "KeptSettings") {
        EXPECT_NE(line, "") << file.name << ", " << reader.name;
      }
      if (file.name.starts_with("odd") && reader.name == "Json") {
        EXPECT_EQ(line, "") << file.name;
      }
    }
    EXPECT_EQ(isGood, file.name.starts_with("good")) << file.name;
  }
}

TEST(JsonCorpus, mutantsAreAcceptedOrRefusedInOneLine) {
  // Truncations, flipped, inserted and repeated bytes; the sanitizers watch.
  std::mt19937 random(7);
  constexpr std::string_view kInteresting(
      "\0\"[]{},:\\\xff\x1b"
      "0e-9",
      15);
  for (const CorpusFile& file : corpus()) {
    for (int round = 0; round < 60 && !file.text.empty(); ++round) {
      const std::string text = test::mutantOf(file.text, random, kInteresting);
      for (const Reader& reader : readers()) refusalBy(reader, text);
    }
  }
}

TEST(JsonCorpus, sizeDepthAndCountEndNoReader) {
  // Too large for files: the shapes that ended programs.
  const auto wrapped = [](const std::string& inner) {
    return "{\"schema\": 1, \"settings\": " + inner + "}";
  };
  std::string many = "[0";
  for (int i = 0; i < 300000; ++i) many += ",0";
  std::string names = "{\"n\":0";
  for (int i = 0; i < 100000; ++i) names += ",\"n" + std::to_string(i) + "\":0";
  for (const std::string& text :
       {wrapped(std::string(60000, '[') + std::string(60000, ']')), wrapped(std::string(400000, '[')),
        wrapped(many + "]"), wrapped(names + "}"), std::string(100 << 20, ' '), std::string(2 << 20, '7')}) {
    for (const Reader& reader : readers()) EXPECT_NE(refusalBy(reader, text), "") << reader.name;
  }
}

}  // namespace
}  // namespace skydrop
