// What a run measured, as plain data: written by --stats, drawn by the menu. Times in milliseconds, times and
// counts
// >= 0. A value: any thread.
//
// It lies in core because render fills a part of it, ui draws it, and app fills the rest and writes it as
// JSON: none of the three may include another's. It is numbers and names, of which core computes none and
// means nothing by them; held by app, the parts of land, game and window would leave render and ui with a
// second struct to be copied from.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace skydrop::core {

struct PassStatistics {
  double ms = 0;                // median over the measured frames
  std::int64_t draws = 0;       // in the last frame
  std::int64_t dispatches = 0;  // in the last frame
  std::string group = {};       // whom the pass belongs to; empty: to every scene
  std::string skipped = {};     // why it did no work in the last frame; empty: it worked
};

// What one effect of the program holds and takes. An effect that is off holds and takes nothing.
struct EffectStatistics {
  std::string name;
  bool on = false;
  // Why it does nothing in this frame, or what it waits for; empty: it works, or is off.
  std::string idle = {};
  double ms = 0;  // of its passes in the last frame: the sum of their medians
  // CPU time of the main thread, measured only while times are asked for.
  double simulationMs =
      0;                // of its part of a second of simulation (120 steps), mean of all that were measured
  double updateMs = 0;  // outside of passes and steps, of a frame: sound, interface, streaming; mean
  std::int64_t draws = 0, dispatches = 0;
  std::int64_t objects = 0, gpuBytes = 0;  // GL
  std::int64_t cpuBytes = 0;               // of what it keeps in memory beside that; where it is counted
  std::int64_t threads = 0;
  double startMs = 0;  // to make it, without what is prepared beside and compiled later
};

struct GlStatistics {
  std::int64_t textures = 0, buffers = 0, programs = 0, framebuffers = 0;
  std::int64_t bytes = 0;   // textures and buffers
  std::int64_t errors = 0;  // faults that the driver reported since the start
};

struct TerrainStatistics {
  std::int64_t chunksDrawn = 0, triangles = 0, generated = 0, cacheHits = 0, queue = 0;
  std::int64_t bytes = 0;      // chunk data held on the CPU
  std::int64_t coarsened = 0;  // chunks drawn coarser than wanted because a budget was full
};

// Of the world after its last step; angles and place those of the aircraft.
struct DeliveryStatistics {
  std::int64_t package = 0, target = 0;  // numbers of the run, from 1
  bool hit = false;
  double distanceM = 0;  // from the target's centre
  double seconds = 0;    // from when the target was there until the landing
  std::int64_t points = 0;
  std::string reason;  // of a miss: "tooEarly"; "none" for a hit
};
struct GameStatistics {
  std::int64_t score = 0, drops = 0, misses = 0;
  std::int64_t points = 0;
  std::vector<DeliveryStatistics> deliveries;        // the newest 256, oldest first
  std::int64_t targets = 0;                          // drawn so far
  double position[3] = {0, 0, 0};                    // m, world
  double airspeedMps = 0, throttle = 0;              // m/s; 0..1
  double headingDeg = 0, pitchDeg = 0, bankDeg = 0;  // degrees; compass, nose up, right wing down
};

// What the table of costs in the menu shows: the same numbers as below, as of its last renewal.
struct ShownCosts {
  std::int64_t passes = 0, frames = 0, bytes = 0;
};

// A frame budget that is in force.
struct BudgetStatistics {
  double budgetMs = 0;     // 0: there is none
  double medianMs = 0;     // of the newest frames
  std::int64_t rung = -1;  // that is chosen, of `rungs`, the cheapest being 0; -1: nothing is turned
  std::int64_t rungs = 0;
  std::int64_t changes = 0;  // since it was set
  bool holds = true;         // false: the cheapest rung does not fit
  bool measured = false;     // by fronts of this machine, or by shipped ones
  std::string choice, text;  // the rung's name; the line that the panel shows
};

// The state of a window and of what is open in it; empty in headless runs.
struct WindowStatistics {
  std::int64_t width = 0, height = 0;  // pixels
  std::string camera;
  bool menuOpen = false, helpOpen = false, escapeOpen = false, paused = false, frozen = false;
  bool fullScreen = false, hidden = false;
  std::int64_t screenshots = 0;
  std::string quality;
  std::string fault;           // the line that the menu shows of what is broken; empty: nothing is
  std::int64_t costRows = -1;  // of the panel of costs; -1: it is closed
  BudgetStatistics budget;
  bool weatherBar = false;      // is shown
  std::string weatherMode;      // "live" or "play"; empty: there is no weather data
  std::int64_t forecastMs = 0;  // the data's time, ms since 1970
  double forecastPace = 0;      // its speed
  double splitShare = -1;       // of the split view's reference that is drawn, 0 .. 1; -1: no split view
  ShownCosts costs;
  double firstPictureMs = 0, loadedMs = 0;  // after the program was started
  std::int64_t programsLoaded = 0;          // shader programs when the flight began: later ones hold it up
  double medianIntervalMs = 0, p99IntervalMs = 0;  // between frames, waiting included
};

// How far the picture is from that of a reference, in the last frame that was compared with one.
struct SplitStatistics {
  std::string reference;                        // "clouds=reference"; empty: nothing was compared
  double rmse = 0, relativeRmse = 0, flip = 0;  // linear radiance; over its mean; mean FLIP, 0 .. 1
};

struct FrameStatistics {
  // Over the measured frames; without settling, read-back and PNG, which are rows of `other`.
  std::int64_t frames = 0;
  double medianMs = 0, p99Ms = 0, maxMs = 0;
  std::map<std::string, double> other;  // "settle", "readBack", "png" ...: total ms

  double beginMs = 0;  // of the passes' clock, median: what a frame has to do before and between its passes
  std::string clock;   // what timed the passes: "timer query" or "wall clock between glFinish calls"
  std::string renderer;
  std::vector<std::pair<std::string, PassStatistics>> passes;  // in frame order
  GlStatistics gl;
  TerrainStatistics terrain;
  GameStatistics game;
  WindowStatistics window;
  SplitStatistics split;
  std::int64_t threads = 0;
  std::vector<std::string> effects;  // that are on
  // Of every effect of the program; last "frame", which is what belongs to none of them, and always on.
  std::vector<EffectStatistics> bill;
  std::map<std::string, std::int64_t> guards;  // how often each numerical guard fired (guards.h)
  std::uint64_t stateHash = 0;
  std::uint64_t steps = 0;

  // The row of the bill for an effect that is on; null where it is off or unknown.
  EffectStatistics* billOf(std::string_view effect) {
    for (EffectStatistics& row : bill) {
      if (row.on && row.name == effect) return &row;
    }
    return nullptr;
  }
};

}  // namespace skydrop::core
