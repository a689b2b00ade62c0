// The photograph of --photo in a window, over what is flown over.
#pragma once

#include <vector>

#include "app/session/photo_seen.h"
#include "app/settings/settings.h"
#include "skydrop/core/image.h"
#include "skydrop/render/gl/texture.h"
#include "skydrop/ui/photo_layer.h"

namespace skydrop::app {

// On the context's thread; must go before the context.
class PhotoOverlay {
 public:
  // Reads it, made smaller where it is larger than kMostSide. Throws core::DataError.
  static constexpr int kMostSide = 4096;
  PhotoOverlay(render::gl::Context& context, const PhotoRequest& request);

  // What to draw over a frame of the view, which has room to the left (photo_seen.h) where the photograph is
  // set beside it; null where the settings show none. Valid until the next call.
  const ui::PhotoLayer* layer(const render::View& view, const ViewSettings& settings);

 private:
  PhotoRequest request_;
  core::Image photo_;
  render::gl::Texture texture_;
  std::vector<ui::PhotoVertex> vertices_;
  ui::PhotoLayer layer_;
};

}  // namespace skydrop::app
