// A subject that is a function of a described struct (core/settings.h): its parameters are what studies turn.
#pragma once

#include <exception>

#include "app/measure/stopwatch.h"
#include "app/measure/system_info.h"
#include "skydrop/accuracy/subject.h"
#include "skydrop/core/cpu_clock.h"
#include "skydrop/core/error.h"
#include "skydrop/core/settings_table.h"

namespace skydrop::app {

// Parameters: default-constructible, with a describe() of its own.
template <class Parameters>
class TableSubject : public accuracy::Subject {
 public:
  accuracy::Assignments checked(const accuracy::Experiment& experiment) const final {
    if (experiment.timed != "cpu") throw core::RangeError("timed: '" + experiment.timed + "' is not cpu");
    Parameters parameters;
    const core::SettingsTable table(parameters);
    accuracy::Assignments all;
    for (const std::string& one : experiment.set) {
      core::setField(table, one);
      const core::Field& field = table.at(one.substr(0, one.find('=')));
      all.push_back(field.path + "=" + core::fieldText(field));
    }
    return all;
  }

  accuracy::Observation observe(const accuracy::Experiment& experiment) final {
    return compute(parametersOf(experiment));
  }

  // So often that the clock resolves it; the mean of those.
  double timeOnce(const accuracy::Experiment& experiment) final {
    constexpr double kLeastMs = 4, kLongestMs = 100;  // of the thread; of waiting for others
    const Parameters parameters = parametersOf(experiment);
    int runs = 0;
    const Stopwatch watch;
    const core::CpuClock clock;
    do {
      result_ = work(parameters);
      ++runs;
    } while (clock.ms() < kLeastMs && watch.ms() < kLongestMs);
    return (waitsForThreads(parameters) ? watch.ms() : clock.ms()) / runs;
  }

  std::string clock(const accuracy::Experiment& experiment) const final {
    return waitsForThreads(parametersOf(experiment)) ? "wall clock" : "CPU time of the thread";
  }
  std::string machine() const final { return machineName(); }

 protected:
  virtual accuracy::Observation compute(const Parameters& parameters) = 0;
  // Whether work() is done by other threads, so that this one's CPU time says nothing.
  virtual bool waitsForThreads(const Parameters&) const { return false; }
  // What is timed; returns something that depends on all of it.
  virtual double work(const Parameters& parameters) = 0;

 private:
  static Parameters parametersOf(const accuracy::Experiment& experiment) {
    Parameters parameters;
    const core::SettingsTable table(parameters);
    for (const std::string& one : experiment.set) core::setField(table, one);
    return parameters;
  }

  volatile double result_ = 0;  // so that no work is left out
};

}  // namespace skydrop::app
