#include <cmath>
#include <cstdio>
#include <optional>

#include "app/cli/verbs.h"
#include "app/console/message.h"
#include "app/console/progress.h"
#include "app/console/standard_output.h"
#include "app/measure/frame_times.h"
#include "app/measure/statistics_json.h"
#include "app/session/end_flight.h"
#include "app/session/flight_trace.h"
#include "app/session/run_config.h"
#include "skydrop/core/fixed_step.h"

namespace skydrop::app {

namespace {

// A replay that is not told how long flies to its end.
std::uint64_t wantedSteps(const CommandLine& line, const SimulationSetup& setup) {
  if (!line.seconds && setup.replay) return setup.replay->stepCount();
  const double seconds = line.seconds.value_or(CommandLine::kDefaultSeconds);
  return static_cast<std::uint64_t>(std::llround(seconds * core::FixedStep::kStepsPerSecond));
}

}  // namespace

int simulate(const CommandLine& line) {
  const std::unique_ptr<RunConfig> run = prepareRun(line);
  std::optional<core::OutputFile> stats = openOutput(line.stats);
  if (run->warning) warn(*run->warning);
  for (const std::string& note : run->notes) warn(note);
  std::optional<FlightTrace> trace;
  if (line.trace) trace.emplace(*line.trace);
  Simulation simulation(run->setup, run->settings, run->table);
  simulation.setMeasuring(stats.has_value());
  if (trace) trace->append(simulation.world().now());

  // Frames are only imitated: each asks for the steps that are due, as a window would.
  core::FixedStep clock;
  Progress progress("simulate", line.progress);
  const std::uint64_t wanted = wantedSteps(line, run->setup);
  for (std::uint64_t done = 0; done < wanted && !simulation.finished();) {
    for (int due = clock.advance(1 / line.fps); due > 0 && done < wanted && !simulation.finished();
         --due, ++done) {
      simulation.step({});
      simulation.world().takeEvents();
      if (trace) trace->append(simulation.world().now());
    }
    if (progress.isDue()) {
      progress.show(std::to_string(done / core::FixedStep::kStepsPerSecond) + " of " +
                    std::to_string(wanted / core::FixedStep::kStepsPerSecond) + " s");
    }
  }
  progress.clear();

  core::FrameStatistics statistics;
  simulation.writeTo(statistics);
  const game::Snapshot& now = simulation.world().now();
  if (trace) trace->flush();
  if (stats) writeStatistics(*stats, statistics);
  print("%.3f s, score %lld of %lld drops, %lld misses, at %.1f %.1f %.1f, state %016llx\n",
        now.simulatedSeconds, static_cast<long long>(now.score), static_cast<long long>(now.drops),
        static_cast<long long>(now.misses), now.aircraft.position.x, now.aircraft.position.y,
        now.aircraft.position.z, static_cast<unsigned long long>(statistics.stateHash));
  return endFlight(simulation, run->recorder.get(), trace ? &*trace : nullptr);
}

}  // namespace skydrop::app
