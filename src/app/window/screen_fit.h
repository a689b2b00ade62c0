// Where a window may open. Pure arithmetic, in window coordinates.
#pragma once

#include <span>

#include "skydrop/render/platform/window_context.h"

namespace skydrop::app {

// The window's content as close to `wanted` as its screen allows: no larger than the work area of the screen
// that holds most of it (the first one where none does), frame included, and wholly on it. `screens`: work
// areas, the primary one first; without any the window is as wanted.
render::gl::WindowRect heldToScreen(const render::gl::WindowRect& wanted,
                                    const render::gl::WindowFrame& frame,
                                    std::span<const render::gl::WindowRect> screens);

}  // namespace skydrop::app
