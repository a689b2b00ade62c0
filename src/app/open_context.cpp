#include "app/open_context.h"

#include "skydrop/core/error.h"
#include "skydrop/render/gl/window_context.h"

namespace skydrop::app {

using render::gl::Context;

std::unique_ptr<Context> openContext(std::optional<Backend> backend, Size size) {
  if (backend == Backend::window) {
    return std::make_unique<render::gl::WindowContext>(
        render::gl::WindowSettings{.width = size.width, .height = size.height, .visible = false});
  }
  if (backend == Backend::egl) return render::gl::openHeadless(render::gl::Backend::egl);
  if (backend == Backend::osmesa) return render::gl::openHeadless(render::gl::Backend::osmesa);
  try {
    return render::gl::openHeadless(render::gl::Backend::egl);
  } catch (const core::GraphicsUnavailable& egl) {
    try {
      return render::gl::openHeadless(render::gl::Backend::osmesa);
    } catch (const core::GraphicsUnavailable& osmesa) {
      throw core::GraphicsUnavailable(std::string(egl.what()) + "; " + osmesa.what());
    }
  }
}

}  // namespace skydrop::app
