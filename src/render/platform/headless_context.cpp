#include "render/platform/headless_context.h"

#include <cassert>

namespace skydrop::render::gl {

std::unique_ptr<Context> openHeadless(Backend backend) {
  assert(backend != Backend::window);
  return backend == Backend::osmesa ? openOsMesa() : openEgl();
}

}  // namespace skydrop::render::gl
