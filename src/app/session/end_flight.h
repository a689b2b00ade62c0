// How a flight without a window ends: the same for `render` and `simulate`.
#pragma once

#include "app/session/flight_trace.h"
#include "app/session/simulation.h"

namespace skydrop::app {

// Ends the records, and says what is wrong with them or with the replay, each in one line. The exit code: 1
// where a record is incomplete or the replay has left the recorded flight.
int endFlight(Simulation& simulation, FlightRecorder* recorder, FlightTrace* trace = nullptr);

}  // namespace skydrop::app
