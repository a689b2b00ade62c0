// Where the sky is: in a rendered frame, which knows, and in a photograph, by a guess.
#pragma once

#include <span>

#include "skydrop/core/image.h"
#include "skydrop/render/frame/view.h"

namespace skydrop::app {

// White where a frame of the view shows sky: where there is no land and the ray does not go down to the sea.
// `landDepth`: reversed depth of the land, of the view's size, bottom row first; empty: there is no land at
// all, and everything is sky. Aircraft, packages and clouds count as what is behind them.
core::Image skyOfFrame(const render::View& view, std::span<const float> landDepth);

// White where a photograph shows sky, as far as a border that each column crosses once tells: the first pixel
// from above whose gradient of brightness is above a threshold, the threshold being that which makes both
// sides most uniform in colour (Shen and Wang, Sky region detection in a single image, 2013). Clouds with
// hard edges, and masts, are taken for ground.
core::Image skyOfPhoto(const core::Image& photo);

}  // namespace skydrop::app
