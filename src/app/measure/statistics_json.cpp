#include "app/measure/statistics_json.h"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace skydrop::app {
namespace {

using nlohmann::ordered_json;

std::string hexadecimal(std::uint64_t value) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value));
  return text;
}

ordered_json passJson(const core::PassStatistics& pass) {
  ordered_json json = {{"ms", pass.ms}, {"draws", pass.draws}, {"dispatches", pass.dispatches}};
  if (!pass.skipped.empty()) json["skipped"] = pass.skipped;
  return json;
}

ordered_json budgetJson(const core::BudgetStatistics& budget) {
  if (budget.budgetMs <= 0) return nullptr;
  return {{"ms", budget.budgetMs},       {"medianMs", budget.medianMs}, {"rung", budget.rung},
          {"rungs", budget.rungs},       {"changes", budget.changes},   {"holds", budget.holds},
          {"measured", budget.measured}, {"choice", budget.choice},     {"text", budget.text}};
}

ordered_json billJson(const std::vector<core::EffectStatistics>& bill) {
  ordered_json json = ordered_json::object();
  for (const core::EffectStatistics& row : bill) {
    json[row.name] = {{"on", row.on},
                      {"ms", row.ms},
                      {"simulationMs", row.simulationMs},
                      {"updateMs", row.updateMs},
                      {"draws", row.draws},
                      {"dispatches", row.dispatches},
                      {"objects", row.objects},
                      {"gpuBytes", row.gpuBytes},
                      {"cpuBytes", row.cpuBytes},
                      {"threads", row.threads},
                      {"startMs", row.startMs}};
    if (!row.idle.empty()) json[row.name]["idle"] = row.idle;
  }
  return json;
}

}  // namespace

std::string statisticsJson(const core::FrameStatistics& s) {
  ordered_json json;
  json["schema"] = kStatisticsSchema;
  json["frame"] = {{"count", s.frames}, {"ms", {{"median", s.medianMs}, {"p99", s.p99Ms}, {"max", s.maxMs}}}};
  json["clock"] = s.clock;
  json["renderer"] = s.renderer;
  json["passes"] = ordered_json::object();
  for (const auto& [name, pass] : s.passes) json["passes"][name] = passJson(pass);
  json["gl"] = {{"textures", s.gl.textures},         {"buffers", s.gl.buffers}, {"programs", s.gl.programs},
                {"framebuffers", s.gl.framebuffers}, {"errors", s.gl.errors},   {"bytes", s.gl.bytes}};
  json["terrain"] = {{"chunksDrawn", s.terrain.chunksDrawn},
                     {"triangles", s.terrain.triangles},
                     {"generated", s.terrain.generated},
                     {"cacheHits", s.terrain.cacheHits},
                     {"queue", s.terrain.queue},
                     {"bytes", s.terrain.bytes},
                     {"coarsened", s.terrain.coarsened}};
  json["threads"] = s.threads;
  json["effects"] = s.effects;
  json["bill"] = billJson(s.bill);
  nlohmann::json deliveries = nlohmann::json::array();
  for (const core::DeliveryStatistics& d : s.game.deliveries)
    deliveries.push_back({{"package", d.package},
                          {"target", d.target},
                          {"hit", d.hit},
                          {"distance", d.distanceM},
                          {"seconds", d.seconds},
                          {"points", d.points},
                          {"reason", d.reason}});
  json["game"] = {{"points", s.game.points},     {"deliveries", std::move(deliveries)},
                  {"score", s.game.score},       {"drops", s.game.drops},
                  {"misses", s.game.misses},     {"targets", s.game.targets},
                  {"position", s.game.position}, {"airspeed", s.game.airspeedMps},
                  {"throttle", s.game.throttle}, {"heading", s.game.headingDeg},
                  {"pitch", s.game.pitchDeg},    {"bank", s.game.bankDeg}};
  if (!s.window.camera.empty()) {
    json["window"] = {
        {"width", s.window.width},
        {"height", s.window.height},
        {"camera", s.window.camera},
        {"menuOpen", s.window.menuOpen},
        {"helpOpen", s.window.helpOpen},
        {"escapeOpen", s.window.escapeOpen},
        {"paused", s.window.paused},
        {"fullScreen", s.window.fullScreen},
        {"frozen", s.window.frozen},
        {"screenshots", s.window.screenshots},
        {"hidden", s.window.hidden},
        {"quality", s.window.quality},
        {"fault", s.window.fault},
        {"costRows", s.window.costRows},
        {"weather",
         {{"bar", s.window.weatherBar},
          {"mode", s.window.weatherMode},
          {"utcMs", s.window.forecastMs},
          {"pace", s.window.forecastPace}}},
        {"splitShare", s.window.splitShare},
        {"costs",
         {{"passes", s.window.costs.passes},
          {"frames", s.window.costs.frames},
          {"bytes", s.window.costs.bytes}}},
        {"firstPictureMs", s.window.firstPictureMs},
        {"loadedMs", s.window.loadedMs},
        {"programsLoaded", s.window.programsLoaded},
        {"budget", budgetJson(s.window.budget)},
        {"intervalMs", {{"median", s.window.medianIntervalMs}, {"p99", s.window.p99IntervalMs}}}};
  }
  if (!s.split.reference.empty()) {
    json["split"] = {{"reference", s.split.reference},
                     {"rmse", s.split.rmse},
                     {"relativeRmse", s.split.relativeRmse},
                     {"flip", s.split.flip}};
  }
  json["guards"] = s.guards;
  json["other"] = s.other;
  json["steps"] = s.steps;
  json["stateHash"] = hexadecimal(s.stateHash);
  // Names of devices and files need not be UTF-8.
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

void writeStatistics(core::OutputFile& file, const core::FrameStatistics& statistics) {
  file.write(statisticsJson(statistics));
}

}  // namespace skydrop::app
