#include "skydrop/game/input_log.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <limits>
#include <set>
#include <utility>

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/json.h"

namespace skydrop::game {
namespace {

using core::DataError;

constexpr std::string_view kKind = "skydrop input log";
constexpr std::size_t kMostText = 4096;       // characters of a string
constexpr std::size_t kMostSettings = 10000;  // overrides, and changes
constexpr std::size_t kMostBytes = std::size_t{64} << 20;
constexpr core::JsonLimits kLimits = {.bytes = kMostBytes, .values = kMostBytes};

// Reads the file in one pass and keeps nothing but the log itself: a hostile file cannot make it grow beyond
// its own size. Throws DataError at the first value that does not belong.
class LogReader final : public nlohmann::json_sax<nlohmann::json> {
 public:
  LogReader(std::string_view file, InputLog& log) : file_(file), log_(log) {}

  void finish() {
    for (const char* needed : {"schema", "kind", "seed", "runs"}) {
      if (!seen_.contains(needed)) fail(needed, "is missing");
    }
    std::uint64_t last = 0;
    for (const InputLog::Change& change : log_.changes) {
      if (change.step < last) fail("changes", "the steps do not ascend");
      if (change.step > steps_) fail("changes", "a change lies behind the last step");
      last = change.step;
    }
  }

  bool null() override { return wrong("null"); }
  bool boolean(bool) override { return wrong("true or false"); }
  bool number_float(double, const std::string&) override { return wrong("a number that is not whole"); }
  bool binary(binary_t&) override { return wrong("binary data"); }
  bool number_integer(std::int64_t value) override {
    return integer(value < 0, static_cast<std::uint64_t>(value));
  }
  bool number_unsigned(std::uint64_t value) override { return integer(false, value); }

  bool string(std::string& value) override {
    if (value.size() > kMostText) fail(place(), "a text of more than 4096 characters");
    if (depth_ == 1 && key_ == "kind") {
      if (value != kKind) fail(place(), "is not '" + std::string(kKind) + "'");
    } else if (depth_ == 1 && key_ == "program") {
      log_.program = value;
    } else if (depth_ == 1 && key_ == "scene") {
      log_.scene = value;
    } else if (depth_ == 1 && key_ == "finalHash") {
      const auto [end, error] =
          std::from_chars(value.data(), value.data() + value.size(), log_.finalHash, 16);
      if (error != std::errc() || end != value.data() + value.size())
        fail(place(), "is not a hexadecimal number");
    } else if (depth_ == 3 && key_ == "settings" && column_ < 2) {
      texts_[column_] = value;
    } else if (depth_ == 3 && key_ == "changes" && (column_ == 1 || column_ == 2)) {
      texts_[column_ - 1] = value;
    } else {
      return wrong("a text");
    }
    ++column_;
    return true;
  }

  bool start_object(std::size_t) override {
    if (depth_ != 0) return wrong("an object");
    depth_ = 1;
    return true;
  }
  bool end_object() override {
    depth_ = 0;
    return true;
  }

  bool key(std::string& name) override {
    static constexpr std::array<std::string_view, 9> kKnown = {
        "schema", "kind", "program", "scene", "seed", "settings", "changes", "runs", "finalHash"};
    key_ = name.substr(0, 40);
    if (std::find(kKnown.begin(), kKnown.end(), name) == kKnown.end()) {
      fail(key_, "is not a member of an input log");
    }
    seen_.insert(name);
    return true;
  }

  bool start_array(std::size_t) override {
    if (depth_ == 1 && (key_ == "settings" || key_ == "changes" || key_ == "runs")) {
      row_ = 0;
    } else if (depth_ == 2) {
      column_ = 0;
      numbers_ = {};
    } else {
      return wrong("an array");
    }
    ++depth_;
    return true;
  }

  bool end_array() override {
    if (--depth_ == 1) return true;
    const std::size_t expected = key_ == "runs" ? 7 : key_ == "changes" ? 3 : 2;
    if (column_ != expected)
      failRow("has " + std::to_string(column_) + " entries, not " + std::to_string(expected));
    if (key_ == "runs") {
      addRun();
    } else {
      const std::size_t count = key_ == "settings" ? log_.settings.size() : log_.changes.size();
      if (count >= kMostSettings) failRow("there are more than 10000 of them");
      SettingOverride setting{texts_[0], texts_[1]};
      if (key_ == "settings") {
        log_.settings.push_back(std::move(setting));
      } else {
        log_.changes.push_back({static_cast<std::uint64_t>(numbers_[0]), std::move(setting)});
      }
    }
    ++row_;
    return true;
  }

  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) override {
    return false;  // scanJson() says it
  }

 private:
  [[noreturn]] void fail(std::string_view where, std::string_view reason) const {
    throw DataError(file_, where, reason);
  }
  [[noreturn]] void failRow(const std::string& reason) const {
    fail(key_ + "[" + std::to_string(row_) + "]", reason);
  }
  std::string place() const {
    std::string out = key_.empty() ? "top" : key_;
    if (depth_ >= 2) out += "[" + std::to_string(row_) + "]";
    if (depth_ >= 3) out += "[" + std::to_string(column_) + "]";
    return out;
  }
  [[noreturn]] bool wrong(const char* what) const {
    fail(place(), std::string(what) + " does not belong here");
  }

