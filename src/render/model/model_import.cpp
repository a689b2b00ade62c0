#include "skydrop/render/model_import.h"

#include <assimp/BaseImporter.h>
#include <assimp/importerdesc.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstring>
#include <map>
#include <memory>

#include "render/model/file_check.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"

namespace skydrop::render {
namespace {

using core::DataError;

// A file in memory.
class MemoryStream final : public Assimp::IOStream {
 public:
  explicit MemoryStream(std::vector<std::byte> bytes) : bytes_(std::move(bytes)) {}

  size_t Read(void* target, size_t size, size_t count) override {
    if (size == 0) return 0;
    const size_t items = std::min(count, (bytes_.size() - at_) / size);
    std::memcpy(target, bytes_.data() + at_, items * size);
    at_ += items * size;
    return items;
  }
  size_t Write(const void*, size_t, size_t) override { return 0; }
  aiReturn Seek(size_t offset, aiOrigin origin) override {
    const size_t base = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? at_ : bytes_.size();
    if (offset > bytes_.size() - base) return aiReturn_FAILURE;
    at_ = base + offset;
    return aiReturn_SUCCESS;
  }
  size_t Tell() const override { return at_; }
  size_t FileSize() const override { return bytes_.size(); }
  void Flush() override {}

 private:
  std::vector<std::byte> bytes_;
  size_t at_ = 0;
};

// Gives assimp the model's own bytes, which were checked, and small files of its folder; nothing else exists.
class ModelFolder final : public Assimp::IOSystem {
 public:
  ModelFolder(const std::filesystem::path& model, std::vector<std::byte> bytes)
      : model_(model), bytes_(std::move(bytes)) {}

  bool Exists(const char* file) const override { return isModel(file) || !besideOrEmpty(file).empty(); }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* file, const char*) override {
    if (isModel(file)) return new MemoryStream(bytes_);
    const std::filesystem::path path = besideOrEmpty(file);
    if (path.empty()) return nullptr;
    return new MemoryStream(core::readFile(path, kMaxModelFileBytes));
  }
  void Close(Assimp::IOStream* stream) override { delete stream; }

 private:
  bool isModel(const char* file) const { return model_ == std::filesystem::path(file); }
  // assimp asks for a reference joined to the model's folder.
  std::filesystem::path besideOrEmpty(const char* file) const {
    std::error_code error;
    const std::filesystem::path relative = std::filesystem::path(file).lexically_normal().lexically_relative(
        model_.parent_path().lexically_normal());
    const std::filesystem::path path = besideModel(model_, relative.empty() ? file : relative.string());
    return std::filesystem::is_regular_file(path, error) ? path : std::filesystem::path();
  }

  std::filesystem::path model_;
  std::vector<std::byte> bytes_;
};

// An importer without the many formats that are not for us: some of them crash on hostile files. By name,
// because glTF 1 has the extensions of glTF 2. False where this assimp was built without it.
bool keepOnly(Assimp::Importer& importer, std::string_view name) {
  for (size_t i = importer.GetImporterCount(); i-- > 0;) {
    const aiImporterDesc* description = importer.GetImporterInfo(i);
    if (description && name == description->mName) continue;
    Assimp::BaseImporter* other = importer.GetImporter(i);
    importer.UnregisterLoader(other);
    delete other;
  }
  return importer.GetImporterCount() == 1;
}

glm::mat4 fromAssimp(const aiMatrix4x4& m) {  // rows there, columns here
  return {m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2, m.a3, m.b3, m.c3, m.d3, m.a4, m.b4, m.c4, m.d4};
}

class ModelReader {
 public:
  explicit ModelReader(const std::filesystem::path& path) : path_(path), file_(path.string()) {}

