// What a model file must hold before assimp is let near it. assimp 5.2.5 follows a node that is its own
// ancestor until the stack ends, and believes a count before it looks at the bytes.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

namespace skydrop::render {

enum class ModelFormat { obj, gltf, glb };

// By extension, whatever its case. Throws core::DataError for any other.
ModelFormat modelFormat(const std::filesystem::path& path);

// Both throw core::DataError.
void checkObj(std::string_view file, std::string_view text);
void checkGltf(std::string_view file, std::span<const std::byte> bytes, ModelFormat format);

// A file beside the model, or below its folder, as a relative path without "..". Throws core::DataError for
// an absolute one, one that leaves the folder, and for URLs.
std::filesystem::path besideModel(const std::filesystem::path& model, std::string_view reference);

}  // namespace skydrop::render
