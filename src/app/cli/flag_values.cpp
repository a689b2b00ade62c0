#include "app/cli/flag_values.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <map>

#include "skydrop/core/error.h"
#include "skydrop/render/frame/camera.h"

namespace skydrop::app {
namespace {

using core::UsageError;

constexpr double kFarthestM = 1e12;  // where doubles still resolve a tenth of a millimetre

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

}  // namespace

double number(const std::string& flag, const std::string& text, double least, double most) {
  const std::optional<double> value = wholeText<double>(text);
  if (!value || !std::isfinite(*value)) throw UsageError(flag + ": '" + text + "' is not a finite number");
  if (*value < least || *value > most) {
    throw UsageError(flag + ": " + text + " is out of range " + CLI::detail::to_string(least) + " to " +
                     CLI::detail::to_string(most));
  }
  return *value;
}

int integer(const std::string& flag, const std::string& text, int least, int most) {
  const std::optional<int> value = wholeText<int>(text);
  if (!value) throw UsageError(flag + ": '" + text + "' is not a whole number");
  return static_cast<int>(number(flag, text, least, most));
}

Size parseSize(const std::string& text) {
  const std::vector<std::string> parts = split(text, 'x');
  if (parts.size() != 2) throw UsageError("--size: '" + text + "' is not of the form WIDTHxHEIGHT");
  return {integer("--size", parts[0], 1, kMaxSide), integer("--size", parts[1], 1, kMaxSide)};
}

static glm::dvec3 cameraPosition(const std::string& flag, const std::vector<std::string>& parts) {
  return {number(flag, parts[0], -kFarthestM, kFarthestM),
          number(flag, parts[1], -kFarthestM, render::kHighestCameraM),
          number(flag, parts[2], -kFarthestM, kFarthestM)};
}

Pose parsePose(const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() != 6) throw UsageError("--pose: '" + text + "' is not of the form X,Y,Z,YAW,PITCH,ROLL");
  const auto degrees = [&](std::size_t i) { return number("--pose", parts[i], -360, 360); };
  return {cameraPosition("--pose", parts), degrees(3), degrees(4), degrees(5)};
}

glm::dvec3 parseCamera(const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() != 3) throw UsageError("--camera: '" + text + "' is not of the form X,Y,Z");
  return cameraPosition("--camera", parts);
}

glm::dvec3 parseAt(const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() != 3) throw UsageError("--at: '" + text + "' is not of the form X,Y,Z");
  return cameraPosition("--at", parts);
}

render::gl::Backend parseBackend(const std::string& text) {
  using render::gl::Backend;
  static const std::map<std::string, Backend> names = {
      {"egl", Backend::egl}, {"osmesa", Backend::osmesa}, {"window", Backend::window}};
  const auto found = names.find(text);
  if (found == names.end()) throw UsageError("--backend: '" + text + "' is not one of egl osmesa window");
  return found->second;
}

forecast::Provider parseProvider(const std::string& flag, const std::string& text) {
  static const std::map<std::string, forecast::Provider> names = {
      {"meteoblue", forecast::Provider::meteoblue},
      {"open-meteo", forecast::Provider::openMeteo},
      {"metar", forecast::Provider::metar}};
  const auto found = names.find(text);
  if (found == names.end())
    throw UsageError(flag + ": '" + text + "' is not one of meteoblue open-meteo metar");
  return found->second;
}

NoiseFormat parseNoiseFormat(const std::string& text) {
  static const std::map<std::string, NoiseFormat> names = {
      {"dds", NoiseFormat::dds}, {"dx10", NoiseFormat::dx10}, {"png", NoiseFormat::png}};
  const auto found = names.find(text);
  if (found == names.end()) throw UsageError("--format: '" + text + "' is not one of dds dx10 png");
  return found->second;
}

sky::Instant parseUtc(const std::string& text) {
  sky::Instant instant;
  const std::string reason = sky::readInstant(text, instant);
  if (!reason.empty()) throw UsageError("--utc: '" + text + "' " + reason);
  return instant;
}

ReportFormat parseReportFormat(const std::string& text) {
  static const std::map<std::string, ReportFormat> names = {
      {"markdown", ReportFormat::markdown}, {"json", ReportFormat::json}, {"csv", ReportFormat::csv}};
  const auto found = names.find(text);
  if (found == names.end()) throw UsageError("--format: '" + text + "' is not one of markdown json csv");
  return found->second;
}

}  // namespace skydrop::app
