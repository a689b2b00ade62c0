// What the simulation costs, and what the integrators give for it. Left out: drawing, sound, reading input.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

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

// Classical Runge-Kutta as flight::integrate has it, without its look at the stiffness: the same bits.
flight::BodyState plainRk4(const flight::BodyState& s, const flight::MassProperties& body,
                           const flight::WrenchField& wrench, double dt) {
  struct Rate {
    glm::dvec3 position, velocity, spin;
    glm::dquat orientation;
  };
  const auto rate = [&](const flight::BodyState& at, double time) {
    const flight::Wrench w = wrench(at, time);
    const glm::dvec3& spin = at.angularVelocity;
    return Rate{at.velocity, w.force / body.mass,
                body.inverseInertia * (w.torque - glm::cross(spin, body.inertia * spin)),
                at.orientation * glm::dquat(0, spin.x, spin.y, spin.z) * 0.5};
  };
  const auto moved = [&](const Rate& r, double h) {
    return flight::BodyState{s.position + r.position * h, s.velocity + r.velocity * h,
                             s.orientation + r.orientation * h, s.angularVelocity + r.spin * h};
  };
  const auto unit = [](flight::BodyState at) {
    at.orientation = glm::normalize(at.orientation);
    return at;
  };
  const Rate a = rate(s, 0), b = rate(unit(moved(a, dt / 2)), dt / 2),
             c = rate(unit(moved(b, dt / 2)), dt / 2), d = rate(unit(moved(c, dt)), dt);
  return unit(moved({(a.position + 2.0 * (b.position + c.position) + d.position) / 6.0,
                     (a.velocity + 2.0 * (b.velocity + c.velocity) + d.velocity) / 6.0,
                     (a.spin + 2.0 * (b.spin + c.spin) + d.spin) / 6.0,
                     (a.orientation + (b.orientation + c.orientation) * 2.0 + d.orientation) / 6.0},
                    dt));
}

double threadSeconds() {
  std::timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// What the screening of every step for stiffness adds to a step of the aircraft that is not stiff: at most 3
// %. Taken on a body whose forces cost next to nothing, with the screening and without, and held against the
// aircraft's whole step. The three take turns; the least of each counts.
void stiffnessScreening(benchmark::State& state) {
  constexpr int kSteps = 20000, kRounds = 40;
  constexpr double kStepSeconds = 1.0 / 120;
  const flight::MassProperties body{2, glm::dmat3(10, 0, 0, 0, 20, 0, 0, 0, 26),
                                    glm::inverse(glm::dmat3(10, 0, 0, 0, 20, 0, 0, 0, 26))};
  const auto spring = [](const flight::BodyState& s) {
    return flight::Wrench{-3.0 * s.position - 0.1 * s.velocity, -0.1 * s.angularVelocity};
  };
  flight::WrenchField field(spring);
  benchmark::DoNotOptimize(field);  // called through its pointer by both
  flight::BodyState start;
  start.position = {3, 1, 2};
  start.angularVelocity = {1, 2, 1};
  const auto run = [&](const auto& step, double& least) {
    flight::BodyState at = start;
    const double from = threadSeconds();
    for (int i = 0; i < kSteps; ++i) at = step(at);
    least = std::min(least, (threadSeconds() - from) / kSteps);
    return at;
  };
  double screened = 1, plain = 1, aircraft = 1;
  for (auto _ : state) {
    for (int round = 0; round < kRounds; ++round) {
      const flight::BodyState a =
          run([&](const auto& s) { return flight::integrate(Integrator::rk4, s, body, field, kStepSeconds); },
              screened);
      const flight::BodyState b =
          run([&](const auto& s) { return plainRk4(s, body, field, kStepSeconds); }, plain);
      if (a.position != b.position || a.orientation != b.orientation) {
        state.SkipWithError("the plain integrator is another one");
        return;
      }
      const double from = threadSeconds();
      benchmark::DoNotOptimize(scriptedFlight(Integrator::rk4, 120));
      aircraft = std::min(aircraft, (threadSeconds() - from) / (15 * 120));
    }
  }
  state.counters["screeningNs"] = (screened - plain) * 1e9;
  state.counters["aircraftStepNs"] = aircraft * 1e9;
  state.counters["share"] = (screened - plain) / aircraft;
  bench::expect(screened - plain <= 0.03 * aircraft,
                "looking for stiffness costs more than 3 % of a step of the aircraft");
}
BENCHMARK(stiffnessScreening)->Iterations(1)->Unit(benchmark::kMillisecond);

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
