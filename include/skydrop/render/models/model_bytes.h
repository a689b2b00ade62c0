// A ModelData as bytes and back, for a model that another process has read.
#pragma once

#include <string>
#include <string_view>

#include "skydrop/render/models/model_import.h"

namespace skydrop::render {

std::string bytesOf(const ModelData& model);

// Believes nothing: counts are held to what is there before anything is allocated, and what importModel()
// promises is checked again (indices, parents, sizes of pictures, finite numbers). Throws core::DataError
// that names `file`.
ModelData modelOf(std::string_view bytes, std::string_view file);

}  // namespace skydrop::render
