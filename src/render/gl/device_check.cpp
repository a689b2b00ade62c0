#include "render/gl/device_check.h"

#include "render/gl/owned_functions.h"
#include "skydrop/core/error.h"

namespace skydrop::render::gl {

void requireDevice(const Context& context) {
  constexpr int kMostErrors = 64;  // flags of OpenGL; a context that is lost may go on for ever
  bool isLost = context.owned().GetGraphicsResetStatus() != GL_NO_ERROR, isFull = false;
  GLenum error = GL_NO_ERROR;
  for (int i = 0; i < kMostErrors && (error = context.api().GetError()) != GL_NO_ERROR; ++i) {
    isLost = isLost || error == GL_CONTEXT_LOST;
    isFull = isFull || error == GL_OUT_OF_MEMORY;
  }
  if (isLost) throw core::GraphicsUnavailable("OpenGL: the driver has lost the graphics device");
  if (isFull) throw core::DataError("OpenGL", "frame", "the driver has run out of memory");
}

}  // namespace skydrop::render::gl
