#include "app/studies/cost_study.h"

#include <algorithm>
#include <cstdio>
#include <limits>

#include "app/measure/bill.h"
#include "app/measure/system_info.h"
#include "app/studies/scene_bill.h"
#include "skydrop/clouds/cloud_settings.h"
#include "skydrop/core/quantile.h"
#include "skydrop/scene/scene.h"

namespace skydrop::app {
namespace {

using scene::Effect;
using scene::EffectSet;

constexpr CostEffort kThorough{{640, 360}, 40, 5}, kQuick{{640, 360}, 12, 3};
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr const char* kSceneOfTheSkies = "fair";

std::string switched(Effect effect, bool on) {
  return "effects." + std::string(scene::nameOf(effect)) + (on ? "=true" : "=false");
}

std::vector<Effect> allEffects() {
  std::vector<Effect> all;
  for (std::size_t i = 0; i < scene::kEffectNames.size(); ++i) all.push_back(static_cast<Effect>(i));
  return all;
}

// Those that go when this one does, itself first.
std::vector<Effect> restingOn(Effect effect, const EffectSet& on) {
  std::vector<Effect> gone = {effect};
  for (std::size_t i = 0; i < gone.size(); ++i) {
    for (const scene::EffectNeed& need : scene::kEffectNeeds) {
      if (need.needs == gone[i] && on.contains(need.effect) &&
          std::ranges::find(gone, need.effect) == gone.end())
        gone.push_back(need.effect);
    }
  }
  return gone;
}

MeasuredGame::Setup setupOf(const std::string& scene, const CostEffort& effort,
                            std::vector<std::string> set) {
  set.insert(set.begin(), "quality=low");
  return {scene, effort.size, std::move(set)};
}

std::string text(const char* format, double a, double b = 0, double c = 0) {
  char line[160];
  std::snprintf(line, sizeof line, format, a, b, c);
  return line;
}

std::string sizeText(const Size& size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

std::string clockText(const SceneBill& bill, const CostEffort& effort) {
  return "passes by " + bill.frames.back().clock + ", median and p99 of " + std::to_string(effort.frames) +
         " frames; the CPU by the time of the main thread; frames without an effect by the wall clock in " +
         std::to_string(effort.rounds) + " rounds in turn with the whole scene, median, least and most";
}

// The metrics of a scene's table, in the order of valuesOf().
std::vector<CostColumn> columnsOfScene() {
  return {{"passes", "ms a frame"},
          {"p99", "ms"},
          {"simulation", "CPU ms a second"},
          {"update", "CPU ms a frame"},
          {"draws", ""},
          {"dispatches", ""},
          {"GPU", "bytes"},
          {"CPU", "bytes"},
          {"threads", ""},
          {"start", "ms"},
          {"frame without it", "ms"},
          {"saves", "ms"},
          {"least", "ms"},
          {"most", "ms"}};
}

// Of one part of the bill: ms of its passes in each frame, and what the last frame says of the rest.
std::vector<double> valuesOf(const std::vector<double>& ms, const core::EffectStatistics& last,
                             const FrameComparison* without) {
  std::vector<double> values = {core::quantileOf(ms, 0.5),
                                core::quantileOf(ms, 0.99),
                                last.simulationMs,
                                last.updateMs,
                                static_cast<double>(last.draws),
                                static_cast<double>(last.dispatches),
                                static_cast<double>(last.gpuBytes),
                                static_cast<double>(last.cpuBytes),
                                static_cast<double>(last.threads),
                                last.startMs};
  if (without) {
    values.insert(values.end(),
                  {without->otherMs, -without->moreMs, -without->mostMoreMs, -without->leastMoreMs});
  } else {
    const double saved = last.on ? kNone : 0;  // to leave out what is off saves nothing
    values.insert(values.end(), {kNone, saved, saved, saved});
  }
  return values;
}

core::EffectStatistics sumOf(const std::vector<core::EffectStatistics>& rows) {
  core::EffectStatistics sum;
  sum.on = true;
  for (const core::EffectStatistics& row : rows) {
    sum.simulationMs += row.simulationMs, sum.updateMs += row.updateMs;
    sum.draws += row.draws, sum.dispatches += row.dispatches;
    sum.gpuBytes += row.gpuBytes, sum.cpuBytes += row.cpuBytes;
    sum.threads += row.threads, sum.startMs += row.startMs;
  }
  return sum;
}

// What the row says beside its numbers.
std::string noteOf(const core::EffectStatistics& row, const std::vector<Effect>& gone) {
  if (!row.on) return "off";
  std::string note = row.idle;
  for (std::size_t i = 1; i < gone.size(); ++i)
    note += (note.empty() ? "" : "; ") + std::string("left out with ") + std::string(scene::nameOf(gone[i]));
  return note;
}

std::vector<std::string> scenesOf(const CostOptions& options) {
  return options.scenes.empty() ? scene::listScenes() : options.scenes;
}

std::size_t gamesOf(const std::string& name) {
  const EffectSet effects = scene::requiredEffects(scene::loadScene(name));
  return 1 + static_cast<std::size_t>(std::ranges::count_if(
                 allEffects(), [&](Effect effect) { return effects.contains(effect); }));
}

}  // namespace

const ReportHeading kCostHeading = {
    "What does each effect cost?",
    "Each scene has a row for every effect of the program: what its passes, its part of the simulation and "
    "its update\n(sound, interface, streaming of land) take, what it holds, and what a frame takes when it "
    "is "
    "left out. `frame` is what\nbelongs to no effect: targets cleared, tone map, the world's clock. Effects "
    "that a scene does not call for are off and cost\nnothing. Effects overlap: what hides others saves "
    "their "
    "cost, and what is left out uncovers them, so savings need not add\nup. The last table has the form of "
    "Tarantilis (2004), Table 1. Made by `skydrop accuracy cost`."};

CostTable costOfScene(const std::string& name, const CostEffort& effort, const std::function<void()>& done) {
  const auto tell = [&] {
    if (done) done();
  };
  CostTable result;
  MeasuredGame game(setupOf(name, effort, {}));
  const SceneBill bill = billOf(game, effort.frames);
  tell();
  const double share = bill.paidShare();
  result.title = "Scene " + scene::loadScene(name).name;
  result.method = "The first view of the scene at " + sizeText(effort.size) + ", quality low. " +
                  text("A measured frame takes %.3g ms, of which the rows account for %.1f %%.",
                       core::quantileOf(bill.frameMs, 0.5), 100 * share);
  result.columns = columnsOfScene();
  result.clock = clockText(bill, effort);
  result.machine = machineName() + ", " + game.renderer();
  const std::vector<core::EffectStatistics>& last = bill.frames.back().bill;
  for (std::size_t i = 0; i < last.size(); ++i) {
    const core::EffectStatistics& row = last[i];
    std::vector<double> ms;
    for (const core::FrameStatistics& frame : bill.frames) ms.push_back(frame.bill[i].ms);
    const auto effect = std::ranges::find(scene::kEffectNames, row.name);
    if (!row.on || effect == scene::kEffectNames.end()) {
      result.rows.push_back({row.name, valuesOf(ms, row, nullptr), noteOf(row, {})});
      continue;
    }
    const std::vector<Effect> gone =
        restingOn(static_cast<Effect>(effect - scene::kEffectNames.begin()), game.effects());
    std::vector<std::string> off;
    for (const Effect part : gone) off.push_back(switched(part, false));
    MeasuredGame without(setupOf(name, effort, off));
    without.show(game.sight());
    const FrameComparison comparison = compareFrames(game, without, effort.rounds);
    result.rows.push_back({row.name, valuesOf(ms, row, &comparison), noteOf(row, gone)});
    tell();
  }
  result.rows.push_back({"all of the frame", valuesOf(bill.frameMs, sumOf(last), nullptr),
                         text("by the wall clock; the rows above are %.1f %% of it", 100 * share)});
  return result;
}

std::vector<SkyKind> skyKinds() {
  std::vector<SkyKind> kinds = {{"empty sky", {}, {}, 83, 0},
                                {"one plane", {"cloudPlanes"}, {"cloudPlanes.count=1"}, 70, 15},
                                {"two planes", {"cloudPlanes"}, {"cloudPlanes.count=2"}, 62, 25},
                                {"three planes", {"cloudPlanes"}, {"cloudPlanes.count=3"}, 59, 29},
                                {"dome", {"cloudDome"}, {}, 44, 47}};
  for (const std::string_view tier : clouds::kCloudTierNames) {
    if (tier == "reference") continue;  // a frame takes seconds
    kinds.push_back({"clouds, " + std::string(tier), {"clouds"}, {"clouds.tier=" + std::string(tier)}});
  }
  const std::vector<std::string> withKinds = {"sky", "terrain", "clouds", "cloudPlanes", "cloudDome"};
  for (const std::string_view name : scene::kEffectNames) {
    if (std::ranges::find(withKinds, name) == withKinds.end())
      kinds.push_back({std::string(name), {std::string(name)}});
  }
  const auto isUnknown = [](const std::string& name) {
    return std::ranges::find(scene::kEffectNames, name) == scene::kEffectNames.end();
  };
  std::erase_if(kinds, [&](const SkyKind& kind) { return std::ranges::any_of(kind.effects, isUnknown); });
  return kinds;
}

CostTable costOfSkies(const std::vector<SkyKind>& kinds, const CostEffort& effort,
                      const std::function<void()>& done) {
  const auto setupOfKind = [&](const SkyKind& kind) {
    EffectSet effects;
    effects.insert(Effect::sky), effects.insert(Effect::terrain);
    for (const std::string& name : kind.effects) {
      const auto found = std::ranges::find(scene::kEffectNames, name);
      effects.insert(static_cast<Effect>(found - scene::kEffectNames.begin()));
    }
    effects = scene::withNeeds(effects);
    std::vector<std::string> set;
    for (const Effect effect : allEffects()) set.push_back(switched(effect, effects.contains(effect)));
    set.insert(set.end(), kind.set.begin(), kind.set.end());
    return setupOf(kSceneOfTheSkies, effort, set);
  };
  // The place that all are seen from: that of the camera behind the aircraft.
  const Sight sight = MeasuredGame(setupOf(kSceneOfTheSkies, effort, {})).sight();
  MeasuredGame empty(setupOfKind({}));
  empty.show(sight);
  CostTable result;
  result.title = "Kinds of sky";
  result.method = "Land under an empty sky from where the scene `" + std::string(kSceneOfTheSkies) +
                  "` begins, " + sizeText(effort.size) +
                  ", quality low; then with one thing more. The source's figures are those of its own "
                  "program, land and machine of 2004.";
  result.columns = {{"frames per second", ""},
                    {"drop", "%"},
                    {"least", "%"},
                    {"most", "%"},
                    {"Tarantilis 2004", "frames per second"},
                    {"drop", "%"}};
  result.clock = "the wall clock between glFinish calls, " + std::to_string(effort.rounds) +
                 " rounds in turn with the empty sky, median, least and most";
  result.machine = machineName() + ", " + empty.renderer();
  std::vector<double> emptyMs;
  for (const SkyKind& kind : kinds) {
    const auto orNone = [&](double value) { return kind.sourceFps > 0 ? value : kNone; };
    const std::vector<double> source = {orNone(kind.sourceFps), orNone(kind.sourceDrop)};
    std::vector<double> values;
    if (&kind == &kinds.front()) {
      values = {1, 0, 0, 0};
    } else {
      MeasuredGame game(setupOfKind(kind));
      game.show(sight);
      const FrameComparison more = compareFrames(empty, game, effort.rounds);
      const auto drop = [](double ratio) { return 100 * (1 - 1 / ratio); };
      emptyMs.push_back(more.baseMs);
      values = {1 / more.ratio, drop(more.ratio), drop(more.leastRatio), drop(more.mostRatio)};
    }
    values.insert(values.end(), source.begin(), source.end());
    result.rows.push_back({kind.label, values, ""});
    if (done) done();
  }
  // Rates by the drop from one and the same empty sky: what drifts between two rows must not count.
  const double emptyRate = emptyMs.empty() ? kNone : 1000 / core::quantileOf(emptyMs, 0.5);
  for (CostRow& row : result.rows) row.values.front() *= emptyRate;
  return result;
}

std::vector<CostTable> costStudy(const CostOptions& options, const CostProgress& progress) {
  const CostEffort& effort = options.quick ? kQuick : kThorough;
  const std::vector<SkyKind> kinds = skyKinds();
  const std::vector<std::string> scenes = scenesOf(options);
  std::size_t all = kinds.size(), done = 0;
  for (const std::string& name : scenes) all += gamesOf(name);
  const auto tell = [&] { progress(++done, all); };
  progress(0, all);
  std::vector<CostTable> results;
  for (const std::string& name : scenes) results.push_back(costOfScene(name, effort, tell));
  results.push_back(costOfSkies(kinds, effort, tell));
  return results;
}

}  // namespace skydrop::app
