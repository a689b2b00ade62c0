#include "app/studies/integrator_study.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/measure/stopwatch.h"
#include "app/measure/system_info.h"
#include "skydrop/core/fixed_step.h"
#include "skydrop/flight/airplane_settings.h"
#include "skydrop/flight/rigid_body.h"

namespace skydrop::app {
namespace {

using flight::Integrator;

constexpr double kSeconds = 10;
constexpr int kReferenceRate = 15360;  // Hz: the fourth-order error is 128^4 times below that at 120 Hz
constexpr int kRepetitions = 20;       // of the timed run; the fastest counts

flight::RigidBody tumblingBody(Integrator integrator) {
  flight::RigidBody body(1, glm::dvec3(0), glm::dquat(1, 0, 0, 0), glm::dmat3(10, 0, 0, 0, 20, 0, 0, 0, 26));
  flight::BodyState state = body.state();
  state.angularVelocity = {1, 15, 1};
  body.setState(state);
  body.setIntegrator(integrator);
  return body;
}

glm::dquat attitudeAfter(Integrator integrator, int rate) {
  flight::RigidBody body = tumblingBody(integrator);
  for (int i = 0; i < kSeconds * rate; ++i) body.update(1.0 / rate);
  return body.orientation();
}

// Angle between two attitudes, degrees.
double angleBetween(const glm::dquat& a, const glm::dquat& b) {
  const glm::dquat d = glm::conjugate(a) * b;
  const double sine = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
  return 2 * std::atan2(sine, std::abs(d.w)) * 180 / std::numbers::pi;
}

// Microseconds for one simulated second.
double cost(Integrator integrator, int rate) {
  double fastest = 1e300;
  for (int repetition = 0; repetition < kRepetitions; ++repetition) {
    const Stopwatch watch;
    attitudeAfter(integrator, rate);
    fastest = std::min(fastest, watch.seconds() * 1e6 / kSeconds);
  }
  return fastest;
}

}  // namespace

StudyResult integratorStudy(const StudyProgress& progress) {
  StudyResult result;
  result.title = "Integrators of the rigid body";
  result.method =
      "A torque-free body of inertia (10, 20, 26) kg m^2 that starts with (1, 15, 1) rad/s (hard case P01), "
      "against rkmk4 at " +
      std::to_string(kReferenceRate) + " Hz.";
  result.metrics = {{"attitude error after 10 s", "degrees"}};
  result.cost = {"microseconds for a simulated second",
                 "wall clock, the fastest of " + std::to_string(kRepetitions) + " runs"};
  result.machine = machineName();
  constexpr int kRates[] = {30, 60, 120, 240};
  const std::size_t rows = flight::kIntegratorNames.size() * std::size(kRates);
  progress(0, rows + 1);
  const glm::dquat reference = attitudeAfter(Integrator::rkmk4, kReferenceRate);
  for (std::size_t i = 0; i < flight::kIntegratorNames.size(); ++i) {
    const auto integrator = static_cast<Integrator>(i);
    for (const int rate : kRates) {
      progress(result.rows.size() + 1, rows + 1);
      const bool isDefault =
          integrator == flight::AirplaneSettings{}.integrator && rate == core::FixedStep::kStepsPerSecond;
      result.rows.push_back({std::string(flight::kIntegratorNames[i]) + " at " + std::to_string(rate) + " Hz",
                             {angleBetween(attitudeAfter(integrator, rate), reference)},
                             cost(integrator, rate),
                             isDefault ? "default" : ""});
    }
  }
  return result;
}

}  // namespace skydrop::app
