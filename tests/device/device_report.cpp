#include "device/device_report.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "skydrop/core/file.h"

namespace skydrop::device {
namespace {

using Json = nlohmann::ordered_json;

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string sizeOf(const Passes& passes) {
  return std::to_string(passes.width) + " x " + std::to_string(passes.height);
}

std::string labelOf(const Passes& passes) {
  return passes.variant.empty() ? passes.scene : passes.scene + ", " + passes.variant;
}

std::string suiteRow(const Suite& suite) {
  std::string row = "| " + suite.name + " | " + std::to_string(suite.tests) + " | " +
                    std::to_string(suite.failed) + " | " + std::to_string(suite.skipped) + " | " +
                    number(suite.seconds) + " | " + suite.error;
  for (const std::string& failure : suite.failures) row += ' ' + failure;
  return row + " |\n";
}

// One table a size: a row for each scene and variant, a column for each pass that any of them has.
std::string passTable(const std::vector<Passes>& all, const std::string& size) {
  std::vector<std::string> columns;
  for (const Passes& row : all) {
    if (sizeOf(row) != size) continue;
    for (const auto& [name, ms] : row.ms)
      if (std::ranges::find(columns, name) == columns.end()) columns.push_back(name);
  }
  std::string table = "\n### " + size + "\n\n| | frame, ms | p99, ms |";
  for (const std::string& column : columns) table += ' ' + column + " |";
  table += " GPU, MiB | |\n|---|---|---|";
  for (std::size_t i = 0; i < columns.size() + 2; ++i) table += "---|";
  table += '\n';
  for (const Passes& row : all) {
    if (sizeOf(row) != size) continue;
    table += "| " + labelOf(row) + " | " + number(row.frameMs) + " | " + number(row.frameP99Ms) + " |";
    for (const std::string& column : columns) {
      const auto found = row.ms.find(column);
      table += ' ' + (found == row.ms.end() ? std::string() : number(found->second)) + " |";
    }
    table += ' ' + number(row.gpuMiB) + " | " + row.error + " |\n";
  }
  return table;
}

}  // namespace

bool Report::isGood() const {
  const auto failed = [](const Suite& suite) { return suite.failed > 0 || !suite.error.empty(); };
  const auto missing = [](const Passes& row) { return !row.error.empty(); };
  return std::ranges::none_of(suites, failed) && std::ranges::none_of(passes, missing) && leftOut.empty();
}

std::string jsonOf(const Report& report) {
  Json json = {{"schema", 1},
               {"version", report.version},
               {"vendor", report.vendor},
               {"renderer", report.renderer},
               {"openGl", report.openGl},
               {"processor", report.processor},
               {"software", report.isSoftware},
               {"seconds", report.seconds},
               {"good", report.isGood()},
               {"suites", Json::array()},
               {"passes", Json::array()},
               {"promises", Json::array()},
               {"accuracy", report.accuracy},
               {"leftOut", report.leftOut}};
  for (const Suite& suite : report.suites) {
    json["suites"].push_back({{"name", suite.name},
                              {"tests", suite.tests},
                              {"failed", suite.failed},
                              {"skipped", suite.skipped},
                              {"failures", suite.failures},
                              {"error", suite.error},
                              {"seconds", suite.seconds}});
  }
  for (const Passes& row : report.passes) {
    json["passes"].push_back({{"scene", row.scene},
                              {"variant", row.variant},
                              {"size", {row.width, row.height}},
                              {"frames", row.frames},
                              {"clock", row.clock},
                              {"frameMs", row.frameMs},
                              {"frameP99Ms", row.frameP99Ms},
                              {"ms", row.ms},
                              {"gpuMiB", row.gpuMiB},
                              {"error", row.error}});
  }
  for (const Promise& promise : report.promises) {
    json["promises"].push_back({{"text", promise.text},
                                {"limit", promise.limit},
                                {"measured", promise.measured},
                                {"kept", promise.isKept()}});
  }
  return json.dump(2) + '\n';
}

std::string markdownOf(const Report& report) {
  std::string text = "# Device check\n\nSkydrop " + report.version + " on " + report.renderer + " (" +
                     report.vendor + ", OpenGL " + report.openGl + "), " + report.processor + ". " +
                     number(report.seconds) + " s. " +
                     (report.isGood() ? "Nothing failed." : "**Something failed.**") + "\n";
  for (const std::string& part : report.leftOut) text += "\nNo time was left for: " + part + ".\n";
  text += "\n## Tests\n\n| suite | tests | failed | skipped | seconds | |\n|---|---|---|---|---|---|\n";
  for (const Suite& suite : report.suites) text += suiteRow(suite);
  if (!report.passes.empty()) {
    text += "\n## Passes\n\nMedians in ms by " + report.passes.front().clock +
            "; frames by the wall clock, with everything that a flight does.\n";
    std::vector<std::string> sizes;
    for (const Passes& row : report.passes)
      if (std::ranges::find(sizes, sizeOf(row)) == sizes.end()) sizes.push_back(sizeOf(row));
    for (const std::string& size : sizes) text += passTable(report.passes, size);
  }
  if (!report.promises.empty()) {
    text += "\n## Promises\n\n| | limit, ms | measured, ms | |\n|---|---|---|---|\n";
    for (const Promise& promise : report.promises) {
      text += "| " + promise.text + " | " + number(promise.limit) + " | " + number(promise.measured) + " | " +
              (promise.isKept() ? "kept" : "not kept") + " |\n";
    }
  }
  if (!report.accuracy.empty())
    text += "\nAccuracy studies: [" + report.accuracy + "](" + report.accuracy + ").\n";
  return text;
}

void write(const Report& report, const std::filesystem::path& folder) {
  core::writeFileAtomically(folder / "device.json", jsonOf(report));
  core::writeFileAtomically(folder / "device.md", markdownOf(report));
}

}  // namespace skydrop::device
