// The readers of each provider; read_report.cpp chooses. Each throws core::DataError.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "skydrop/forecast/read_report.h"

namespace skydrop::forecast {

Report readMeteoblue(const nlohmann::json& root, std::string_view file);
Report readOpenMeteo(const nlohmann::json& root, std::string_view file);
Report readMetar(std::string_view text, std::string_view file, sky::Instant about);
// Whether a text has the head of a METAR, station and time, anywhere.
bool looksLikeMetar(std::string_view text);

// What the meteorological codes of models and services say.
Phenomena phenomenaOfPictocode(int code);  // meteoblue, hourly, 1 .. 35
Phenomena phenomenaOfWmoCode(int code);    // WMO 4677 as Open-Meteo uses it, 0 .. 99

}  // namespace skydrop::forecast
