#include "ui/field_label.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <utility>

namespace skydrop::ui {
namespace {

using core::Field;
using core::FieldKind;
using core::TakesEffect;

constexpr int kDigits = 5;       // significant; the thesis's defaults have as many
constexpr int kMostDigits = 12;  // of a logarithmic slider that starts very low
constexpr double kHugeRange = 1e15;

std::string numberText(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", value);
  return buffer;
}

std::string valueText(const Field& field, double value) {
  if (field.kind == FieldKind::flag) return value != 0 ? "on" : "off";
  if (field.kind == FieldKind::choice) {
    const auto index = static_cast<std::size_t>(value);
    return index < field.names.size() ? field.names[index] : "";
  }
  if (field.written) return core::writtenText(field, value);
  return numberText(value);
}

std::string_view effectText(TakesEffect effect) {
  switch (effect) {
    case TakesEffect::live:
      return "Takes effect at once.";
    case TakesEffect::liveRebuild:
      return "Takes effect at once; each change rebuilds a part.";
    case TakesEffect::variant:
      return "Compiles a shader when released.";
    case TakesEffect::rebuild:
      return "Rebuilds a part when released.";
    case TakesEffect::restart:
      return "Loads the flight again when released.";
  }
  return "";
}

// "m/s^2" with a raised 2.
std::string raisedPowers(std::string unit) {
  for (const auto& [plain, raised] : {std::pair("^2", "\u00b2"), std::pair("^3", "\u00b3")}) {
    for (std::size_t at; (at = unit.find(plain)) != std::string::npos;) unit.replace(at, 2, raised);
  }
  return unit;
}

bool hasUnit(const Field& field) { return !field.unit.empty() && field.unit != "1"; }

std::string describedText(const Field& field, const std::string& note) {
  std::string text = field.help;
  if (!text.empty() && text.back() != '.') text += '.';
  if (!note.empty()) text += "\n" + note;
  if (!field.aliases.empty()) text += "\nAlso called " + field.aliases + ".";
  const std::string unit = hasUnit(field) ? " " + raisedPowers(field.unit) : "";
  if (field.kind == FieldKind::number || field.kind == FieldKind::integer) {
    const auto range = [&](double low, double high) {
      return valueText(field, low) + " to " + valueText(field, high) + unit;
    };
    const bool isPart = field.sliderMin != field.min || field.sliderMax != field.max;
    if (isPart) text += "\nSlider " + range(field.sliderMin, field.sliderMax) + ".";
    if (field.max - field.min < kHugeRange)
      text += std::string(isPart ? "\nTyped " : "\nRange ") + range(field.min, field.max) + ".";
  }
  text += "\nDefault " + valueText(field, field.defaultValue) +
          (field.kind == FieldKind::flag || field.kind == FieldKind::choice ? "" : unit) + ".";
  return text + "\n" + std::string(effectText(field.takesEffect)) + "\n" + field.path;
}

}  // namespace

std::string humanName(std::string_view name) {
  std::string words;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto c = static_cast<unsigned char>(name[i]);
    const bool upper = std::isupper(c) != 0;
    const bool afterLower = i > 0 && !std::isupper(static_cast<unsigned char>(name[i - 1]));
    const bool beforeLower = i + 1 < name.size() && std::islower(static_cast<unsigned char>(name[i + 1]));
    if (upper && i > 0 && (afterLower || beforeLower)) words += ' ';
    // An abbreviation stays in capitals: "screenErrorLOD" -> "Screen error LOD".
    const bool abbreviation = upper && !beforeLower && !(i + 1 == name.size() && afterLower);
    words += static_cast<char>(i == 0 ? std::toupper(c) : abbreviation ? c : std::tolower(c));
  }
  return words;
}

std::string unitText(const Field& field) { return hasUnit(field) ? raisedPowers(field.unit) : ""; }

std::string_view withoutUnit(const Field& field, std::string_view text) {
  const auto trim = [&] {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  };
  trim();
  if (!hasUnit(field)) return text;
  for (const std::string& unit : {field.unit, raisedPowers(field.unit)}) {
    if (text.size() > unit.size() && text.ends_with(unit)) {
      text.remove_suffix(unit.size());
      break;
    }
  }
  trim();
  return text;
}

std::string sliderFormat(const Field& field) {
  std::string format = "%lld";
  if (field.kind == FieldKind::number) {
    int digits = kDigits;
    // Dear ImGui takes values under 10^-digits for zero on a logarithmic slider.
    if (field.logarithmic && field.sliderMin > 0) {
      digits = std::clamp(static_cast<int>(std::ceil(-std::log10(field.sliderMin))), kDigits, kMostDigits);
    }
    format = "%." + std::to_string(digits) + "g";
  }
  if (!hasUnit(field)) return format;
  format += ' ';
  for (const char c : raisedPowers(field.unit)) format += c == '%' ? std::string("%%") : std::string(1, c);
  return format;
}

std::string noteText(const Field& field) { return field.note ? field.note() : ""; }

std::string tooltipText(const Field& field) { return describedText(field, noteText(field)); }

std::string searchText(const Field& field) { return describedText(field, ""); }

}  // namespace skydrop::ui
