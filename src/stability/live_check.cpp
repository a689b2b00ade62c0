#include "skydrop/stability/live_check.h"

#include <array>

#include "stability/checks.h"

namespace skydrop::stability {
namespace {

// Limits are those of the rows; the tests of the rows take them from here.
constexpr std::array kChecks = {
    LiveCheck{"C01", "integral and mean cosine of the phase function, in doubles", "of 1", atMost(1e-4),
              phaseIntegralError},
    LiveCheck{"C01", "integral of Rayleigh's phase function", "of 1", atMost(1e-6), rayleighIntegralError},
    LiveCheck{"C01", "phase function straight ahead and back, in floats", "relative", atMost(1e-5),
              phaseEndsErrorInFloat},
    LiveCheck{"W35", "integral of the phase function of ice", "of 1", atMost(1e-4), icePhaseIntegralError},
    LiveCheck{"C03", "opacity of a step, in doubles", "relative", below(1e-5), stepOpacityError},
    LiveCheck{"C03", "opacity of a step, in floats", "relative", below(1e-5), stepOpacityErrorInFloat},
    LiveCheck{"C14", "distance back from a float depth", "relative", atMost(1e-4), depthRoundTripError},
    LiveCheck{"C33", "height of a bent ray over the sphere", "m", below(1.5), bentRayHeightError},
    LiveCheck{"C33", "the same, floats from doubles", "m", below(1.0 / 128), bentRayFloatError},
    LiveCheck{"C32", "level path through ground fog, in floats", "relative", atMost(1e-5),
              levelFogPathErrorInFloat},
    LiveCheck{"T04", "chunk indices at random positions", "wrong indices", kNone, wrongChunkIndices},
    LiveCheck{"T21", "spread of neighbouring chunks' hashes", "of 441 hashes in one bucket", atMost(6),
              fullestBucketOfHashes},
    LiveCheck{"P01", "energy of a free body", "relative", atMost(1e-6), freeBodyEnergyError},
    LiveCheck{"P01", "angular momentum of a free body", "relative", below(1e-5), freeBodyMomentumError},
    LiveCheck{"P05", "attitude after large turns in a step", "rad", below(1e-12), constantRotationError},
    LiveCheck{"P07", "one exponential step of any length", "of the terms", atMost(1e-12),
              exponentialStepError},
    LiveCheck{"P07", "7200 exponential steps against one", "m", below(1e-9), manySmallStepsError},
    LiveCheck{"P16", "length of a step after 1e7 s", "s", atMost(1e-6), stepLengthError},
    LiveCheck{"P16", "steps of 3 million frames", "steps", atMost(1), lostSteps},
    LiveCheck{"W01", "turn of a wind through north", "degrees", below(0.0201), windTurnJump},
    LiveCheck{"W05", "covariance of gusts after a step", "of the variance", atMost(1e-12),
              gustCovarianceError},
    LiveCheck{"W07", "pressure of the standard atmosphere", "relative", atMost(1e-5), standardPressureError},
    LiveCheck{"W07", "temperature of the standard atmosphere", "K", atMost(1e-3), standardTemperatureError},
    LiveCheck{"S04", "motion of sun and moon over ends of years", "degrees", below(0.0085), yearsEndMotion},
};

}  // namespace

std::span<const LiveCheck> liveChecks() { return kChecks; }

std::vector<LiveCheck> liveChecksOf(std::string_view id) {
  std::vector<LiveCheck> all;
  for (const LiveCheck& check : kChecks) {
    if (std::string_view(check.id) == id) all.push_back(check);
  }
  return all;
}

}  // namespace skydrop::stability
