// Whether the driver still works, asked once a frame.
#pragma once

#include "skydrop/render/gl/context.h"

namespace skydrop::render::gl {

// Throws core::GraphicsUnavailable where the driver has lost the device, after which nothing is drawn any
// more; core::DataError where it has run out of memory since it was asked last. The context must be current.
void requireDevice(const Context& context);

}  // namespace skydrop::render::gl
