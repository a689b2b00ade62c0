#include "app/session/flight_recorder.h"

#include <cassert>
#include <utility>

#include "skydrop/core/fixed_step.h"

namespace skydrop::app {
namespace {

constexpr std::uint64_t kStepsBetweenCheckpoints = core::FixedStep::kStepsPerSecond;

}  // namespace

FlightRecorder::FlightRecorder(const std::filesystem::path& file)
    : name_(file.string()), file_(file, RecordFile::Existing::refused) {}

FlightRecorder::~FlightRecorder() { flush(); }

void FlightRecorder::begin(const game::InputLog& start, std::uint64_t stateHash) {
  assert(!writer_);
  writer_.emplace(start);
  checkpoint(stateHash);
}

void FlightRecorder::change(game::SettingOverride setting) { writer_->change(std::move(setting)); }

void FlightRecorder::step(const game::Controls& controls) {
  if (file_.isStopped()) return;
  if (writer_->isFull()) {
    flush();
    return file_.stop(name_ + ": the log is full: a day of flight or a million changes; the flight goes on");
  }
  writer_->append(game::quantise(controls), 1);
}

bool FlightRecorder::checkpointIsDue() const {
  return !file_.isStopped() && writer_->stepCount() % kStepsBetweenCheckpoints == 0;
}

void FlightRecorder::checkpoint(std::uint64_t stateHash) {
  writer_->checkpoint(stateHash);
  flush();
}

void FlightRecorder::flush() {
  if (writer_) file_.append(writer_->take());
}

void FlightRecorder::end(std::uint64_t stateHash) {
  if (file_.isStopped()) return;
  writer_->end(stateHash);
  flush();
}

}  // namespace skydrop::app
