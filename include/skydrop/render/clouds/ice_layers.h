// The layers of ice of a frame. Main thread.
#pragma once

#include <vector>

#include "skydrop/clouds/ice_clouds.h"
#include "skydrop/core/wind.h"
#include "skydrop/render/frame/frame_input.h"

namespace skydrop::render {

class IceLayers {
 public:
  IceLayers(const clouds::IceCloudSettings& settings, const core::WindSettings& wind)
      : settings_(settings), wind_(wind) {}

  const clouds::IceCloudSettings& settings() const { return settings_; }
  // The weather's at the eye (game::Snapshot::weather), where the frame has weather; else the one made by
  // hand, or none without cover. Drifted to the frame's time. Empty ones are left out.
  std::vector<clouds::IceField> of(const FrameInput& frame) const;

 private:
  clouds::IceCloudSettings settings_;
  core::WindSettings wind_;
};

}  // namespace skydrop::render
