// The shadows that mountains cast on land, sea and models. Does not draw: makes what later passes are lit by.
#pragma once

#include <memory>
#include <optional>

#include "skydrop/core/latest_job.h"
#include "skydrop/render/frame/light_shares.h"
#include "skydrop/render/frame/pass.h"
#include "skydrop/render/shadows/land_shadow_map.h"
#include "skydrop/render/shadows/land_shadow_settings.h"
#include "skydrop/terrain/land_shade.h"

namespace skydrop::render {

// Publishes LandShadowMap, for surfaces that are lit after it, and LightAtPlaces, for models: what was
// published before it, times what land leaves of the sun. Where no shadow of land can be in the picture it is
// skipped and publishes nothing.
//
// Main thread; a thread of its own, which the first frame with a sun over hills starts, works the shade out.
// A frame that follows another (FrameInput::followsLast) goes on with the newest that is done, at first with
// none; any other waits for its own, so that it is a function of view, sun and land.
class LandShadowPass final : public Pass, private LightAtPlaces {
 public:
  LandShadowPass(std::shared_ptr<const terrain::HeightSource> ground, const LandShadowSettings& settings);

  // From the next frame on.
  void apply(const LandShadowSettings& settings) { settings_ = settings; }

  std::string_view name() const override { return "landShadows"; }
  RenderStage stage() const override { return RenderStage::shadows; }
  // Asks for the shade of the frame, and waits for it where the frame follows none.
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  // Only where skipReason() gave none.
  void draw(FrameContext& context) override;

  // Of memory beside the GPU's, and threads.
  std::size_t cpuBytes() const { return work_->shade ? work_->shade->bytes() : 0; }
  int threads() const { return work_->wanted ? 1 : 0; }

  // The newest; null before the first. For tests.
  const terrain::LandShade* shade() const { return work_->shade.get(); }

 private:
  using Shade = std::shared_ptr<const terrain::LandShade>;
  // What goes on beside the frames.
  struct Work {
    explicit Work(std::shared_ptr<const terrain::HeightSource> ground);
    void want(const terrain::ShadeKey& key, bool waits);

    std::optional<terrain::ShadeKey> wanted;  // the last that was asked for
    Shade shade;
    core::LatestJob<terrain::ShadeKey, Shade> job;
  };

  LightShares at(const glm::dvec3& place) const override;

  double relief_;  // m, from the sea or the lowest land above it to the highest
  LandShadowSettings settings_;
  std::unique_ptr<Work> work_;
  Shade uploaded_;
  LandShadowMap map_;
  const LightAtPlaces* before_ = nullptr;  // of the frame being drawn
};

}  // namespace skydrop::render
