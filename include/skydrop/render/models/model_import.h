// Model files to plain data: OBJ with MTL, and glTF 2 (.gltf, .glb), read through assimp. No GL: any thread.
//
// A file is read and judged here, and assimp gets what was judged, rewritten; its result is judged before
// anyone else sees it: whatever is wrong is a core::DataError that names file, place and reason. Files that a
// model names (buffers, material files, textures) must lie in its own folder or below. What the game does not
// draw (tangents, colours, factors, other maps, optional extensions) is left out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/mat4x4.hpp>
#include <string>
#include <vector>

#include "skydrop/core/image.h"
#include "skydrop/render/models/mesh_data.h"

namespace skydrop::render {

// The largest model that is accepted.
inline constexpr std::size_t kMaxModelFileBytes = std::size_t{32} << 20;  // each file
inline constexpr std::size_t kMaxModelVertices = std::size_t{1} << 20;    // all meshes
inline constexpr std::size_t kMaxModelIndices = 3 * kMaxModelVertices;
inline constexpr std::size_t kMaxModelNodes = 1024;
inline constexpr std::size_t kMaxModelMeshes = 4096;
inline constexpr int kMaxModelDepth = 32;                                  // of nodes below each other
inline constexpr int kMaxTextureSide = 4096;                               // texels
inline constexpr std::uint64_t kMaxModelTexels = std::uint64_t{64} << 20;  // all images
inline constexpr std::size_t kMaxModelImages = 16;                         // different files
inline constexpr float kMaxModelCoordinate = 1e6f;                         // m

struct ModelMaterial {
  std::string name;
  // Indices into ModelData::images. A material may have several of each (thesis, section 3.2.5): the shader
  // sees them as texture_diffuse1, texture_diffuse2 ..., texture_specular1 ...
  std::vector<int> diffuse;
  std::vector<int> specular;  // rgb: reflectance at normal incidence (sRGB), alpha: gloss
};

struct ModelMesh {
  std::string name;
  MeshData data;     // normals of length 1 within 1e-3; where the file has none, smooth ones
  int material = 0;  // index into ModelData::materials
};

// A part with a frame of its own. Parents come before their children. The meshes of a part that mirrors wind
// the other way.
struct ModelNode {
  std::string name;
  int parent = -1;          // index into ModelData::nodes, -1 of the root
  glm::mat4 toParent{1};    // finite, affine, flattens nothing
  std::vector<int> meshes;  // indices into ModelData::meshes
};

struct ModelData {
  std::vector<ModelNode> nodes;
  std::vector<ModelMesh> meshes;
  std::vector<ModelMaterial> materials;  // at least one
  std::vector<core::Image> images;
};

ModelData importModel(const std::filesystem::path& path);

// importModel(), or one that has another process do it.
using ModelImport = std::function<ModelData(const std::filesystem::path&)>;

}  // namespace skydrop::render
