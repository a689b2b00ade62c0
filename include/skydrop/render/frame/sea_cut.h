// In mirrored views what lies below the sea is cut off (FrameInput::isMirrored).
#pragma once

#include "skydrop/render/frame/pass.h"

namespace skydrop::render {

// While it lives meshes are cut at the plane of the sea, in a mirrored view; in others it does nothing. All
// programs that draw meanwhile must be compiled with FrameContext::meshDefines and call cutBelowSea()
// (shaders/sea_cut.glsl). On the context's thread.
class SeaCut {
 public:
  static constexpr const char* kDefine = "MIRRORED_VIEW";

  explicit SeaCut(const FrameContext& context)
      : api_(context.frame.isMirrored ? &context.gl.api() : nullptr) {
    if (api_) api_->Enable(GL_CLIP_DISTANCE0);
  }
  ~SeaCut() {
    if (api_) api_->Disable(GL_CLIP_DISTANCE0);
  }
  SeaCut(const SeaCut&) = delete;
  SeaCut& operator=(const SeaCut&) = delete;

 private:
  const gl::Functions* api_;
};

}  // namespace skydrop::render
