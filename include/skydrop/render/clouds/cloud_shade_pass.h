// The shade of clouds on what lies below and within them. Neither draws: they make what later passes are lit
// by.
#pragma once

#include "skydrop/render/clouds/cloud_shadow_map.h"
#include "skydrop/render/clouds/cloud_system.h"
#include "skydrop/render/frame/light_shares.h"
#include "skydrop/render/frame/pass.h"

namespace skydrop::render {

// Publishes the CloudShadowMap, for surfaces that are lit after it. The system must outlive it.
class CloudShadowPass final : public Pass {
 public:
  explicit CloudShadowPass(CloudSystem& system) : system_(system) {}

  std::string_view name() const override { return "cloudShadows"; }
  RenderStage stage() const override { return RenderStage::shadows; }
  std::optional<std::string> skipReason(const FrameInput& frame) const override {
    return system_.shadowSkipReason(frame);
  }
  void draw(FrameContext& context) override {
    map_ = system_.shadowMap(context);
    context.resources.publish(map_);
  }

 private:
  CloudSystem& system_;
  CloudShadowMap map_;
};

// Publishes LightAtPlaces, for models: works nothing out before it is asked. The system must outlive it.
class CloudShadePass final : public Pass, private LightAtPlaces {
 public:
  explicit CloudShadePass(CloudSystem& system) : system_(system) {}

  std::string_view name() const override { return "cloudShade"; }
  RenderStage stage() const override { return RenderStage::shadows; }
  std::optional<std::string> skipReason(const FrameInput& frame) const override {
    return system_.shadowSkipReason(frame);
  }
  void draw(FrameContext& context) override {
    frame_ = &context.frame;
    system_.prepare(context.frame);
    context.resources.publish<LightAtPlaces>(*this);
  }

 private:
  LightShares at(const glm::dvec3& place) const override { return system_.lightAt(place, *frame_); }

  CloudSystem& system_;
  const FrameInput* frame_ = nullptr;  // of the frame being drawn
};

}  // namespace skydrop::render