  ModelData read() {
    const ModelFormat format = modelFormat(path_);
    std::vector<std::byte> bytes = core::readFile(path_, kMaxModelFileBytes);
    if (format == ModelFormat::obj) {
      checkObj(file_, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    } else {
      checkGltf(file_, bytes, format);
    }
    Assimp::Importer importer;
    if (!keepOnly(importer, format == ModelFormat::obj ? "Wavefront Object Importer" : "glTF2 Importer")) {
      fail("", "this assimp was built without the importer for it");
    }
    importer.SetIOHandler(new ModelFolder(path_, std::move(bytes)));
    // First without any change, so that a wrong index is found before a step follows it.
    const aiScene* scene = importer.ReadFile(file_, 0);
    if (!scene || !scene->mRootNode) fail("", importer.GetErrorString());
    checkRaw(*scene);
    scene = importer.ApplyPostProcessing(aiProcess_Triangulate | aiProcess_GenSmoothNormals |
                                         aiProcess_SortByPType);
    if (!scene) fail("", importer.GetErrorString());
    readMaterials(*scene);
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) readMesh(*scene->mMeshes[i], scene->mNumMaterials);
    readNode(*scene->mRootNode, -1, 0);
    return std::move(model_);
  }

 private:
  [[noreturn]] void fail(std::string_view place, std::string_view reason) const {
    throw DataError(file_, place, reason.empty() ? "cannot be read" : reason);
  }

  static std::string placeOf(const aiMesh& mesh) { return "mesh '" + std::string(mesh.mName.C_Str()) + "'"; }

