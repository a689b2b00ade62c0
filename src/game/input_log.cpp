#include "skydrop/game/input_log.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "game/input_log_json.h"
#include "skydrop/core/file.h"
#include "skydrop/core/hash.h"

namespace skydrop::game {
namespace {

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string hexText(std::uint64_t value) {
  std::array<char, 17> digits{};
  std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(value));
  return digits.data();
}

// Whether the text begins as every log of schema 2 does: {"schema":2 with blanks anywhere between.
bool isSchema2(std::string_view text) {
  for (const std::string_view part : {"{", "\"schema\"", ":", "2"}) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r"), text.size()));
    if (!text.starts_with(part)) return false;
    text.remove_prefix(part.size());
  }
  return true;
}

}  // namespace

void InputLog::append(const QuantisedControls& controls, std::uint64_t steps) {
  if (steps == 0) return;
  if (runs.empty() || runs.back().controls != controls) runs.push_back({0, controls});
  runs.back().steps += steps;
}

void InputLog::appendChange(SettingOverride setting) { changes.push_back({stepCount(), std::move(setting)}); }

std::uint64_t InputLog::stepCount() const {
  std::uint64_t steps = 0;
  for (const Run& run : runs) steps += run.steps;
  return steps;
}

InputLogWriter::InputLogWriter(const InputLog& start) {
  text_ = "{\"schema\":" + std::to_string(InputLog::kSchema) + ",\"kind\":\"" + std::string(kLogKind) +
          "\",\"program\":" + quoted(start.program) + ",\"seed\":" + std::to_string(start.seed) +
          ",\"scene\":{\"source\":" + quoted(start.scene.source) + ",\"digest\":\"" +
          hexText(sceneDigest(start.scene.text)) + "\",\"text\":" + quoted(start.scene.text) + "}";
  writeWeather("weather", start.weather);
  writeWeather("farWeather", start.farWeather);
  writeWeather("elevation", start.elevation);
  text_ += ",\"settings\":[";
  const char* separator = "";
  for (const SettingOverride& s : start.settings) {
    text_ += separator + ("[" + quoted(s.path) + "," + quoted(s.value) + "]");
    separator = ",";
  }
  text_ += "]}\n";
}

void InputLogWriter::writeWeather(std::string_view name, const std::vector<InputLog::WeatherRecord>& files) {
  if (files.empty()) return;
  text_ += ",\"" + std::string(name) + "\":[";
  const char* separator = "";
  for (const InputLog::WeatherRecord& file : files) {
    text_ += separator + ("[" + quoted(file.source) + ",\"" + hexText(file.digest) + "\"]");
    separator = ",";
  }
  text_ += "]";
}

void InputLogWriter::append(const QuantisedControls& controls, std::uint64_t steps) {
  if (steps == 0) return;
  if (!changes_.empty()) {
    writeRun();
    for (const SettingOverride& s : std::exchange(changes_, {})) {
      text_ += "[\"set\"," + quoted(s.path) + "," + quoted(s.value) + "]\n";
      ++changeCount_;
    }
  }
  if (run_.controls != controls) {
    writeRun();
    run_.controls = controls;
  }
  run_.steps += steps;
  steps_ += steps;
}

void InputLogWriter::change(SettingOverride setting) {
  std::erase_if(changes_, [&](const SettingOverride& earlier) { return earlier.path == setting.path; });
  changes_.push_back(std::move(setting));
}

void InputLogWriter::checkpoint(std::uint64_t hash) { writeHash("check", hash); }
void InputLogWriter::end(std::uint64_t hash) { writeHash("end", hash); }

bool InputLogWriter::isFull() const {
  return steps_ >= InputLog::kMaxSteps || changeCount_ + changes_.size() > InputLog::kMaxChanges;
}

std::string InputLogWriter::take() {
  writeRun();
  return std::exchange(text_, {});
}

void InputLogWriter::writeRun() {
  if (run_.steps == 0) return;
  text_ += "[" + std::to_string(run_.steps);
  const QuantisedControls& c = run_.controls;
  if (writtenControls_ != c) {
    for (const int value : {int{c.thrust}, int{c.brake}, int{c.pitch}, int{c.roll}, int{c.yaw},
                            (c.drop ? 1 : 0) + (c.reset ? 2 : 0)}) {
      text_ += "," + std::to_string(value);
    }
  }
  text_ += "]\n";
  writtenControls_ = c;
  run_.steps = 0;
}

void InputLogWriter::writeHash(std::string_view kind, std::uint64_t hash) {
  writeRun();
  text_ += "[\"" + std::string(kind) + "\"," + std::to_string(steps_) + ",\"" + hexText(hash) + "\"]\n";
}

std::string encodeInputLog(const InputLog& log) {
  InputLogWriter writer(log);
  std::size_t change = 0, checkpoint = 0, run = 0;
  std::uint64_t step = 0, runEnd = log.runs.empty() ? 0 : log.runs.front().steps;
  while (true) {
    for (; checkpoint < log.checkpoints.size() && log.checkpoints[checkpoint].step == step; ++checkpoint) {
      const bool isEnd = log.ended && checkpoint + 1 == log.checkpoints.size();
      isEnd ? writer.end(log.checkpoints[checkpoint].hash)
            : writer.checkpoint(log.checkpoints[checkpoint].hash);
    }
    for (; change < log.changes.size() && log.changes[change].step == step; ++change)
      writer.change(log.changes[change].setting);
    if (run == log.runs.size()) return writer.take();
    std::uint64_t next = runEnd;
    if (change < log.changes.size()) next = std::min(next, log.changes[change].step);
    if (checkpoint < log.checkpoints.size()) next = std::min(next, log.checkpoints[checkpoint].step);
    writer.append(log.runs[run].controls, next - step);
    step = next;
    if (step == runEnd && ++run < log.runs.size()) runEnd += log.runs[run].steps;
  }
}

InputLog decodeInputLog(std::string_view text, std::string_view file) {
  return isSchema2(text) ? decodeSchema2(text, file) : decodeSchema1(text, file);
}

std::uint64_t sceneDigest(std::string_view text) {
  core::StateHasher hasher;
  hasher.add(static_cast<std::uint64_t>(text.size()));
  for (std::size_t at = 0; at < text.size(); at += sizeof(std::uint64_t)) {
    const std::string_view piece = text.substr(at, sizeof(std::uint64_t));
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < piece.size(); ++i)
      word |= static_cast<std::uint64_t>(static_cast<unsigned char>(piece[i])) << (8 * i);
    hasher.add(word);
  }
  return hasher.value();
}

InputLog readInputLog(const std::filesystem::path& file) {
  return decodeInputLog(core::readTextInput(file, InputLog::kMaxBytes), core::inputName(file));
}

std::optional<std::uint64_t> InputReplay::hashDue() {
  if (checkpoint_ == log_->checkpoints.size() || log_->checkpoints[checkpoint_].step > step_)
    return std::nullopt;
  return log_->checkpoints[checkpoint_++].hash;
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
