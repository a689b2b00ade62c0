#include <array>

#include "app/studies/subjects.h"
#include "app/studies/table_subject.h"
#include "skydrop/flight/environment.h"
#include "skydrop/flight/package.h"

namespace skydrop::app {
namespace {

enum class LandingSolver { euler, exactDrag, prediction };
constexpr std::array<std::string_view, 3> kSolverNames = {"euler", "exactDrag", "prediction"};

struct LandingParameters {
  LandingSolver solver = LandingSolver::prediction;
  double stepSeconds = 0.1;
};

void describe(core::SettingsVisitor& visitor, LandingParameters& p) {
  visitor.choice("solver", p.solver, kSolverNames,
                 {.help = "Semi-implicit Euler, the package's own step, or the game's prediction."});
  visitor.number("stepSeconds", p.stepSeconds,
                 {.unit = "s", .min = 1e-5, .max = 10, .help = "Length of a step; not of the prediction."});
}

constexpr glm::dvec3 kWind(6, 0, -3);
constexpr int kReleases = 8;  // from 150 m upwards, at growing speed

flight::PointState release(int index) {
  return {{0, 150.0 + 75 * index, 0}, {40.0 + 5 * index, -2.0 * index, 10}};
}

flight::PointState stepped(const LandingParameters& p, const flight::PointState& state, double age,
                           double dt) {
  const flight::PackageSettings settings;
  if (p.solver == LandingSolver::exactDrag) return flight::packageStep(settings, state, age, kWind, dt);
  const double rate = flight::dragRateAt(settings, flight::parachuteOpenAt(settings, age));
  flight::PointState next = state;
  next.velocity += dt * (glm::dvec3(0, -flight::kGravity, 0) - rate * (state.velocity - kWind));
  next.position += dt * next.velocity;
  return next;
}

glm::dvec3 landingOf(const LandingParameters& p, int index) {
  flight::PointState state = release(index);
  if (p.solver == LandingSolver::prediction) {
    return flight::predictLanding({}, state, kWind, [](const glm::dvec2&) { return 0.0; }).value().position;
  }
  for (std::int64_t step = 0;; ++step) {
    const double age = static_cast<double>(step) * p.stepSeconds;
    const flight::PointState next = stepped(p, state, age, p.stepSeconds);
    if (next.position.y <= 0) {  // where the step crosses the ground: the end of a shorter one, by bisection
      double low = 0, high = p.stepSeconds;
      for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (stepped(p, state, age, middle).position.y > 0 ? low : high) = middle;
      }
      return stepped(p, state, age, high).position;
    }
    state = next;
  }
}

class LandingSubject final : public TableSubject<LandingParameters> {
  accuracy::Observation compute(const LandingParameters& p) override {
    accuracy::Observation observation;
    for (int i = 0; i < kReleases; ++i) observation.positions.push_back(landingOf(p, i));
    return observation;
  }
  double work(const LandingParameters& p) override { return landingOf(p, 3).x; }
};

}  // namespace

std::unique_ptr<accuracy::Subject> makeLandingSubject() { return std::make_unique<LandingSubject>(); }

}  // namespace skydrop::app
