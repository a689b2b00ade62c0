#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "game/input_log_json.h"

namespace skydrop::game {
namespace {

constexpr std::size_t kMostBytes = std::size_t{64} << 20;

class Schema1Reader final : public LogEvents {
 public:
  Schema1Reader(std::string_view file, InputLog& log) : LogEvents(file), file_(file), log_(log) {}

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
    log_.ended = finalHash_ != 0;
    if (log_.ended) log_.checkpoints.push_back({steps_, finalHash_});
  }

  bool string(std::string& value) override {
    requireText(value);
    if (depth_ == 1 && key_ == "kind") {
      if (value != kLogKind) fail(place(), "is not '" + std::string(kLogKind) + "'");
    } else if (depth_ == 1 && key_ == "program") {
      log_.program = value;
    } else if (depth_ == 1 && key_ == "scene") {
      log_.scene.source = value;
    } else if (depth_ == 1 && key_ == "finalHash") {
      const std::optional<std::uint64_t> hash = parseHash(value);
      if (!hash) fail(place(), "is not a hexadecimal number");
      finalHash_ = *hash;
    } else if (depth_ == 3 && key_ == "settings" && column_ < 2) {
      texts_[column_] = value;
    } else if (depth_ == 3 && key_ == "changes" && (column_ == 1 || column_ == 2)) {
      texts_[column_ - 1] = value;
    } else {
      wrong("a text");
    }
    ++column_;
    return true;
  }

  bool start_object(std::size_t) override {
    if (depth_ != 0) wrong("an object");
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
      wrong("an array");
    }
    ++depth_;
    return true;
  }

  bool end_array() override {
    if (--depth_ == 1) return true;
    const std::size_t expected = key_ == "runs" ? 7 : key_ == "changes" ? 3 : 2;
    if (column_ != expected)
      fail(rowPlace(), "has " + std::to_string(column_) + " entries, not " + std::to_string(expected));
    if (key_ == "runs") {
      const InputLog::Run run = makeRun(numbers_, steps_, file_, rowPlace());
      steps_ += run.steps;
      log_.append(run.controls, run.steps);
    } else {
      const std::size_t count = key_ == "settings" ? log_.settings.size() : log_.changes.size();
      if (count >= InputLog::kMaxSettings) fail(rowPlace(), "there are more than 10000 of them");
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

 private:
  std::string rowPlace() const { return key_ + "[" + std::to_string(row_) + "]"; }
  std::string place() const override {
    std::string out = key_.empty() ? "top" : key_;
    if (depth_ >= 2) out += "[" + std::to_string(row_) + "]";
    if (depth_ >= 3) out += "[" + std::to_string(column_) + "]";
    return out;
  }

  bool integer(bool negative, std::uint64_t value) override {
    if (depth_ == 1 && key_ == "schema") {
      if (negative || value != 1) fail(place(), "only the schemas 1 and 2 are known");
    } else if (depth_ == 1 && key_ == "seed") {
      if (negative) fail(place(), "is negative");
      log_.seed = value;
    } else if (depth_ == 3 && ((key_ == "runs" && column_ < 7) || (key_ == "changes" && column_ == 0))) {
      // The first of a row is a step number or count; 2^60 is beyond any limit and survives the sign.
      const std::uint64_t held = negative ? value : std::min<std::uint64_t>(value, 1ull << 60);
      numbers_[column_] = static_cast<std::int64_t>(held);
      if (numbers_[column_] < 0 && column_ == 0) fail(place(), "is negative");
    } else {
      wrong("a number");
    }
    ++column_;
    return true;
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
  std::uint64_t finalHash_ = 0;  // 0 where it is not known
};

}  // namespace

InputLog decodeSchema1(std::string_view text, std::string_view file) {
  InputLog log;
  Schema1Reader reader(file, log);
  core::scanJson(text, file, reader, {.bytes = kMostBytes, .values = kMostBytes});
  reader.finish();
  return log;
}

}  // namespace skydrop::game