  void checkRaw(const aiScene& scene) const {
    std::size_t vertices = 0, indices = 0;
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
      const aiMesh& mesh = *scene.mMeshes[i];
      if (!mesh.mVertices || mesh.mNumFaces == 0) fail(placeOf(mesh), "has no triangles");
      if (mesh.HasBones() || mesh.mNumAnimMeshes > 0) fail(placeOf(mesh), "is animated");
      vertices += mesh.mNumVertices;
      for (unsigned v = 0; v < mesh.mNumVertices; ++v) checkPosition(mesh, v);
      for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        const aiFace& face = mesh.mFaces[f];
        indices += face.mNumIndices;
        for (unsigned k = 0; k < face.mNumIndices; ++k) {
          if (face.mIndices[k] >= mesh.mNumVertices) fail(placeOf(mesh), "an index is out of range");
        }
      }
      if (vertices > kMaxModelVertices || indices > kMaxModelIndices) fail("", "the model is too large");
    }
    if (scene.mNumMeshes == 0) fail("", "holds no mesh");
  }

  void checkPosition(const aiMesh& mesh, unsigned v) const {
    for (unsigned axis = 0; axis < 3; ++axis) {
      if (!(std::abs(mesh.mVertices[v][axis]) <= kMaxModelCoordinate)) {
        fail(placeOf(mesh) + ", vertex " + std::to_string(v), "a position is not finite, or beyond 1e6 m");
      }
    }
  }

  void readMaterials(const aiScene& scene) {
    for (unsigned i = 0; i < scene.mNumMaterials; ++i) {
      const aiMaterial& from = *scene.mMaterials[i];
      ModelMaterial material;
      material.name = from.GetName().C_Str();
      material.diffuse = readTextures(scene, from, aiTextureType_DIFFUSE, material.name);
      material.specular = readTextures(scene, from, aiTextureType_SPECULAR, material.name);
      model_.materials.push_back(std::move(material));
    }
    if (model_.materials.empty()) model_.materials.emplace_back();
  }

  std::vector<int> readTextures(const aiScene& scene, const aiMaterial& from, aiTextureType type,
                                const std::string& material) {
    std::vector<int> images;
    for (unsigned i = 0; i < from.GetTextureCount(type); ++i) {
      aiString reference;
      if (from.GetTexture(type, i, &reference) != aiReturn_SUCCESS) continue;
      images.push_back(readTexture(scene, reference.C_Str(), "material '" + material + "'"));
    }
    return images;
  }

  int readTexture(const aiScene& scene, const std::string& reference, const std::string& place) {
    if (const auto known = images_.find(reference); known != images_.end()) return known->second;
    if (model_.images.size() == kMaxModelImages) fail(place, "too many textures");
    std::vector<std::byte> bytes;
    std::string name = reference;
    if (const aiTexture* embedded = scene.GetEmbeddedTexture(reference.c_str())) {
      if (embedded->mHeight != 0) fail(place, "an embedded texture is not a PNG");
      const auto* data = reinterpret_cast<const std::byte*>(embedded->pcData);
      bytes.assign(data, data + embedded->mWidth);
      name = file_ + " (texture " + reference + ")";
    } else {
      const std::filesystem::path path = besideModel(path_, reference);
      std::error_code error;
      if (!std::filesystem::exists(path, error)) fail(place, "texture '" + reference + "' is missing");
      bytes = core::readFile(path, kMaxModelFileBytes);
      name = path.string();
    }
    core::Image image = core::decodePng(bytes, name);
    if (image.width > kMaxTextureSide || image.height > kMaxTextureSide) {
      throw DataError(name, "", "is larger than " + std::to_string(kMaxTextureSide) + " texels a side");
    }
    model_.images.push_back(std::move(image));
    return images_[reference] = static_cast<int>(model_.images.size()) - 1;
  }

  void readMesh(const aiMesh& from, unsigned materials) {
    ModelMesh mesh;
    mesh.name = from.mName.C_Str();
    if (from.mPrimitiveTypes & (aiPrimitiveType_POINT | aiPrimitiveType_LINE | aiPrimitiveType_POLYGON))
      fail(placeOf(from), "holds points or lines");
    if (!from.HasNormals()) fail(placeOf(from), "has no normals, and none could be made");
    if (materials > 0 && from.mMaterialIndex >= materials)
      fail(placeOf(from), "its material is out of range");
    mesh.material = materials > 0 ? static_cast<int>(from.mMaterialIndex) : 0;
    for (unsigned v = 0; v < from.mNumVertices; ++v) mesh.data.vertices.push_back(readVertex(from, v));
    for (unsigned f = 0; f < from.mNumFaces; ++f) {
      const aiFace& face = from.mFaces[f];
      mesh.data.indices.insert(mesh.data.indices.end(), face.mIndices, face.mIndices + face.mNumIndices);
    }
    model_.meshes.push_back(std::move(mesh));
  }

  MeshVertex readVertex(const aiMesh& from, unsigned v) const {
    checkPosition(from, v);
    const aiVector3D &p = from.mVertices[v], &n = from.mNormals[v];
    MeshVertex vertex{{p.x, p.y, p.z}, {n.x, n.y, n.z}, {}};
    const float length = n.Length();
    // Files round: up to 5 % off is made right, anything else is not a normal.
    if (!(length > 0.95f && length < 1.05f)) {
      fail(placeOf(from) + ", vertex " + std::to_string(v), "a normal is not of length 1");
    }
    vertex.normal /= length;
    if (from.HasTextureCoords(0)) vertex.uv = {from.mTextureCoords[0][v].x, from.mTextureCoords[0][v].y};
    if (!std::isfinite(vertex.uv.x) || !std::isfinite(vertex.uv.y)) {
      fail(placeOf(from) + ", vertex " + std::to_string(v), "a texture coordinate is not finite");
    }
    return vertex;
  }

  void readNode(const aiNode& from, int parent, int depth) {
    ModelNode node;
    node.name = from.mName.C_Str();
    node.parent = parent;
    node.toParent = fromAssimp(from.mTransformation);
    const std::string place = "node '" + node.name + "'";
    if (depth > kMaxModelDepth || model_.nodes.size() == kMaxModelNodes)
      fail(place, "too many nodes, or too deep");
    for (int i = 0; i < 16; ++i) {
      if (!(std::abs(node.toParent[i / 4][i % 4]) <= kMaxModelCoordinate))
        fail(place, "its transform is not finite");
    }
    for (unsigned i = 0; i < from.mNumMeshes; ++i) node.meshes.push_back(static_cast<int>(from.mMeshes[i]));
    const int index = static_cast<int>(model_.nodes.size());
    model_.nodes.push_back(std::move(node));
    for (unsigned i = 0; i < from.mNumChildren; ++i) readNode(*from.mChildren[i], index, depth + 1);
  }

  std::filesystem::path path_;
  std::string file_;
  ModelData model_;
  std::map<std::string, int> images_;
};

}  // namespace

ModelData importModel(const std::filesystem::path& path) {
  try {
    return ModelReader(path).read();
  } catch (const DataError&) {
    throw;
  } catch (const std::exception& error) {  // bad_alloc, or one of assimp's own
    throw DataError(path.string(), "", error.what());
  }
}

}  // namespace skydrop::render
