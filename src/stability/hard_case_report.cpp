#include "skydrop/stability/hard_case_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "skydrop/core/assets.h"
#include "skydrop/core/file.h"
#include "stability/record_json.h"

namespace skydrop::stability {
namespace {

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return std::isnan(value) ? "no number" : text.data();
}

// "3.1", "exact" where any fault would be too many, "endless" where the figure is 0 of what may be more.
std::string marginText(double figure, const Limit& limit) {
  if (limit.sense == Sense::none) return figure == 0 ? "exact" : "broken";
  const double margin = marginOf(figure, limit);
  if (!std::isfinite(margin)) return margin > 0 ? "endless" : "broken";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), margin < 100 ? "%.2f" : "%.3g", margin);
  return text.data();
}

std::string limitText(const Limit& limit, const std::string& unit) {
  if (limit.sense == Sense::none) return "none";
  const std::string shown = limit.sense == Sense::atMost    ? "\u2264"
                            : limit.sense == Sense::atLeast ? "\u2265"
                                                            : std::string(signOf(limit.sense));
  return shown + " " + number(limit.value) + " " + unit;
}

std::string figureText(double figure, const std::string& unit) { return number(figure) + " " + unit; }

// "T01  exact    0 differences    none"
struct Cells {
  std::string id, margin, figure, limit;
};

Cells cellsOf(const HardCase& row) {
  if (!row.held) return {row.id, "\u2013", "no test", "\u2013"};
  const HeldFigure& held = *row.held;
  return {row.id, marginText(held.figure, held.limit), figureText(held.figure, held.unit),
          limitText(held.limit, held.unit)};
}

Cells cellsOf(const Measured& of) {
  const std::string unit = of.check.unit;
  return {of.check.id, marginText(of.figure, of.check.limit), figureText(of.figure, unit),
          limitText(of.check.limit, unit)};
}

std::string measuredBy(const HardCaseRecord& record) {
  return record.program + " on " + record.machine + ", pictures by " + record.renderer + ", " + record.date;
}

// In columns of a terminal; a character outside of ASCII counts as one.
std::string padded(const std::string& text, std::size_t width) {
  const auto shown = static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
  return text + std::string(shown < width ? width - shown : 0, ' ');
}

std::string plainLine(const Cells& cells, std::string_view words) {
  return padded(cells.id, 5) + padded(cells.margin, 9) + padded(cells.figure, 34) + padded(cells.limit, 34) +
         std::string(words) + "\n";
}

std::string escaped(std::string_view text, bool isHtml) {
  std::string out;
  for (const char c : text) {
    if (isHtml && c == '<')
      out += "&lt;";
    else if (isHtml && c == '&')
      out += "&amp;";
    else if (!isHtml && c == '|')
      out += "\\|";
    else
      out += c;
  }
  return out;
}

std::string markdownRow(std::initializer_list<std::string_view> cells) {
  std::string line = "|";
  for (const std::string_view cell : cells) line += " " + escaped(cell, false) + " |";
  return line + "\n";
}

std::string htmlRow(std::initializer_list<std::string_view> cells, const char* tag = "td") {
  std::string line = "<tr>";
  std::size_t column = 0;
  for (const std::string_view cell : cells) {
    const bool isWords = column++ >= 4;
    line += std::string("<") + tag + (isWords ? " class=\"words\">" : ">") + escaped(cell, true) + "</" +
            tag + ">";
  }
  return line + "</tr>\n";
}

constexpr const char* kMeaning =
    "Each row is an input that breaks a naive implementation; its tests, named with its id, measure how far "
    "the program "
    "is from what must hold. Shown is the figure with the least margin: the factor by which it may still "
    "grow (or fall) "
    "before its limit is broken. \u201cexact\u201d: any fault would be one too many; \u201cendless\u201d: "
    "the figure is 0 "
    "where more would be allowed.";

struct Counts {
  std::size_t measured = 0, exact = 0, tight = 0, figures = 0;
};

Counts countsOf(const HardCaseRecord& record) {
  Counts counts;
  for (const HardCase& row : record.cases) {
    if (!row.held) continue;
    counts.figures += static_cast<std::size_t>(row.figures);
    const bool isExact = row.held->limit.sense == Sense::none;
    counts.exact += isExact;
    counts.measured += !isExact;
    counts.tight += row.held->margin() < kWantedMargin;
  }
  return counts;
}

std::string summary(const HardCaseRecord& record) {
  const Counts counts = countsOf(record);
  return std::to_string(counts.measured + counts.exact) + " rows hold, by " + std::to_string(counts.figures) +
         " figures: " + std::to_string(counts.exact) + " exactly, " + std::to_string(counts.measured) +
         " with a margin, of which " + std::to_string(counts.tight) + " have less than 2 and say why.";
}

}  // namespace

std::vector<Measured> measureAll() {
  std::vector<Measured> all;
  for (const LiveCheck& check : liveChecks()) all.push_back({check, check.measure()});
  std::ranges::stable_sort(all, {}, [](const Measured& of) { return marginOf(of.figure, of.check.limit); });
  return all;
}

