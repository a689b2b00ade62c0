#include "app/session/flight_trace.h"

#include <array>
#include <charconv>
#include <glm/trigonometric.hpp>
#include <string_view>

#include "skydrop/core/fixed_step.h"

namespace skydrop::app {
namespace {

struct Column {
  std::string_view name;
  double (*value)(const game::Snapshot&);
};

using S = game::Snapshot;
constexpr std::array<Column, 30> kColumns = {{
    {"time_s", [](const S& s) { return s.simulatedSeconds; }},
    {"thrust", [](const S& s) { return s.aircraft.controls.thrust; }},
    {"brake", [](const S& s) { return s.aircraft.controls.brake; }},
    {"pitch", [](const S& s) { return s.aircraft.controls.pitch; }},
    {"roll", [](const S& s) { return s.aircraft.controls.roll; }},
    {"yaw", [](const S& s) { return s.aircraft.controls.yaw; }},
    {"x_m", [](const S& s) { return s.aircraft.position.x; }},
    {"y_m", [](const S& s) { return s.aircraft.position.y; }},
    {"z_m", [](const S& s) { return s.aircraft.position.z; }},
    {"velocity_x_mps", [](const S& s) { return s.aircraft.velocity.x; }},
    {"velocity_y_mps", [](const S& s) { return s.aircraft.velocity.y; }},
    {"velocity_z_mps", [](const S& s) { return s.aircraft.velocity.z; }},
    {"height_above_ground_m", [](const S& s) { return s.aircraft.heightAboveGround; }},
    {"airspeed_mps", [](const S& s) { return s.aircraft.airspeedMps; }},
    {"throttle", [](const S& s) { return s.aircraft.throttle; }},
    {"heading_deg", [](const S& s) { return glm::degrees(s.aircraft.headingRad); }},
    {"pitch_deg", [](const S& s) { return glm::degrees(s.aircraft.pitchRad); }},
    {"bank_deg", [](const S& s) { return glm::degrees(s.aircraft.bankRad); }},
    // Rates by the pilot's signs: nose up, right wing down, nose right.
    {"pitch_rate_dps", [](const S& s) { return glm::degrees(s.aircraft.angularVelocityBody.x); }},
    {"roll_rate_dps", [](const S& s) { return -glm::degrees(s.aircraft.angularVelocityBody.z); }},
    {"yaw_rate_dps", [](const S& s) { return -glm::degrees(s.aircraft.angularVelocityBody.y); }},
    {"angle_of_attack_deg", [](const S& s) { return glm::degrees(s.aircraft.angleOfAttackRad); }},
    {"sideslip_deg", [](const S& s) { return glm::degrees(s.aircraft.sideslipRad); }},
    {"load_factor", [](const S& s) { return s.aircraft.loadFactor; }},
    {"stall_warning", [](const S& s) { return s.aircraft.stallWarning ? 1.0 : 0.0; }},
    {"stalled", [](const S& s) { return s.aircraft.stalled ? 1.0 : 0.0; }},
    {"buffet", [](const S& s) { return s.aircraft.buffet; }},
    {"crashed", [](const S& s) { return s.aircraft.crashed ? 1.0 : 0.0; }},
    {"score", [](const S& s) { return static_cast<double>(s.score); }},
    {"drops", [](const S& s) { return static_cast<double>(s.drops); }},
}};

}  // namespace

FlightTrace::FlightTrace(const std::filesystem::path& file) : file_(file, RecordFile::Existing::replaced) {
  for (const Column& column : kColumns) rows_.append(rows_.empty() ? "" : ",").append(column.name);
  rows_ += '\n';
  flush();
}

void FlightTrace::append(const game::Snapshot& snapshot) {
  char separator = 0;
  for (const Column& column : kColumns) {
    if (separator) rows_ += separator;
    separator = ',';
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), column.value(snapshot));
    rows_.append(digits.data(), end.ptr);
  }
  rows_ += '\n';
  if (++rowCount_ == core::FixedStep::kStepsPerSecond) flush();
}

void FlightTrace::flush() {
  file_.append(rows_);
  rows_.clear();
  rowCount_ = 0;
}

}  // namespace skydrop::app
