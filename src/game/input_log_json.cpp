#include "game/input_log_json.h"

#include <charconv>

#include "skydrop/core/error.h"

namespace skydrop::game {

void LogEvents::fail(std::string_view where, std::string_view reason) const {
  throw core::DataError(file_, where, reason);
}

void LogEvents::wrong(std::string_view what) const {
  fail(place(), std::string(what) + " does not belong here");
}

void LogEvents::requireText(const std::string& value, std::size_t most) const {
  if (value.size() > most) fail(place(), "a text of more than " + std::to_string(most) + " characters");
}

InputLog::Run makeRun(const std::array<std::int64_t, 7>& row, std::uint64_t stepsBefore,
                      std::string_view file, const std::string& place) {
  const auto within = [&](std::size_t column, std::int64_t low, std::int64_t high) {
    if (row[column] < low || row[column] > high) {
      throw core::DataError(
          file, place + "[" + std::to_string(column) + "]",
          std::to_string(row[column]) + " is outside " + std::to_string(low) + " .. " + std::to_string(high));
    }
    return row[column];
  };
  InputLog::Run run;
  run.steps =
      static_cast<std::uint64_t>(within(0, 1, static_cast<std::int64_t>(InputLog::kMaxSteps - stepsBefore)));
  run.controls.thrust = static_cast<std::int8_t>(within(1, 0, 127));
  run.controls.brake = static_cast<std::int8_t>(within(2, 0, 127));
  run.controls.pitch = static_cast<std::int8_t>(within(3, -127, 127));
  run.controls.roll = static_cast<std::int8_t>(within(4, -127, 127));
  run.controls.yaw = static_cast<std::int8_t>(within(5, -127, 127));
  const std::int64_t flags = within(6, 0, 3);
  run.controls.drop = (flags & 1) != 0;
  run.controls.reset = (flags & 2) != 0;
  return run;
}

std::optional<std::uint64_t> parseHash(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace skydrop::game
