#include <algorithm>
#include <chrono>
#include <cmath>
#include <system_error>
#include <utility>

#include "skydrop/core/deterministic_math.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/hash.h"
#include "skydrop/forecast/forecast_of.h"
#include "skydrop/forecast/read_report.h"

namespace skydrop::forecast {
namespace {

constexpr double kMPerDegree = 111'195;  // of latitude, on a sphere of 6371 km

sky::Instant now() {
  using namespace std::chrono;
  return {duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count()};
}

sky::Instant writtenAt(const std::filesystem::path& file) {
  using namespace std::chrono;
  std::error_code error;
  const auto time = std::filesystem::last_write_time(file, error);
  if (error) return now();
  const auto ms = duration_cast<milliseconds>(file_clock::to_sys(time).time_since_epoch()).count();
  return {std::clamp<std::int64_t>(ms, sky::kFirstInstant.utcMs, sky::kLastInstant.utcMs)};
}

std::optional<glm::dvec2> wayBetween(const Report& from, const Report& to) {
  if (!from.latitudeDegrees || !from.longitudeDegrees || !to.latitudeDegrees || !to.longitudeDegrees)
    return std::nullopt;
  const double north = *to.latitudeDegrees - *from.latitudeDegrees;
  double east = *to.longitudeDegrees - *from.longitudeDegrees;
  east -= 360 * std::round(east / 360);
  const double middle = (*to.latitudeDegrees + *from.latitudeDegrees) / 2 * core::dmath::kRadPerDeg;
  const glm::dvec2 way(east * kMPerDegree * core::dmath::cos(middle), north * kMPerDegree);
  if (way.x * way.x + way.y * way.y < 1) return std::nullopt;
  return way;
}

weather::Timeline timelineOf(const Report& report, weather::State (*state)(const Hour&, const Ground&)) {
  std::vector<weather::TimedState> states;
  states.reserve(report.hours.size());
  for (const Hour& hour : report.hours) states.push_back({hour.utcMs, state(hour, groundOf(report))});
  try {
    return weather::Timeline(std::move(states));
  } catch (const core::RangeError& error) {
    throw core::DataError(report.file, "", error.what());
  }
}

void addNotes(const Report& report, std::vector<std::string>& notes) {
  for (const std::string& note : report.notes) notes.push_back(report.file + ": " + note);
}

}  // namespace

std::uint64_t contentDigest(std::string_view text) {
  core::StateHasher hasher;
  hasher.add(static_cast<std::uint64_t>(text.size()));
  for (std::size_t at = 0; at < text.size(); at += sizeof(std::uint64_t)) {
    std::uint64_t word = 0;
    int shift = 0;
    for (const char c : text.substr(at, sizeof(std::uint64_t)))
      word |= static_cast<std::uint64_t>(static_cast<unsigned char>(c)) << (8 * shift++);
    hasher.add(word);
  }
  return hasher.value();
}

FileReport readReportFile(const std::filesystem::path& file, std::optional<sky::Instant> about) {
  const std::string text = core::readTextInput(file, kMostBytes);
  if (!about) about = core::isStandardInput(file) ? now() : writtenAt(file);
  return {readReport(text, core::inputName(file), *about), contentDigest(text)};
}

weather::Forecast forecastOf(Report near, std::optional<Report> far, std::uint64_t digest) {
  fillGaps(near);
  if (far) fillGaps(*far);
  weather::Timeline nearStates = timelineOf(near, stateOf);
  weather::Timeline farStates = far ? timelineOf(*far, stateOf) : timelineOf(near, farStateOf);
  return {std::move(nearStates), std::move(farStates), far ? wayBetween(near, *far) : std::nullopt, digest};
}

FileForecast readForecast(const Files& near, const Files& far, std::optional<sky::Instant> about) {
  FileForecast out;
  std::uint64_t digest = 0;
  const auto readAll = [&](const Files& files, std::vector<std::uint64_t>& digests) {
    std::vector<Report> reports;
    for (const std::filesystem::path& file : files) {
      FileReport read = readReportFile(file, about);
      digests.push_back(read.digest);
      digest = core::hashCombine(digest, read.digest);
      addNotes(read.report, out.notes);
      reports.push_back(std::move(read.report));
    }
    return merged(std::move(reports));
  };
  Report first = readAll(near, out.nearDigests);
  std::optional<Report> second;
  if (!far.empty()) second = readAll(far, out.farDigests);
  out.forecast =
      std::make_shared<const weather::Forecast>(forecastOf(std::move(first), std::move(second), digest));
  return out;
}

}  // namespace skydrop::forecast
