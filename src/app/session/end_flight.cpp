#include "app/session/end_flight.h"

#include "app/console/message.h"

namespace skydrop::app {
namespace {

void say(const std::optional<std::string>& line) {
  if (line) warn(*line);
}

}  // namespace

int endFlight(Simulation& simulation, FlightRecorder* recorder, FlightTrace* trace) {
  simulation.endRecording();
  if (recorder) say(recorder->takeReason());
  if (trace) say(trace->takeReason());
  say(simulation.takeDivergence());
  const bool isIncomplete = (recorder && recorder->isIncomplete()) || (trace && trace->isIncomplete());
  return isIncomplete || simulation.hasDiverged() ? 1 : 0;
}

}  // namespace skydrop::app
