// What a photograph shows of a view: the same for pictures that are written and for the window.
#pragma once

#include <glm/vec2.hpp>

#include "app/types/photo_request.h"
#include "skydrop/core/image.h"
#include "skydrop/render/frame/view.h"

namespace skydrop::app {

// Where the photograph shows what a pixel of the view sees (from the lower left, centres at .5), in shares of
// its width and height from its upper left corner; outside of [0, 1] nowhere. Of a panorama the middle row is
// the horizon, and a degree is as many pixels high as wide; else the photograph's middle is the view's, by
// its field of view or, without one, by the view's.
glm::dvec2 photoPlaceOf(const core::Image& photo, const PhotoRequest& request, const render::View& view,
                        const glm::dvec2& pixel);

// The view moved by a quarter of its width, so that the middle half of what it shows fills the right half of
// the picture: room for the middle half of a photograph in the left.
render::View withRoomToTheLeft(const render::View& view);

// The photograph as the view would see it: of the view's size, transparent where it shows nothing.
core::Image asSeen(const core::Image& photo, const PhotoRequest& request, const render::View& view);

// The picture with the photograph of its size: laid over it, up to a share of its width, or to its left.
core::Image together(const core::Image& picture, const core::Image& photo, PhotoView view, double share);

}  // namespace skydrop::app
