// METAR and SPECI (WMO No. 306, FM 15 and FM 16), as they are found: groups may come in any order, and one
// that is not understood is noted and left out.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <utility>

#include "forecast/readers.h"
#include "forecast/units.h"
#include "skydrop/core/error.h"

namespace skydrop::forecast {
namespace {

constexpr double kFarM = 30000;  // of "10 km or more"
constexpr double kMPerMile = 1609.344, kMPerFoot = 0.3048, kHpaPerInch = 33.8639;
constexpr std::int64_t kDayMs = 86'400'000;
constexpr std::size_t kMostNotes = 20;

struct Token {
  std::string_view text;
  std::size_t line = 1;
};

std::vector<Token> tokensOf(std::string_view text) {
  std::vector<Token> tokens;
  std::size_t line = 1;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == '\n') ++line;
    if (c == '\n' || c == ' ' || c == '\t' || c == '\r' || c == '=') {
      ++at;
      continue;
    }
    const std::size_t end = std::min(text.find_first_of(" \t\r\n=", at), text.size());
    tokens.push_back({text.substr(at, end - at), line});
    at = end;
  }
  return tokens;
}

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isUpper(char c) { return c >= 'A' && c <= 'Z'; }

// Takes pieces off the front of a group.
struct Scanner {
  std::string_view rest;

  bool take(std::string_view text) {
    if (!rest.starts_with(text)) return false;
    rest.remove_prefix(text.size());
    return true;
  }
  // So many digits; fewer only down to `least`.
  std::optional<int> digits(std::size_t least, std::size_t most) {
    std::size_t count = 0;
    int value = 0;
    while (count < most && count < rest.size() && isDigit(rest[count]))
      value = value * 10 + (rest[count++] - '0');
    if (count < least) return std::nullopt;
    rest.remove_prefix(count);
    return value;
  }
  bool done() const { return rest.empty(); }
};

bool isTime(std::string_view text) {
  return text.size() == 7 && text.back() == 'Z' && std::all_of(text.begin(), text.end() - 1, isDigit);
}

bool isStation(std::string_view text) {
  return text.size() == 4 && isUpper(text[0]) &&
         std::ranges::all_of(text, [](char c) { return isUpper(c) || isDigit(c); });
}

// One report, group by group.
class ReportReader {
 public:
  explicit ReportReader(Hour& hour) : hour_(hour) { hour_.phenomena = Phenomena(); }

  // False where the group is not understood. `next`: the group after it; taken along where true comes back
  // in `tookNext`.
  bool read(std::string_view group, std::string_view next, bool& tookNext) {
    if (group == "AUTO" || group == "COR" || group == "CCA" || group == "//" || group == "NOSIG") return true;
    if (group == "CAVOK") {
      hour_[Quantity::visibilityM] = kFarM;
      layers_.clear();
      sawSky_ = true;
      return true;
    }
    return readWind(group) || readVisibility(group, next, tookNext) || readSky(group) ||
           readTemperatures(group) || readPressure(group) || readWeather(group) || isPassedOver(group);
  }

  void finish() {
    if (sawSky_) {
      std::ranges::stable_sort(layers_, {}, &SeenLayer::baseM);
      double most = 0;
      for (const SeenLayer& layer : layers_) {
        most = std::max(most, layer.cover);
        hour_.phenomena->towers = hour_.phenomena->towers || layer.cumulonimbus || layer.toweringCumulus;
      }
      hour_[Quantity::totalCover] = most;  // amounts are those of the sky up to their layer
      hour_.layers = layers_;
    }
    hour_[Quantity::precipitationMm] = rain_ + snow_;
    if (rain_ + snow_ > 0) hour_[Quantity::snowShare] = snow_ / (rain_ + snow_);
    if (rain_ + snow_ > 0) hour_[Quantity::convectiveMm] = showers_ ? rain_ + snow_ : 0;
  }

