#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "game/input_log_json.h"
#include "skydrop/core/error.h"

namespace skydrop::game {
namespace {

constexpr core::JsonLimits kHeaderLimits = {.bytes = InputLog::kMaxBytes,
                                            .values = 4 * InputLog::kMaxSettings};
constexpr core::JsonLimits kRecordLimits = {.bytes = InputLog::kMaxBytes, .values = 100};

class HeaderReader final : public LogEvents {
 public:
  HeaderReader(std::string_view file, InputLog& log) : LogEvents(file), log_(log) {}

  void finish() {
    for (const char* needed :
         {"schema", "kind", "seed", "scene", "scene.source", "scene.digest", "scene.text"}) {
      if (!seen_.contains(needed)) fail(needed, "is missing");
    }
    if (digest_ != sceneDigest(log_.scene.text)) fail("scene.digest", "is not that of the scene's text");
  }

  bool string(std::string& value) override {
    requireText(value, key_ == "scene.text" ? InputLog::kMaxSceneText : InputLog::kMaxText);
    if (depth_ == 3) {
      if (column_ >= 2) wrong("a text");
      texts_[column_++] = value;
    } else if (depth_ == 2 && inArray_) {
      wrong("a text");
    } else if (key_ == "kind") {
      if (value != kLogKind) fail(place(), "is not '" + std::string(kLogKind) + "'");
    } else if (key_ == "program") {
      log_.program = value;
    } else if (key_ == "scene.source") {
      log_.scene.source = value;
    } else if (key_ == "scene.text") {
      log_.scene.text = value;
    } else if (key_ == "scene.digest") {
      const std::optional<std::uint64_t> digest = parseHash(value);
      if (!digest) fail(place(), "is not a hexadecimal number");
      digest_ = *digest;
    } else {
      wrong("a text");
    }
    return true;
  }

  bool start_object(std::size_t) override {
    if (depth_ != 0 && !(depth_ == 1 && key_ == "scene")) wrong("an object");
    ++depth_;
    return true;
  }
  bool end_object() override {
    --depth_;
    return true;
  }

  bool key(std::string& name) override {
    static constexpr std::array<std::string_view, 12> kKnown = {
        "schema",       "kind",         "program",    "seed",    "scene",      "settings",
        "scene.source", "scene.digest", "scene.text", "weather", "farWeather", "elevation"};
    const std::string path = (depth_ == 2 ? "scene." : "") + name;
    key_ = path.substr(0, 40);
    if (std::find(kKnown.begin(), kKnown.end(), path) == kKnown.end() ||
        (depth_ == 1 && name.find('.') != std::string::npos)) {
      fail(key_, "is not a member of an input log");
    }
    seen_.insert(path);
    return true;
  }

  bool start_array(std::size_t) override {
    const bool isList = key_ == "settings" || weather();
    if (!(depth_ == 1 && isList) && !(depth_ == 2 && inArray_)) wrong("an array");
    inArray_ = true;
    ++depth_;
    column_ = 0;
    return true;
  }
  bool end_array() override {
    --depth_;
    if (depth_ == 1) {
      inArray_ = false;
      return true;
    }
    const std::string row = key_ + "[" + std::to_string(rows()) + "]";
    if (column_ != 2) fail(row, "has " + std::to_string(column_) + " entries, not 2");
    if (std::vector<InputLog::WeatherRecord>* files = weather()) {
      const std::optional<std::uint64_t> digest = parseHash(texts_[1]);
      if (!digest) fail(row, "the digest is not a hexadecimal number");
      const std::size_t most =
          key_ == "elevation" ? InputLog::kMaxElevationFiles : InputLog::kMaxWeatherFiles;
      if (files->size() == most) fail(row, "there are more than " + std::to_string(most) + " of them");
      files->push_back({texts_[0], *digest});
      return true;
    }
    if (log_.settings.size() >= InputLog::kMaxSettings) fail(row, "there are more than 10000 of them");
    log_.settings.push_back({texts_[0], texts_[1]});
    return true;
  }

 private:
  // Of the list that is read, so far.
  std::size_t rows() const { return weather() ? weather()->size() : log_.settings.size(); }
  // The weather files that are read; null within the settings.
  std::vector<InputLog::WeatherRecord>* weather() const {
    return key_ == "weather"      ? &log_.weather
           : key_ == "farWeather" ? &log_.farWeather
           : key_ == "elevation"  ? &log_.elevation
                                  : nullptr;
  }

  std::string place() const override {
    std::string out = key_.empty() ? "line 1" : key_;
    if (inArray_ && depth_ >= 2) out += "[" + std::to_string(rows()) + "]";
    if (inArray_ && depth_ >= 3) out += "[" + std::to_string(column_) + "]";
    return out;
  }

  bool integer(bool negative, std::uint64_t value) override {
    if (depth_ != 1 || (key_ != "schema" && key_ != "seed")) wrong("a number");
    if (key_ == "schema" && value != InputLog::kSchema) fail(place(), "only the schemas 1 and 2 are known");
    if (key_ == "schema") return true;
    if (negative) fail(place(), "is negative");
    log_.seed = value;
    return true;
  }

  InputLog& log_;
  std::set<std::string> seen_;
  std::string key_;  // of the scene's members: "scene.text"
  int depth_ = 0;    // 1 in the object, 2 in the scene or the settings, 3 in a row of those
  bool inArray_ = false;
  std::size_t column_ = 0;
  std::array<std::string, 2> texts_;
  std::uint64_t digest_ = 0;
};

// One record: a flat array of whole numbers and texts.
class RecordReader final : public LogEvents {
 public:
  RecordReader(std::string_view file, std::size_t line) : LogEvents(file), file_(file), line_(line) {}

