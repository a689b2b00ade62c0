// What a driver gives when it is asked for a new object.
#pragma once

#include <GL/glcorearb.h>

#include <string>

#include "skydrop/core/error.h"

namespace skydrop::render::gl {

// The object's name. Throws core::DataError where the driver gave none, since it is out of memory or has lost
// the device: who asked keeps its last good state.
inline GLuint created(GLuint name, const char* kind) {
  if (name == 0)
    throw core::DataError("OpenGL", kind,
                          "cannot be created: the driver is out of memory or has lost the device");
  return name;
}

}  // namespace skydrop::render::gl
