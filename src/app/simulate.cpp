#include <cmath>
#include <cstdio>
#include <optional>

#include "app/flight_trace.h"
#include "app/frame_times.h"
#include "app/message.h"
#include "app/prepare.h"
#include "app/progress.h"
#include "app/standard_output.h"
#include "app/statistics_json.h"
#include "app/verbs.h"
#include "skydrop/core/fixed_step.h"

namespace skydrop::app {

int simulate(const CommandLine& line) {
  const std::unique_ptr<Run> run = prepareRun(line);
  std::optional<core::OutputFile> stats = openOutput(line.stats);
  if (run->warning) warn(*run->warning);
  Simulation simulation(run->setup, run->settings, run->table);

  std::optional<FlightTrace> trace;
  if (line.trace) {
    trace.emplace();
    trace->append(simulation.world().now());
  }

  // Frames are only imitated: each asks for the steps that are due, as a window would.
  core::FixedStep clock;
  Progress progress("simulate", line.progress);
  const auto wantedSteps = static_cast<std::uint64_t>(std::llround(line.seconds * core::FixedStep::kStepsPerSecond));
  for (std::uint64_t done = 0; done < wantedSteps && !simulation.finished();) {
    for (int due = clock.advance(1 / line.fps); due > 0 && done < wantedSteps && !simulation.finished(); --due, ++done) {
      simulation.step({});
      simulation.world().takeEvents();
      if (trace) trace->append(simulation.world().now());
    }
    if (progress.isDue()) {
      progress.show(std::to_string(done / core::FixedStep::kStepsPerSecond) + " of " +
                    std::to_string(wantedSteps / core::FixedStep::kStepsPerSecond) + " s");
    }
  }
  progress.clear();

  core::FrameStatistics statistics;
  simulation.writeTo(statistics);
  const game::Snapshot& now = simulation.world().now();
  if (trace) trace->write(*line.trace);
  if (stats) writeStatistics(*stats, statistics);
  print("%.3f s, score %lld of %lld drops, %lld misses, at %.1f %.1f %.1f, state %016llx\n", now.simulatedSeconds,
        static_cast<long long>(now.score), static_cast<long long>(now.drops), static_cast<long long>(now.misses),
        now.aircraft.position.x, now.aircraft.position.y, now.aircraft.position.z,
        static_cast<unsigned long long>(statistics.stateHash));
  return 0;
}

}  // namespace skydrop::app