  void addTo(InputLog& log, std::uint64_t& steps) {
    if (textCount_ == 0) return addRun(log, steps);
    const bool textFirst = !isNumber_[0];
    if (textFirst && texts_[0] == "set" && count_ == 3 && textCount_ == 3) {
      if (log.changes.size() >= InputLog::kMaxChanges) fail(place(), "there are too many changes");
      log.changes.push_back({steps, {texts_[1], texts_[2]}});
    } else if (textFirst && texts_[0] == "check" && count_ == 3 && isNumber_[1] && !isNumber_[2]) {
      addCheckpoint(log);
    } else if (textFirst && texts_[0] == "end" && count_ == 3 && isNumber_[1] && !isNumber_[2]) {
      numbers_[1] = std::max(numbers_[1], static_cast<std::int64_t>(steps));  // rows beyond it are flown too
      addCheckpoint(log);
      log.ended = true;
    } else {
      fail(place(), "is no record of an input log");
    }
  }

  bool string(std::string& value) override {
    requireText(value);
    take(false);
    texts_[count_ - 1] = value;
    ++textCount_;
    return true;
  }
  bool start_object(std::size_t) override { wrong("an object"); }
  bool end_object() override { return true; }
  bool key(std::string&) override { return true; }
  bool start_array(std::size_t) override {
    if (inside_) wrong("an array");
    inside_ = true;
    return true;
  }
  bool end_array() override { return true; }

 private:
  static constexpr std::size_t kColumns = 7;

  std::string place() const override { return "line " + std::to_string(line_); }

  bool integer(bool negative, std::uint64_t value) override {
    take(true);
    // 2^60 is beyond any limit and survives the sign.
    const std::uint64_t held = negative ? value : std::min<std::uint64_t>(value, 1ull << 60);
    numbers_[count_ - 1] = static_cast<std::int64_t>(held);
    return true;
  }

  void take(bool isNumber) {
    if (!inside_ || count_ == kColumns) wrong(isNumber ? "a number" : "a text");
    isNumber_[count_++] = isNumber;
  }

  void addRun(InputLog& log, std::uint64_t& steps) const {
    if (count_ != kColumns && count_ != 1)
      fail(place(), "has " + std::to_string(count_) + " entries, not 7, nor 1 that goes on");
    if (count_ == 1 && log.runs.empty()) fail(place(), "goes on with controls that no row has named");
    InputLog::Run run = makeRun(numbers_, steps, file_, place());
    if (count_ == 1) run.controls = log.runs.back().controls;
    log.append(run.controls, run.steps);
    steps += run.steps;
  }

  // Checkpoints are at the step that they name, wherever they stand: a row that was tampered with shows as a
  // flight that differs.
  void addCheckpoint(InputLog& log) const {
    const std::optional<std::uint64_t> hash = parseHash(texts_[2]);
    if (!hash) fail(place(), "the state is not a hexadecimal number");
    if (numbers_[1] < 0) fail(place(), "the step is negative");
    const auto step = static_cast<std::uint64_t>(numbers_[1]);
    const bool isEnd = texts_[0] == "end";  // where the last checkpoint may be already
    if (!log.checkpoints.empty() && step < log.checkpoints.back().step + (isEnd ? 0 : 1))
      fail(place(), "the steps of the checkpoints do not ascend");
    log.checkpoints.push_back({step, *hash});
  }

  std::string_view file_;
  std::size_t line_;
  bool inside_ = false;
  std::size_t count_ = 0, textCount_ = 0;
  std::array<bool, kColumns> isNumber_{};
  std::array<std::int64_t, kColumns> numbers_{};
  std::array<std::string, kColumns> texts_;
};

// The parser counts the lines of what it is given: what it names "line 1" is this line of the file.
void scanLine(std::string_view text, std::string_view file, std::size_t line, RecordReader& reader) {
  try {
    core::scanJson(text, file, reader, kRecordLimits);
  } catch (const core::DataError& refusal) {
    constexpr std::string_view kFirstLine = ": line 1, ";
    const std::string said = refusal.what();
    const std::size_t at = said.find(kFirstLine);
    const std::size_t reason = at == std::string::npos ? at : said.find(": ", at + kFirstLine.size());
    if (reason == std::string::npos) throw;
    const std::size_t column = at + kFirstLine.size();
    throw core::DataError(file, "line " + std::to_string(line) + ", " + said.substr(column, reason - column),
                          said.substr(reason + 2));
  }
}

}  // namespace

InputLog decodeSchema2(std::string_view text, std::string_view file) {
  InputLog log;
  std::uint64_t steps = 0;
  std::size_t line = 1;
  for (std::size_t at = 0, end = 0; at < text.size(); at = end + 1, ++line) {
    end = text.find('\n', at);
    if (end == std::string_view::npos) {
      if (line == 1) throw core::DataError(file, "line 1", "the header is cut off");
      break;  // cut off while it was written
    }
    const std::string_view row = text.substr(at, end - at);
    if (log.ended) throw core::DataError(file, "line " + std::to_string(line), "comes after the end");
    if (line == 1) {
      HeaderReader reader(file, log);
      core::scanJson(row, file, reader, kHeaderLimits);
      reader.finish();
    } else {
      RecordReader reader(file, line);
      scanLine(row, file, line, reader);
      reader.addTo(log, steps);
    }
  }
  if (!log.checkpoints.empty() && log.checkpoints.back().step > steps)
    throw core::DataError(file, "line " + std::to_string(line - 1), "a checkpoint lies behind the last step");
  return log;
}

}  // namespace skydrop::game