std::string plainTable(const HardCaseReport& report) {
  std::string text;
  const Cells head{"row", "margin", "figure", "limit"};
  if (!report.now.empty()) {
    text += "Measured now by " + report.program + " on " + report.machine + ":\n";
    text += plainLine(head, "of");
    for (const Measured& of : report.now) text += plainLine(cellsOf(of), of.check.what);
    text += "\n";
  }
  text += "Recorded by the suite of " + measuredBy(report.record) + ":\n";
  text += plainLine(head, "input");
  for (const HardCase& row : sortedByMargin(report.record.cases)) text += plainLine(cellsOf(row), row.input);
  return text + "\n" + summary(report.record) + "\n";
}

std::string markdownTable(const HardCaseReport& report) {
  std::string text = "# Hard cases and their margins\n\n" + std::string(kMeaning) + "\n\n";
  text += summary(report.record) + "\n\n";
  if (!report.now.empty()) {
    text += "## Measured now\nBy " + report.program + " on " + report.machine + ".\n\n";
    text += "| row | margin | figure | limit | of |\n|---|---|---|---|---|\n";
    for (const Measured& of : report.now) {
      const Cells cells = cellsOf(of);
      text += markdownRow({cells.id, cells.margin, cells.figure, cells.limit, of.check.what});
    }
    text += "\n";
  }
  text +=
      "## Recorded by the suite\nBy " + measuredBy(report.record) +
      ". Made by the test `margins.HardCaseMargins` ([contributing.md](contributing.md#add-a-hard-case)); "
      "`skydrop accuracy stability` prints it, and measures again what needs no picture.\n\n";
  text += "| row | margin | figure | limit | input | what must hold |\n|---|---|---|---|---|---|\n";
  const std::vector<HardCase> sorted = sortedByMargin(report.record.cases);
  for (const HardCase& row : sorted) {
    const Cells cells = cellsOf(row);
    text += markdownRow({cells.id, cells.margin, cells.figure, cells.limit, row.input, row.mustHold});
  }
  text += "\n## Why a margin is below 2\n\n| row | margin | test | reason |\n|---|---|---|---|\n";
  for (const HardCase& row : sorted) {
    if (row.reason.empty()) continue;
    text += markdownRow({row.id, cellsOf(row).margin, row.held ? row.held->test : "\u2013", row.reason});
  }
  return text;
}

std::string htmlTable(const HardCaseReport& report) {
  std::string page =
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Hard cases</title>\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n<style>\n" +
      core::readTextFile(core::assetPath("report/page.css")) +
      "td.words, th.words { text-align: left; white-space: normal; }\n</style></head><body>\n"
      "<h1>Hard cases and their margins</h1>\n<p>" +
      std::string(kMeaning) + "</p>\n<p>" + summary(report.record) + "</p>\n";
  if (!report.now.empty()) {
    page += "<section><h2>Measured now</h2><p class=\"faint\">By " + escaped(report.program, true) + " on " +
            escaped(report.machine, true) + ".</p>\n<table><thead>" +
            htmlRow({"row", "margin", "figure", "limit", "of"}, "th") + "</thead><tbody>\n";
    for (const Measured& of : report.now) {
      const Cells cells = cellsOf(of);
      page += htmlRow({cells.id, cells.margin, cells.figure, cells.limit, of.check.what});
    }
    page += "</tbody></table></section>\n";
  }
  page +=
      "<section><h2>Recorded by the suite</h2><p class=\"faint\">By " +
      escaped(measuredBy(report.record), true) + ".</p>\n<table><thead>" +
      htmlRow({"row", "margin", "figure", "limit", "input", "what must hold", "why the margin is below 2"},
              "th") +
      "</thead><tbody>\n";
  for (const HardCase& row : sortedByMargin(report.record.cases)) {
    const Cells cells = cellsOf(row);
    page += htmlRow({cells.id, cells.margin, cells.figure, cells.limit, row.input, row.mustHold, row.reason});
  }
  return page + "</tbody></table></section></body></html>\n";
}

std::string jsonTable(const HardCaseReport& report) {
  nlohmann::ordered_json json;
  json["schema"] = kHardCaseSchema;
  json["now"] = {{"program", report.program}, {"machine", report.machine}};
  json["now"]["checks"] = nlohmann::ordered_json::array();
  for (const Measured& of : report.now) {
    json["now"]["checks"].push_back({{"id", of.check.id},
                                     {"what", of.check.what},
                                     {"figure", of.figure},
                                     {"sense", signOf(of.check.limit.sense)},
                                     {"limit", of.check.limit.value},
                                     {"unit", of.check.unit},
                                     {"margin", marginOf(of.figure, of.check.limit)}});
  }
  json["recorded"] = jsonOf(report.record);
  return json.dump(1) + "\n";
}

}  // namespace skydrop::stability
