#include "skydrop/render/gl/limits.h"

namespace skydrop::render::gl {

std::vector<std::pair<std::string, std::int64_t>> describeLimits(const Context& context) {
  return {{"largest texture", context.limit(GL_MAX_TEXTURE_SIZE)},
          {"largest 3D texture", context.limit(GL_MAX_3D_TEXTURE_SIZE)},
          {"texture array layers", context.limit(GL_MAX_ARRAY_TEXTURE_LAYERS)},
          {"compute invocations in a group", context.limit(GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS)},
          {"uniform block bytes", context.limit(GL_MAX_UNIFORM_BLOCK_SIZE)}};
}

}  // namespace skydrop::render::gl
