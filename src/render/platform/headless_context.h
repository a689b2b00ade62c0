// The headless back-ends. Private: openHeadless() in context.h is the way in.
#pragma once

#include <memory>

#include "skydrop/render/gl/context.h"

namespace skydrop::render::gl {

std::unique_ptr<Context> openEgl();
std::unique_ptr<Context> openOsMesa();

}  // namespace skydrop::render::gl
