#include "forecast/times.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "skydrop/core/error.h"
#include "skydrop/core/json.h"
#include "skydrop/sky/instant.h"

namespace skydrop::forecast {
namespace {

constexpr std::int64_t kHourMs = 3'600'000;

// Whether the text of an instant says its zone: 2025-06-23T00:00+00:00, 2025-06-23T00:00Z.
bool hasZone(std::string_view text) {
  return text.size() > 10 && text.find_first_of("Zz+-", 10) != std::string_view::npos;
}

std::string localText(std::int64_t ms) {
  std::string text = sky::instantText({ms});
  text.resize(std::min<std::size_t>(text.size(), 16));
  return text;
}

bool isMonthOfSpringForward(std::int64_t ms) {
  using namespace std::chrono;
  const year_month_day date(floor<days>(sys_time<milliseconds>(milliseconds(ms))));
  const auto month = static_cast<unsigned>(date.month());
  return month == 3 || month == 4 || month == 9 || month == 10;
}

// Where exactly one hour is left out of an hourly table, and nothing else is uneven; 0 without.
std::size_t hourLeftOut(const std::vector<std::int64_t>& local) {
  std::size_t found = 0;
  for (std::size_t i = 1; i < local.size(); ++i) {
    const std::int64_t step = local[i] - local[i - 1];
    if (step == kHourMs) continue;
    if (step != 2 * kHourMs || found > 0) return 0;
    found = i;
  }
  return found > 0 && local.size() > 3 && isMonthOfSpringForward(local[found]) ? found : 0;
}

// From the readings of a local clock to one that runs evenly.
void followClock(std::vector<std::int64_t>& local, std::vector<std::string>& notes) {
  if (const std::size_t at = hourLeftOut(local); at > 0) {
    notes.push_back("the local clock is put forward an hour before " + localText(local[at]));
    for (std::size_t i = at; i < local.size(); ++i) local[i] -= kHourMs;
    return;
  }
  for (std::size_t i = 1; i < local.size(); ++i) {
    if (local[i] != local[i - 1]) continue;
    const bool isHourly = i < 2 || local[i - 1] - local[i - 2] == kHourMs;
    const bool goesOnHourly = i + 1 == local.size() || local[i + 1] - local[i] == kHourMs;
    if (!isHourly || !goesOnHourly) return;
    notes.push_back("the local clock is put back an hour at " + localText(local[i]));
    for (std::size_t k = i; k < local.size(); ++k) local[k] += kHourMs;
    return;
  }
}

}  // namespace

std::vector<std::int64_t> readTimes(const HourlyTable& table, const TimeForm& form,
                                    std::vector<std::string>& notes) {
  const nlohmann::json& times = table.times();
  std::vector<std::int64_t> out;
  out.reserve(times.size());
  bool isLocal = true;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const auto fail = [&](const std::string& reason) {
      throw core::DataError(table.file(), table.placeOf("time", i), reason);
    };
    sky::Instant instant;
    if (times[i].is_string()) {
      const auto& text = times[i].get_ref<const std::string&>();
      if (const std::string reason = sky::readInstant(text, instant); !reason.empty())
        fail("'" + text + "' " + reason);
      isLocal = isLocal && !hasZone(text);
      if (i > 0 && (!times[i - 1].is_string() || hasZone(text) == isLocal))
        fail("is written in another form than the one before");
    } else {
      const double ms =
          core::jsonNumber(times[i], table.file(), table.placeOf("time", i), -1e14, 1e14) * form.msPerUnit;
      if (ms < static_cast<double>(sky::kFirstInstant.utcMs) ||
          ms > static_cast<double>(sky::kLastInstant.utcMs))
        fail("is not within the years 1000 to 3000");
      if (i > 0 && times[i - 1].is_string()) fail("is written in another form than the one before");
      instant.utcMs = static_cast<std::int64_t>(std::llround(ms));
      isLocal = false;
    }
    out.push_back(instant.utcMs);
  }
  if (isLocal) {
    followClock(out, notes);
    const auto offset =
        static_cast<std::int64_t>(std::llround(form.offsetHours * static_cast<double>(kHourMs)));
    for (std::int64_t& ms : out) ms -= offset;
  }
  for (std::size_t i = 1; i < out.size(); ++i) {
    if (out[i] > out[i - 1]) continue;
    throw core::DataError(table.file(), table.placeOf("time", i), "is not after the one before");
  }
  return out;
}

}  // namespace skydrop::forecast
