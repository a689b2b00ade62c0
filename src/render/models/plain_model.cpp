#include "render/models/plain_model.h"

#include <algorithm>
#include <cctype>

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/render/models/model_import.h"

namespace skydrop::render {

using core::DataError;

ModelFormat modelFormat(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".obj") return ModelFormat::obj;
  if (extension == ".gltf") return ModelFormat::gltf;
  if (extension == ".glb") return ModelFormat::glb;
  throw DataError(path.string(), "", "is not a model: only .obj, .gltf and .glb are read");
}

std::filesystem::path ModelFolder::find(const std::string& place, const std::string& reference) const {
  const bool isForeign = reference.empty() || reference.find(':') != std::string::npos ||
                         reference.find('\0') != std::string::npos;
  const std::filesystem::path relative = std::filesystem::path(reference).lexically_normal();
  if (isForeign || relative.is_absolute() || *relative.begin() == "..") {
    throw DataError(model_.string(), place, "'" + reference + "' is not a file in the model's folder");
  }
  const std::filesystem::path path = model_.parent_path() / relative;
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    throw DataError(model_.string(), place, "file '" + reference + "' is missing");
  }
  return path;
}

std::vector<std::byte> ModelFolder::read(const std::string& place, const std::string& reference) {
  std::vector<std::byte> bytes = core::readFile(find(place, reference), kMaxModelFileBytes);
  bytes_ += bytes.size();
  if (bytes_ > 2 * kMaxModelFileBytes) throw DataError(model_.string(), place, "the model is too large");
  return bytes;
}

int ModelFolder::texture(PlainModel& plain, const std::string& place, const std::string& reference) {
  const std::filesystem::path file = find(place, reference);
  const auto [known, isNew] = textures_.emplace(file, static_cast<int>(plain.textures.size()));
  if (isNew) plain.textures.push_back({place, file, {}});
  return known->second;
}

}  // namespace skydrop::render
