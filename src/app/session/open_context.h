// The OpenGL context of a headless run.
#pragma once

#include <memory>
#include <optional>

#include "app/types/size.h"
#include "skydrop/render/gl/context.h"

namespace skydrop::app {

// The back-end that was asked for; unasked: EGL, and OSMesa where EGL gives no OpenGL 4.5 core. Throws
// core::GraphicsUnavailable.
std::unique_ptr<render::gl::Context> openContext(std::optional<render::gl::Backend> backend, Size size);

}  // namespace skydrop::app
