// Counters and clocks of the GPU. On the context's thread; a query must go before its context.
#pragma once

#include <cstdint>
#include <optional>

#include "skydrop/render/gl/object.h"

namespace skydrop::render::gl {

// One query object of a fixed target, which decides what is measured between begin() and end(), and in which
// unit: GL_TIME_ELAPSED nanoseconds, GL_PRIMITIVES_GENERATED primitives, GL_SAMPLES_PASSED samples. A timer
// means nothing on a software renderer (Context::isSoftware).
//
// Order of calls: begin(), end(), then poll() or result() as often as wanted; begin() again drops the last
// result. Of one target a single query may be open in a context at a time. Another order, or a target that
// OpenGL 4.5 does not have, is an error that the driver reports (Context::debugErrors); nothing is thrown.
class Query : public Object {
 public:
  Query() = default;  // no object: may be assigned to and destroyed, nothing else
  Query(Context& context, GLenum target);

  void begin();
  void end();
  // The result if it has arrived, which takes some frames on hardware; never waits.
  std::optional<std::uint64_t> poll() const;
  // Waits until the GPU has come past end(): for the end of a measuring run, not for every frame.
  std::uint64_t result() const;

 private:
  GLenum target_ = 0;
};

}  // namespace skydrop::render::gl
