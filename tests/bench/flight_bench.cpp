// What the simulation costs, and what the integrators give for it. Left out: drawing, sound, reading input.
#include <benchmark/benchmark.h>

#include <ctime>
#include <glm/geometric.hpp>

#include "bench/expectation.h"
#include "skydrop/flight/airplane.h"
#include "skydrop/flight/rotation.h"
#include "skydrop/game/autopilot.h"
#include "skydrop/game/world.h"
#include "skydrop/terrain/noise_height_source.h"
#include "support/rotation_reference.h"

namespace skydrop {
namespace {

using flight::Integrator;

constexpr double kDegrees = 57.29577951308232;

double angleBetween(const glm::dquat& a, const glm::dquat& b) {
  return glm::length(flight::logarithmMap(glm::normalize(glm::conjugate(a) * b))) * kDegrees;
}

// Row P01 of the hard cases: attitude error after 10 s, time of a step without any force.
void tumblingBody(benchmark::State& state) {
  const auto integrator = static_cast<Integrator>(state.range(0));
  const auto rate = static_cast<int>(state.range(1));
  test::RotationState start;
  start.spin = {1, 15, 1};
  const auto truth = test::rotateFreely(start, {10, 20, 26}, 10).attitude;
  const auto flown = [&] {
    flight::RigidBody body(1, glm::dvec3(0), glm::dquat(1, 0, 0, 0),
                           glm::dmat3(10, 0, 0, 0, 20, 0, 0, 0, 26));
    flight::BodyState spinning;
    spinning.angularVelocity = {1, 15, 1};
    body.setState(spinning);
    body.setIntegrator(integrator);
    for (int i = 0; i < 10 * rate; ++i) body.update(1.0 / rate);
    return body.orientation();
  };
  for (auto _ : state) benchmark::DoNotOptimize(flown());
  const glm::dquat q(static_cast<double>(truth[0]), static_cast<double>(truth[1]),
                     static_cast<double>(truth[2]), static_cast<double>(truth[3]));
  state.counters["errorDeg"] = angleBetween(flown(), q);
  state.counters["stepTime"] = benchmark::Counter(
      10.0 * rate, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.SetLabel(std::string(flight::kIntegratorNames[static_cast<std::size_t>(state.range(0))]));
}
BENCHMARK(tumblingBody)->ArgsProduct({{0, 1, 2, 3}, {60, 120, 240}})->Unit(benchmark::kMillisecond);

flight::BodyState scriptedFlight(Integrator integrator, int rate) {
  flight::AirplaneSettings settings;
  settings.integrator = integrator;
  flight::BodyState start;
  start.velocity = {0, 0, -70};
  flight::Airplane airplane(settings, start);
  for (int i = 0; i < 15 * rate; ++i) {
    const double t = (i + 0.5) / rate;
    airplane.step({.thrust = t > 3 && t < 12 ? 1.0 : 0.0,
                   .pitch = t > 2 && t < 4.5 ? 1.0
                            : t > 8 && t < 9 ? -1.0
                                             : 0.0,
                   .roll = t < 1.5 ? 1.0
                           : t < 4 ? 0.5
                           : t < 6 ? -1.0
                                   : 0.0,
                   .yaw = t > 10 && t < 12 ? 1.0 : 0.0},
                  glm::dvec3(0), 1.0 / rate);
  }
  return airplane.body().state();
}

// 15 s of hard flying by script: error of the position against 7680 Hz, time of a step of the aircraft.
void flyingAircraft(benchmark::State& state) {
  const auto integrator = static_cast<Integrator>(state.range(0));
  const auto rate = static_cast<int>(state.range(1));
  for (auto _ : state) benchmark::DoNotOptimize(scriptedFlight(integrator, rate));
  const glm::dvec3 truth = scriptedFlight(Integrator::rkmk4, 7680).position;
  state.counters["errorMetres"] = glm::length(scriptedFlight(integrator, rate).position - truth);
  state.counters["stepTime"] = benchmark::Counter(
      15.0 * rate, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.SetLabel(std::string(flight::kIntegratorNames[static_cast<std::size_t>(state.range(0))]));
}
BENCHMARK(flyingAircraft)->ArgsProduct({{0, 1, 2, 3}, {60, 120, 240}})->Unit(benchmark::kMillisecond);

// One simulated second of the whole game over the shipped land, flown by the autopilot, must cost under 1 ms.
void secondOfTheGame(benchmark::State& state) {
  game::WorldSetup setup;
  setup.ground = terrain::makeNoiseHeightSource({}, 1);
  game::World world(setup);
  game::Autopilot pilot(setup.ground);
  const std::clock_t from = std::clock();  // processor time: other programs do not count
  double seconds = 0;
  for (auto _ : state) {
    for (int i = 0; i < 120; ++i) world.step(pilot.decide(world.now()));
    seconds += 1;
  }
  const double spent = static_cast<double>(std::clock() - from) / CLOCKS_PER_SEC;
  bench::expect(spent / seconds < 1e-3, "a simulated second costs more than a millisecond");
}
BENCHMARK(secondOfTheGame)->Unit(benchmark::kMicrosecond)->MinTime(2);

}  // namespace
}  // namespace skydrop
