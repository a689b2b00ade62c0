#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "skydrop/render/gl/context.h"

namespace skydrop::render::gl {

// The limits of a context that matter to the game, with their names in words: what `skydrop info` prints.
// Largest sides in texels, counts, and bytes, as the names say. On the context's thread.
std::vector<std::pair<std::string, std::int64_t>> describeLimits(const Context& context);

}  // namespace skydrop::render::gl