 private:
  bool readWind(std::string_view group) {
    Scanner s{group};
    std::optional<int> from;
    if (!s.take("VRB") && !s.take("///")) {
      from = s.digits(3, 3);
      if (!from) return false;
    }
    std::optional<int> speed;
    if (!s.take("//")) {
      s.take("P");
      speed = s.digits(2, 3);
      if (!speed) return false;
    }
    std::optional<int> gust;
    if (s.take("G") && !s.take("//")) {
      s.take("P");
      gust = s.digits(2, 3);
      if (!gust) return false;
    }
    double unit = 0;
    if (s.take("KT"))
      unit = 1852.0 / 3600;
    else if (s.take("MPS"))
      unit = 1;
    else if (s.take("KMH"))
      unit = 1 / 3.6;
    const bool isUnknown = !speed && s.done();  // "/////"
    if ((unit == 0 && !isUnknown) || !s.done() || (from && *from > 360)) return false;
    if (speed && *speed * unit > 110) return false;
    if (speed) hour_[Quantity::windMps] = *speed * unit;
    if (gust && *gust * unit <= 150) hour_[Quantity::gustMps] = *gust * unit;
    if (from && speed.value_or(0) > 0) hour_[Quantity::windFromDeg] = turned(*from);
    return true;
  }

  bool readVisibility(std::string_view group, std::string_view next, bool& tookNext) {
    std::optional<double>& target = hour_[Quantity::visibilityM];
    const auto set = [&](double metres) {
      if (!target) target = metres;  // what comes later is that of a sector
      return true;
    };
    if (group == "////" || group == "////SM") return true;
    Scanner metres{group};
    if (const auto m = metres.digits(4, 4)) {
      if (metres.take("NDV") || metres.done()) return metres.done() && set(*m == 9999 ? kFarM : *m);
      return metres.rest.size() <= 2 && std::ranges::all_of(metres.rest, isUpper);  // of a sector: 1200SW
    }
    if (group.ends_with("KM")) {
      Scanner s{group};
      const auto km = s.digits(1, 3);
      return km && s.take("KM") && s.done() && set(*km >= 10 ? kFarM : *km * 1000.0);
    }
    const auto miles = [](std::string_view text) -> std::optional<double> {
      Scanner s{text};
      const bool more = s.take("P");
      if (!more) s.take("M");
      const auto over = s.digits(1, 3);
      if (!over) return std::nullopt;
      double value = *over;
      if (s.take("/")) {
        const auto under = s.digits(1, 3);
        if (!under || *under == 0) return std::nullopt;
        value /= *under;
      }
      if (!s.take("SM") || !s.done()) return std::nullopt;
      return more || value >= 10 ? kFarM : value * kMPerMile;
    };
    if (const auto m = miles(group)) return set(*m);
    if (group.size() == 1 && isDigit(group[0]) && next.find('/') != std::string_view::npos) {
      if (const auto fraction = miles(next)) {
        tookNext = true;
        return set((group[0] - '0') * kMPerMile + *fraction);
      }
    }
    return false;
  }

  bool readSky(std::string_view group) {
    if (group == "CLR" || group == "SKC" || group == "NSC" || group == "NCD") {
      sawSky_ = true;
      return true;
    }
    Scanner s{group};
    if (s.take("VV")) {
      const auto feet = s.digits(3, 3);
      if (!feet && s.rest != "///") return false;
      sawSky_ = true;
      hour_.phenomena->fog = true;
      layers_.push_back({1, std::max(feet.value_or(1) * 100 * kMPerFoot, 30.0), false, false});
      return true;
    }
    double cover = 0;
    if (s.take("FEW"))
      cover = 1.5 / 8;
    else if (s.take("SCT"))
      cover = 3.5 / 8;
    else if (s.take("BKN"))
      cover = 6.0 / 8;
    else if (s.take("OVC"))
      cover = 1;
    else if (s.take("///"))
      cover = 0;
    else
      return false;
    const auto feet = s.digits(3, 3);
    if (!feet && !s.take("///")) return false;
    SeenLayer layer{cover, feet.value_or(0) * 100 * kMPerFoot, false, false};
    layer.cumulonimbus = s.take("CB");
    layer.toweringCumulus = !layer.cumulonimbus && s.take("TCU");
    s.take("///");
    if (s.rest.size() > 3 || !std::ranges::all_of(s.rest, isUpper)) return false;  // BKN090AC is taken
    if (layer.cumulonimbus || layer.toweringCumulus) {
      if (layer.cover == 0) layer.cover = 1.5 / 8;  // "//////CB": it is there, how much is not said
      if (!feet) layer.baseM = 900;
    } else if (!feet || layer.cover == 0) {
      return true;  // nothing is said
    }
    sawSky_ = true;
    layers_.push_back(layer);
    return true;
  }

  static std::optional<int> signedDegrees(Scanner& s) {
    const bool below = s.take("M");
    const auto value = s.digits(1, 2);
    if (!value) return std::nullopt;
    return below ? -*value : *value;
  }

