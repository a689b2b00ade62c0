// The picture as it is drawn beside that of a reference, while time and camera stand still. Both are kept:
// the picture of the present settings, and that of the reference, drawn in parts from coarse to fine where
// the window must go on, so that no frame waits for all of it. The error between them is measured on a thread
// of its own. Main thread, on the context's thread.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/session/refinement.h"
#include "app/session/scene_renderer.h"
#include "app/session/split_reference.h"
#include "skydrop/core/image.h"
#include "skydrop/core/latest_job.h"
#include "skydrop/render/overlay/split_pass.h"

namespace skydrop::app {

class SplitView {
 public:
  // Adds its pass to the renderer and from now on decides by which settings that draws. `present` are those
  // that are drawn else. Both must outlive it.
  SplitView(SceneRenderer& sceneRenderer, const Settings& present, SplitReference reference);
  // The renderer draws by the present settings again, and nothing of this is left.
  ~SplitView();
  SplitView(const SplitView&) = delete;
  SplitView& operator=(const SplitView&) = delete;

  const SplitReference& reference() const { return reference_; }
  void setDivider(double divider) { pass_->setDivider(divider); }
  // On the right how visible the error is, once it is known, in place of the reference.
  void setHeat(bool heat);

  // One frame into the renderer's output, interface included. Draws parts of the reference for `budgetMs` and
  // then as long as the last of them takes. Begins again where the snapshot, the size or the view is another.
  // Throws what SceneRenderer::draw() throws.
  void draw(const game::Snapshot& snapshot, Size size, double budgetMs);
  // Makes both pictures at once, with all their land, and measures the error: draw() then shows them.
  void makeWhole(const game::Snapshot& snapshot, Size size);

  // Of the reference, 0 .. 1.
  double share() const { return stage_ == Stage::present ? 0 : refinement_.share(); }
  struct Error {
    double rmse = 0, relativeRmse = 0;  // linear radiance; over its mean magnitude
    std::optional<double> flip;         // mean of the map; once all of the reference is there
    bool isComplete() const { return flip.has_value(); }
  };
  // The budgets of the land had no room for all of the reference.
  bool isCoarser() const { return isCoarser_; }
  // Over what the finest round has drawn so far; nothing before it.
  std::optional<Error> error() const;
  void writeTo(core::FrameStatistics& statistics) const;

 private:
  enum class Stage { present, reference };
  struct Radiance {
    std::vector<float> present, reference;
    int width = 0, height = 0;
  };
  struct Measured {
    std::shared_ptr<const Radiance> of;
    Error error;
    core::Image heat;
  };
  static Measured measured(std::shared_ptr<const Radiance> radiance);

  void follow(const game::Snapshot& snapshot, Size size);
  void keepPresent(std::vector<float> radiance);
  void refine(const game::Snapshot& snapshot, double budgetMs);
  void take(const Refinement::Part& part, const std::vector<float>& radiance);
  void complete();
  void takeMeasured();
  void showRight();
  void noteLand();

  SceneRenderer& sceneRenderer_;
  const Settings& present_;
  SplitReference reference_;
  render::SplitPass* pass_;       // the renderer's
  std::uint64_t programsBefore_;  // what the renderer's shaders had made
  Stage stage_ = Stage::present;
  std::optional<render::View> view_;  // that is kept
  double seconds_ = 0;                // of the snapshot
  int framesOfView_ = 0;              // that were drawn of it
  Refinement refinement_;
  Radiance radiance_;
  core::Image shown_;                    // the reference, as far as it is drawn
  double squares_ = 0, magnitudes_ = 0;  // sums over what the finest round has drawn
  std::size_t values_ = 0;
  bool isCoarser_ = false;
  bool heat_ = false;
  std::shared_ptr<const Radiance> asked_;  // whose error is wanted
  std::optional<Measured> measured_;
  core::LatestJob<std::shared_ptr<const Radiance>, Measured> measuring_;
};

}  // namespace skydrop::app
