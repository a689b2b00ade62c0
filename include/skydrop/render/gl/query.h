#pragma once

#include <cstdint>
#include <optional>

#include "skydrop/render/gl/object.h"

namespace skydrop::render::gl {

// One query object of a fixed target (GL_TIME_ELAPSED, GL_PRIMITIVES_GENERATED, GL_SAMPLES_PASSED ...).
class Query : public Object {
 public:
  Query() = default;
  Query(Context& context, GLenum target);

  void begin();
  void end();
  // The result if it has arrived; never waits.
  std::optional<std::uint64_t> poll() const;
  // Waits for the result.
  std::uint64_t result() const;

 private:
  GLenum target_ = 0;
};

}  // namespace skydrop::render::gl
