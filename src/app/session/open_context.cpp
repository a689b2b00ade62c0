#include "app/session/open_context.h"

#include "skydrop/core/error.h"
#include "skydrop/render/platform/window_context.h"

namespace skydrop::app {

using render::gl::Backend;
using render::gl::Context;

std::unique_ptr<Context> openContext(std::optional<Backend> backend, Size size) {
  if (backend == Backend::window) {
    return std::make_unique<render::gl::WindowContext>(
        render::gl::WindowSettings{.width = size.width, .height = size.height, .visible = false});
  }
  if (backend) return render::gl::openHeadless(*backend);
  try {
    return render::gl::openHeadless(Backend::egl);
  } catch (const core::GraphicsUnavailable& egl) {
    try {
      return render::gl::openHeadless(Backend::osmesa);
    } catch (const core::GraphicsUnavailable& osmesa) {
      throw core::GraphicsUnavailable(std::string(egl.what()) + "; " + osmesa.what());
    }
  }
}

}  // namespace skydrop::app
