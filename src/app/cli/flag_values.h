// The values of flags, from the words of a command line. Each throws core::UsageError that names the flag, in
// one form for all flags.
#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <system_error>

#include "app/types/command_line.h"

namespace skydrop::app {

// The number that the whole text is; nullopt for any other text.
template <class Number>
std::optional<Number> wholeText(const std::string& text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// Finite, within [least, most].
double number(const std::string& flag, const std::string& text, double least, double most);
int integer(const std::string& flag, const std::string& text, int least, int most);

Size parseSize(const std::string& text);  // --size WxH
// --pose X,Y,Z,YAW,PITCH,ROLL and --camera X,Y,Z: metres, degrees.
Pose parsePose(const std::string& text);
glm::dvec3 parseCamera(const std::string& text);
glm::dvec3 parseAt(const std::string& text);  // --at X,Y,Z, metres
render::gl::Backend parseBackend(const std::string& text);
NoiseFormat parseNoiseFormat(const std::string& text);
ReportFormat parseReportFormat(const std::string& text);
forecast::Provider parseProvider(const std::string& flag, const std::string& text);
sky::Instant parseUtc(const std::string& text);

}  // namespace skydrop::app
