// Textures as pictures that can be looked at.
#pragma once

#include <string>

#include "skydrop/core/dds.h"
#include "skydrop/core/image.h"

namespace skydrop::app {

// A layer of a volume, or a whole plane: colour as it is stored and opaque (rgba8), grey (r8), or white with
// the alpha (a8). Throws core::RangeError for other formats.
core::Image pictureOf(const core::TextureData& texture, int layer);

// The file of a layer: "noise.png" of a plane, "noise-007.png" of a volume's eighth. `file` ends in .png.
std::string layerFile(const std::string& file, const core::TextureData& texture, int layer);

}  // namespace skydrop::app