  bool readTemperatures(std::string_view group) {
    Scanner s{group};
    const bool unknown = s.take("//");
    std::optional<int> temperature, dew;
    if (!unknown && !(temperature = signedDegrees(s))) return false;
    if (!s.take("/")) return false;
    if (!s.done() && !s.take("//") && !(dew = signedDegrees(s))) return false;
    if (!s.done() || (temperature && *temperature > 60) || (dew && *dew > 60)) return false;
    if (temperature) hour_[Quantity::temperatureC] = *temperature;
    if (dew) hour_[Quantity::dewPointC] = *dew;
    return true;
  }

  bool readPressure(std::string_view group) {
    Scanner s{group};
    const bool hpa = s.take("Q");
    if (!hpa && !s.take("A")) return false;
    if (s.rest == "////") return true;
    const auto value = s.digits(4, 4);
    if (!value || !s.done()) return false;
    const double pressure = hpa ? *value : *value / 100.0 * kHpaPerInch;
    if (pressure < 850 || pressure > 1100) return false;
    hour_[Quantity::pressureHpa] = pressure;
    return true;
  }

  bool readWeather(std::string_view group) {
    Scanner s{group};
    const bool near = s.take("VC");
    double strength = 1;
    if (!near && s.take("-"))
      strength = 0.35;
    else if (!near && s.take("+"))
      strength = 3;
    static constexpr std::array<std::string_view, 8> kDescriptors = {"MI", "PR", "BC", "DR",
                                                                     "BL", "SH", "TS", "FZ"};
    static constexpr std::array<std::string_view, 22> kPhenomena = {
        "DZ", "RA", "SN", "SG", "IC", "PL", "GR", "GS", "UP", "BR", "FG",
        "FU", "VA", "DU", "SA", "HZ", "PY", "PO", "SQ", "FC", "SS", "DS"};
    bool any = false, shallow = false, showers = false, thunder = false, fog = false, hail = false;
    double rain = 0, snow = 0;
    while (!s.done()) {
      const std::string_view two = s.rest.substr(0, 2);
      if (std::ranges::find(kDescriptors, two) == kDescriptors.end() &&
          std::ranges::find(kPhenomena, two) == kPhenomena.end())
        return false;
      s.rest.remove_prefix(2);
      any = true;
      shallow = shallow || two == "MI" || two == "BC" || two == "PR";
      showers = showers || two == "SH" || two == "TS";
      thunder = thunder || two == "TS";
      fog = fog || two == "FG";
      hail = hail || two == "GR" || two == "GS";
      // Moderate rates, mm/h of water (docs/forecasts.md).
      if (two == "DZ") rain += 0.5;
      if (two == "RA" || two == "UP") rain += 4;
      if (two == "SN" || two == "SG" || two == "IC" || two == "PL") snow += 1.5;
    }
    if (!any) return false;
    hour_.phenomena->thunder = hour_.phenomena->thunder || thunder;
    hour_.phenomena->towers = hour_.phenomena->towers || showers;
    if (near) return true;  // in sight, and not here
    hour_.phenomena->fog = hour_.phenomena->fog || (fog && !shallow);
    hour_.phenomena->hail = hour_.phenomena->hail || hail;
    rain_ += rain * strength;
    snow_ += snow * strength;
    showers_ = showers_ || showers;
    return true;
  }

  // What is right and says nothing that is used: variable directions, runways, recent weather.
  static bool isPassedOver(std::string_view group) {
    const auto digitsAt = [&](std::size_t from, std::size_t count) {
      return group.size() >= from + count &&
             std::all_of(group.begin() + static_cast<std::ptrdiff_t>(from),
                         group.begin() + static_cast<std::ptrdiff_t>(from + count), isDigit);
    };
    if (group.size() == 7 && group[3] == 'V' && digitsAt(0, 3) && digitsAt(4, 3)) return true;
    if (group.starts_with("R") && digitsAt(1, 2)) return true;
    if (group.starts_with("RE") && group.size() >= 4 && group.size() <= 8) return true;
    return group.starts_with("WS") || std::ranges::all_of(group, [](char c) { return c == '/'; });
  }

  Hour& hour_;
  std::vector<SeenLayer> layers_;
  bool sawSky_ = false, showers_ = false;
  double rain_ = 0, snow_ = 0;
};

