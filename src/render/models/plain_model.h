// A model file as assimp gets it: read and judged here, and written again with nothing but what was judged.
//
// A check and a library that both read the same bytes can read them differently (a member that comes twice,
// an index with a leading zero), and assimp 5.2.5 drops, repairs and guesses silently, follows a node that is
// its own ancestor until the stack ends, and believes a count before it looks at the bytes. So it never sees
// a foreign file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace skydrop::render {

enum class ModelFormat { obj, gltf, glb };

// By extension, whatever its case. Throws core::DataError for any other.
ModelFormat modelFormat(const std::filesystem::path& path);

// A picture that a material names; read when the material is used.
struct TextureSource {
  std::string place;                 // in the model, for messages
  std::filesystem::path file;        // beside the model; empty when the picture lies in the model
  std::span<const std::byte> bytes;  // then these, in PlainModel::storage
};

struct PlainModel {
  std::vector<std::byte> bytes;            // OBJ text, or binary glTF
  std::string materialFile;                // of an OBJ
  std::vector<std::string> materialNames;  // of an OBJ: material k is called mk there
  std::vector<TextureSource> textures;     // materials name them by their index
  std::vector<std::vector<std::byte>> storage;
};

// Files round: a normal whose length is off by up to this is made right, anything else is not a normal.
inline constexpr double kNormalTolerance = 0.05;

// assimp gets the model under one of these names.
inline constexpr const char* kPlainObj = "model.obj";
inline constexpr const char* kPlainMaterials = "model.mtl";
inline constexpr const char* kPlainGltf = "model.glb";

// Both read the model, and what it names but textures, and throw core::DataError.
PlainModel readPlainObj(const std::filesystem::path& path);
PlainModel readPlainGltf(const std::filesystem::path& path, ModelFormat format);

// The files that a model names: a relative path without "..", beside the model or below its folder.
class ModelFolder {
 public:
  explicit ModelFolder(const std::filesystem::path& model) : model_(model) {}

  // Throws core::DataError, which names the model and the place, for an absolute path, one that leaves the
  // folder, a URL, and a file that does not exist.
  std::filesystem::path find(const std::string& place, const std::string& reference) const;
  // The content. All that is read of one model is bounded, however often it names the same file.
  std::vector<std::byte> read(const std::string& place, const std::string& reference);
  // Index of a file in PlainModel::textures.
  int texture(PlainModel& plain, const std::string& place, const std::string& reference);

 private:
  std::filesystem::path model_;
  std::size_t bytes_ = 0;
  std::map<std::filesystem::path, int> textures_;
};

}  // namespace skydrop::render