  bool integer(bool negative, std::uint64_t value) {
    if (depth_ == 1 && key_ == "schema") {
      if (negative || value != static_cast<std::uint64_t>(InputLog::kSchema))
        fail(place(), "only schema 1 is known");
    } else if (depth_ == 1 && key_ == "seed") {
      if (negative) fail(place(), "is negative");
      log_.seed = value;
    } else if (depth_ == 3 && ((key_ == "runs" && column_ < 7) || (key_ == "changes" && column_ == 0))) {
      // The first of a row is a step number or count; 2^60 is beyond any limit and survives the sign.
      const std::uint64_t held = negative ? value : std::min<std::uint64_t>(value, 1ull << 60);
      numbers_[column_] = static_cast<std::int64_t>(held);
      if (numbers_[column_] < 0 && column_ == 0) fail(place(), "is negative");
    } else {
      return wrong("a number");
    }
    ++column_;
    return true;
  }

  void addRun() {
    const auto within = [&](std::size_t column, std::int64_t low, std::int64_t high) {
      if (numbers_[column] < low || numbers_[column] > high) {
        fail(key_ + "[" + std::to_string(row_) + "][" + std::to_string(column) + "]",
             std::to_string(numbers_[column]) + " is outside " + std::to_string(low) + " .. " +
                 std::to_string(high));
      }
      return numbers_[column];
    };
    InputLog::Run run;
    run.steps =
        static_cast<std::uint64_t>(within(0, 1, static_cast<std::int64_t>(InputLog::kMaxSteps - steps_)));
    steps_ += run.steps;
    run.controls.thrust = static_cast<std::int8_t>(within(1, 0, 127));
    run.controls.brake = static_cast<std::int8_t>(within(2, 0, 127));
    run.controls.pitch = static_cast<std::int8_t>(within(3, -127, 127));
    run.controls.roll = static_cast<std::int8_t>(within(4, -127, 127));
    run.controls.yaw = static_cast<std::int8_t>(within(5, -127, 127));
    const std::int64_t flags = within(6, 0, 3);
    run.controls.drop = (flags & 1) != 0;
    run.controls.reset = (flags & 2) != 0;
    log_.runs.push_back(run);
  }

  std::string_view file_;
  InputLog& log_;
  std::set<std::string> seen_;
  std::string key_;
  int depth_ = 0;  // 1 in the object, 2 in one of its arrays, 3 in a row of that
  std::size_t row_ = 0, column_ = 0;
  std::array<std::int64_t, 7> numbers_{};
  std::array<std::string, 2> texts_;
  std::uint64_t steps_ = 0;
};

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

void InputLog::append(const Controls& controls) {
  const QuantisedControls q = quantise(controls);
  if (runs.empty() || runs.back().controls != q) runs.push_back({0, q});
  ++runs.back().steps;
}

void InputLog::appendChange(SettingOverride setting) { changes.push_back({stepCount(), std::move(setting)}); }

std::uint64_t InputLog::stepCount() const {
  std::uint64_t steps = 0;
  for (const Run& run : runs) steps += run.steps;
  return steps;
}

std::string encodeInputLog(const InputLog& log) {
  std::string out = "{\n\"schema\": " + std::to_string(InputLog::kSchema) + ",\n\"kind\": \"" +
                    std::string(kKind) + "\",\n\"program\": " + quoted(log.program) +
                    ",\n\"scene\": " + quoted(log.scene) + ",\n\"seed\": " + std::to_string(log.seed) + ",\n";
  if (log.finalHash != 0) {
    std::array<char, 17> hex{};
    std::snprintf(hex.data(), hex.size(), "%016llx", static_cast<unsigned long long>(log.finalHash));
    out += "\"finalHash\": \"" + std::string(hex.data()) + "\",\n";
  }
  const char* separator = "\n";
  out += "\"settings\": [";
  for (const SettingOverride& s : log.settings) {
    out += separator + ("[" + quoted(s.path) + "," + quoted(s.value) + "]");
    separator = ",\n";
  }
  out += "],\n\"changes\": [";
  separator = "\n";
  for (const InputLog::Change& c : log.changes) {
    out += separator + ("[" + std::to_string(c.step) + "," + quoted(c.setting.path) + "," +
                        quoted(c.setting.value) + "]");
    separator = ",\n";
  }
  // steps, thrust, brake, pitch, roll, yaw (127 is 1), 1 for drop + 2 for reset
  out += "],\n\"runs\": [";
  separator = "\n";
  for (const InputLog::Run& r : log.runs) {
    out += separator + ("[" + std::to_string(r.steps));
    for (const int value :
         {int{r.controls.thrust}, int{r.controls.brake}, int{r.controls.pitch}, int{r.controls.roll},
          int{r.controls.yaw}, (r.controls.drop ? 1 : 0) + (r.controls.reset ? 2 : 0)}) {
      out += "," + std::to_string(value);
    }
    out += "]";
    separator = ",\n";
  }
  out += "]\n}\n";
  return out;
}

InputLog decodeInputLog(std::string_view text, std::string_view file) {
  InputLog log;
  LogReader reader(file, log);
  core::scanJson(text, file, reader, kLimits);
  reader.finish();
  return log;
}

InputLog readInputLog(const std::filesystem::path& file) {
  return decodeInputLog(core::readTextInput(file, kMostBytes), core::inputName(file));
}

void writeInputLog(const std::filesystem::path& file, const InputLog& log) {
  core::writeFileAtomically(file, encodeInputLog(log));
}

std::vector<SettingOverride> InputReplay::changesDue() {
  std::vector<SettingOverride> due;
  while (change_ < log_->changes.size() && log_->changes[change_].step <= step_) {
    due.push_back(log_->changes[change_++].setting);
  }
  return due;
}

Controls InputReplay::next() {
  if (finished()) return {};
  const InputLog::Run& run = log_->runs[run_];
  if (++withinRun_ >= run.steps) {
    ++run_;
    withinRun_ = 0;
  }
  ++step_;
  return dequantise(run.controls);
}

}  // namespace skydrop::game