// The instant of ddHHMM nearest to another one.
std::optional<std::int64_t> dated(std::string_view ddhhmm, std::int64_t about) {
  using namespace std::chrono;
  const auto pair = [&](std::size_t at) { return (ddhhmm[at] - '0') * 10 + (ddhhmm[at + 1] - '0'); };
  const int dayOfMonth = pair(0), hour = pair(2), minute = pair(4);
  if (hour > 23 || minute > 59) return std::nullopt;
  const year_month_day today(floor<days>(sys_time<milliseconds>(milliseconds(about))));
  std::optional<std::int64_t> best;
  for (int month = -1; month <= 1; ++month) {
    const year_month ym = today.year() / today.month() + months(month);
    const year_month_day date = ym / day(static_cast<unsigned>(dayOfMonth));
    if (!date.ok()) continue;
    const std::int64_t ms =
        sys_days(date).time_since_epoch().count() * kDayMs + (hour * 60 + minute) * std::int64_t{60'000};
    if (!best || std::abs(ms - about) < std::abs(*best - about)) best = ms;
  }
  return best;
}

// "2026/11/27": the date of the report that follows, as some services write it.
std::optional<std::int64_t> dateOf(std::string_view text) {
  if (text.size() != 10 || text[4] != '/' || text[7] != '/') return std::nullopt;
  std::string iso(text);
  iso[4] = iso[7] = '-';
  sky::Instant instant;
  return sky::readInstant(iso, instant).empty() ? std::optional(instant.utcMs + kDayMs / 2) : std::nullopt;
}

bool isHead(const std::vector<Token>& tokens, std::size_t at) {
  return at + 1 < tokens.size() && isStation(tokens[at].text) && isTime(tokens[at + 1].text);
}

}  // namespace

bool looksLikeMetar(std::string_view text) {
  const std::vector<Token> tokens = tokensOf(text.substr(0, 4096));
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (isHead(tokens, i)) return true;
  }
  return false;
}

Report readMetar(std::string_view text, std::string_view file, sky::Instant about) {
  Report report;
  report.provider = Provider::metar;
  report.file = file;
  const std::vector<Token> tokens = tokensOf(text);
  std::map<std::int64_t, Hour> hours;
  std::int64_t near = about.utcMs;
  std::size_t notUnderstood = 0;
  for (std::size_t i = 0; i < tokens.size();) {
    if (const auto date = dateOf(tokens[i].text)) near = *date;
    if (!isHead(tokens, i)) {
      ++i;
      continue;
    }
    const std::string line = "line " + std::to_string(tokens[i].line);
    const std::string station(tokens[i].text);
    if (report.place.empty()) report.place = station;
    if (report.place != station)
      throw core::DataError(file, line, "is a report of " + station + ", the first is of " + report.place);
    const auto time = dated(tokens[i + 1].text, near);
    if (!time)
      throw core::DataError(file, line,
                            "'" + std::string(tokens[i + 1].text) + "' is no day, hour and minute");
    Hour hour;
    hour.utcMs = *time;
    ReportReader reader(hour);
    bool isOver = false, isNil = false;
    for (i += 2; i < tokens.size() && !isHead(tokens, i) && !dateOf(tokens[i].text); ++i) {
      const std::string_view group = tokens[i].text;
      if (group == "METAR" || group == "SPECI") break;
      if (group == "RMK" || group == "TEMPO" || group == "BECMG") isOver = true;
      if (group == "NIL") isNil = true;
      if (isOver) continue;
      bool tookNext = false;
      const std::string_view next = i + 1 < tokens.size() ? tokens[i + 1].text : std::string_view();
      const std::size_t lineNow = tokens[i].line;
      if (!reader.read(group, next, tookNext) && group != "NIL" && ++notUnderstood <= kMostNotes)
        report.notes.push_back("line " + std::to_string(lineNow) + ": '" + std::string(group.substr(0, 40)) +
                               "' is not understood, and left out");
      if (tookNext) ++i;
    }
    if (isNil) continue;
    reader.finish();
    hours.insert_or_assign(hour.utcMs, std::move(hour));  // a corrected report comes after the first
    if (hours.size() > kMostHours)
      throw core::DataError(file, line, "there are more than " + std::to_string(kMostHours) + " reports");
  }
  if (hours.empty()) throw core::DataError(file, "line 1", "there is no report in it");
  if (notUnderstood > kMostNotes)
    report.notes.push_back(std::to_string(notUnderstood - kMostNotes) + " more groups are not understood");
  for (auto& [ms, hour] : hours) report.hours.push_back(std::move(hour));
  return report;
}

}  // namespace skydrop::forecast
