#include "app/session/split_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/measure/stopwatch.h"
#include "app/session/observed_picture.h"
#include "skydrop/accuracy/flip.h"
#include "skydrop/accuracy/metrics.h"

namespace skydrop::app {
namespace {

constexpr std::string_view kGroup = "split";
constexpr std::string_view kHeld = "the split view shows a picture that is kept";
// A picture is kept once it stands still, and land that is on its way is waited for, but not forever.
constexpr int kStillFrames = 2, kMostFramesForLand = 600;

bool isSame(const render::View& a, const render::View& b) {
  return a.position == b.position && a.worldToView == b.worldToView && a.fovYRad == b.fovYRad &&
         a.width == b.width && a.height == b.height;
}

double metric(std::string_view name, const accuracy::Observation& a, const accuracy::Observation& reference) {
  return accuracy::findMetric(name)->measure(a, reference);
}

accuracy::SeenPicture seenOf(const accuracy::Observation& o) { return {o.width, o.height, o.seen}; }

}  // namespace

SplitView::SplitView(SceneRenderer& sceneRenderer, const Settings& present, SplitReference reference)
    : sceneRenderer_(sceneRenderer),
      present_(present),
      reference_(std::move(reference)),
      measuring_([](const std::shared_ptr<const Radiance>& radiance, const std::stop_token&) {
        return measured(radiance);
      }) {
  render::Renderer& renderer = sceneRenderer_.renderer();
  programsBefore_ = renderer.shaders().madeSoFar();
  renderer.setGroup({std::string(kGroup), 0});
  auto pass = std::make_unique<render::SplitPass>(renderer.context());
  pass_ = pass.get();
  renderer.add(std::move(pass));
  renderer.setGroup({});
  pass_->setDivider(present_.view.split.divider);
  heat_ = present_.view.split.heat;
}

SplitView::~SplitView() {
  sceneRenderer_.renderer().removeGroup(kGroup);
  sceneRenderer_.endUnseen();
  sceneRenderer_.useSettings(present_);
  sceneRenderer_.renderer().shaders().deleteMadeAfter(programsBefore_);
}

void SplitView::setHeat(bool heat) {
  if (std::exchange(heat_, heat) != heat && measured_) showRight();
}

// Begins with another picture where it is another one.
void SplitView::follow(const game::Snapshot& snapshot, Size size) {
  const render::View view = sceneRenderer_.view(snapshot, size);
  ++framesOfView_;
  if (view_ && isSame(*view_, view) && seconds_ == snapshot.simulatedSeconds) return;
  view_ = view;
  seconds_ = snapshot.simulatedSeconds;
  framesOfView_ = 1;
  stage_ = Stage::present;
  measured_.reset();
  asked_.reset();
  pass_->forget();
  sceneRenderer_.useSettings(present_);
}

void SplitView::keepPresent(std::vector<float> radiance) {
  const int width = view_->width, height = view_->height;
  radiance_ = {std::move(radiance), {}, width, height};
  radiance_.reference = radiance_.present;
  shown_ = seenPicture(radiance_.present, width, height);
  pass_->setLeft(shown_);
  pass_->setRight(shown_);
  squares_ = magnitudes_ = 0;
  values_ = 0;
  refinement_ = Refinement({width, height});
  stage_ = Stage::reference;
  framesOfView_ = 0;
  sceneRenderer_.useSettings(reference_.settings);
}

void SplitView::draw(const game::Snapshot& snapshot, Size size, double budgetMs) {
  follow(snapshot, size);
  if (stage_ == Stage::present) {
    sceneRenderer_.draw(snapshot, size, Streaming::asItComes);
    const bool isThere = !sceneRenderer_.land() || sceneRenderer_.land()->isSettled();
    if (framesOfView_ >= kStillFrames && (isThere || framesOfView_ > kMostFramesForLand))
      keepPresent(sceneRenderer_.renderer().readRadiance());
    return;
  }
  if (!refinement_.isDone()) refine(snapshot, budgetMs);
  takeMeasured();
  sceneRenderer_.drawOverlays(snapshot, size, kHeld);
}

void SplitView::refine(const game::Snapshot& snapshot, double budgetMs) {
  const bool isThere = sceneRenderer_.updateLand(*view_, Streaming::asItComes);
  if (!isThere && framesOfView_ <= kMostFramesForLand) return;
  const Stopwatch watch;
  do {
    const Refinement::Part part = refinement_.next();
    const Stopwatch drawing;
    const auto radiance =
        sceneRenderer_.drawUnseen(snapshot, render::partOf(*view_, part.corner, part.side, part.pixelSize));
    if (!radiance) break;  // a program was compiled, and another one is to be
    refinement_.drawn(drawing.ms());
    take(part, *radiance);
  } while (!refinement_.isDone() && watch.ms() < budgetMs);
  if (refinement_.isDone()) complete();
  pass_->setRight(shown_);
}

// Into the picture, where every pixel of a coarse part is a square of the picture's.
void SplitView::take(const Refinement::Part& part, const std::vector<float>& radiance) {
  const int width = radiance_.width, height = radiance_.height, size = part.side * part.pixelSize;
  const int right = std::min(part.corner.x + size, width), top = std::min(part.corner.y + size, height);
  for (int y = part.corner.y; y < top; ++y) {  // from the lowest row
    const int rowOfPart = part.side - 1 - (y - part.corner.y) / part.pixelSize;
    for (int x = part.corner.x; x < right; ++x) {
      const int columnOfPart = (x - part.corner.x) / part.pixelSize;
      const std::size_t from =
          3 * (static_cast<std::size_t>(rowOfPart) * static_cast<std::size_t>(part.side) +
               static_cast<std::size_t>(columnOfPart));
      const std::size_t pixel = static_cast<std::size_t>(height - 1 - y) * static_cast<std::size_t>(width) +
                                static_cast<std::size_t>(x);
      std::uint8_t* shown = &shown_.rgba[4 * pixel];
      const bool isRepeated = (x - part.corner.x) % part.pixelSize != 0;
      if (isRepeated) {
        std::copy(shown - 4, shown, shown);
      } else {
        writeSeen({radiance[from], radiance[from + 1], radiance[from + 2]}, shown);
      }
      for (std::size_t k = 0; k < 3; ++k) {
        const float value = radiance[from + k];
        radiance_.reference[3 * pixel + k] = value;
        if (part.pixelSize > 1) continue;
        const double error =
            static_cast<double>(radiance_.present[3 * pixel + k]) - static_cast<double>(value);
        squares_ += error * error;
        magnitudes_ += std::abs(static_cast<double>(value));
        ++values_;
      }
    }
  }
}

void SplitView::noteLand() {
  const terrain::EndlessTerrain* land = sceneRenderer_.land();
  isCoarser_ = reference_.subject == SplitSubject::land && land &&
               land->statistics().coarsened + land->statistics().overBudget > 0;
}

void SplitView::complete() {
  noteLand();
  sceneRenderer_.endUnseen();
  asked_ = std::make_shared<const Radiance>(radiance_);
  measuring_.request(asked_);
}

SplitView::Measured SplitView::measured(std::shared_ptr<const Radiance> radiance) {
  const int width = radiance->width, height = radiance->height;
  const accuracy::Observation present = observedPicture(radiance->present, width, height),
                              reference = observedPicture(radiance->reference, width, height);
  const std::vector<double> map = accuracy::flipMap(seenOf(present), seenOf(reference));
  double sum = 0;
  for (const double error : map) sum += error;
  return {std::move(radiance),
          {metric("rmse", present, reference), metric("relativeRmse", present, reference),
           sum / static_cast<double>(map.size())},
          accuracy::heatMap(map, width, height)};
}

void SplitView::takeMeasured() {
  std::optional<Measured> taken = measuring_.take();
  if (!taken || taken->of != asked_) return;
  measured_ = std::move(taken);
  showRight();
}

void SplitView::showRight() { pass_->setRight(heat_ ? measured_->heat : shown_); }

void SplitView::makeWhole(const game::Snapshot& snapshot, Size size) {
  view_.reset();
  follow(snapshot, size);
  const auto whole = [&] {
    sceneRenderer_.updateLand(*view_, Streaming::settled);
    std::optional<std::vector<float>> radiance;
    while (!radiance) radiance = sceneRenderer_.drawUnseen(snapshot, *view_);
    return *radiance;
  };
  keepPresent(whole());
  radiance_.reference = whole();
  noteLand();
  shown_ = seenPicture(radiance_.reference, radiance_.width, radiance_.height);
  refinement_ = Refinement();
  sceneRenderer_.endUnseen();
  measured_ = measured(std::make_shared<const Radiance>(radiance_));
  showRight();
}

std::optional<SplitView::Error> SplitView::error() const {
  if (measured_) return measured_->error;
  if (values_ == 0 || stage_ == Stage::present) return std::nullopt;
  const auto count = static_cast<double>(values_);
  const double rmse = std::sqrt(squares_ / count), mean = magnitudes_ / count;
  return Error{rmse, rmse / (mean > 0 ? mean : 1), std::nullopt};
}

void SplitView::writeTo(core::FrameStatistics& statistics) const {
  if (!measured_) return;
  const Error& error = measured_->error;
  statistics.split = {
      std::string(kSplitSubjectNames[static_cast<std::size_t>(reference_.subject)]) + "=" + reference_.name,
      error.rmse, error.relativeRmse, error.flip.value_or(0)};
}

}  // namespace skydrop::app
