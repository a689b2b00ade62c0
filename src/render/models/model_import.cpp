#include "skydrop/render/models/model_import.h"

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
#include <glm/matrix.hpp>
#include <map>
#include <memory>
#include <new>
#include <span>

#include "render/models/plain_model.h"
#include "render/models/smooth_normals.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"

namespace skydrop::render {
namespace {

using core::DataError;

// A file in memory.
class MemoryStream final : public Assimp::IOStream {
 public:
  explicit MemoryStream(std::span<const std::byte> bytes) : bytes_(bytes) {}

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
  std::span<const std::byte> bytes_;
  size_t at_ = 0;
};

// Gives assimp what was written for it; nothing else exists.
class PlainFiles final : public Assimp::IOSystem {
 public:
  PlainFiles(const PlainModel& plain, const char* name) : plain_(&plain), name_(name) {}

  bool Exists(const char* file) const override {
    return file == name_ || file == std::string_view(kPlainMaterials);
  }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* file, const char*) override {
    if (!Exists(file)) return nullptr;
    if (file == name_) return new MemoryStream(plain_->bytes);
    return new MemoryStream(std::as_bytes(std::span(plain_->materialFile)));
  }
  void Close(Assimp::IOStream* stream) override { delete stream; }

 private:
  const PlainModel* plain_;
  std::string_view name_;
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
    isObj_ = format == ModelFormat::obj;
    plain_ = isObj_ ? readPlainObj(path_) : readPlainGltf(path_, format);
    Assimp::Importer importer;
    if (!keepOnly(importer, isObj_ ? "Wavefront Object Importer" : "glTF2 Importer")) {
      fail("", "this assimp was built without the importer for it");
    }
    const char* name = isObj_ ? kPlainObj : kPlainGltf;
    importer.SetIOHandler(new PlainFiles(plain_, name));
    // First without any change, so that a wrong index is found before a step follows it.
    const aiScene* scene = importer.ReadFile(name, 0);
    if (!scene || !scene->mRootNode) fail("", importer.GetErrorString());
    checkRaw(*scene);
    // Of assimp's steps only this one, whose faces have at most 64 corners: those that look for vertices near
    // each other take quadratic time where many lie in a plane.
    if (isObj_) scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
    if (!scene) fail("", importer.GetErrorString());
    readMaterials(*scene);
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) readMesh(*scene->mMeshes[i], scene->mNumMaterials);
    readNode(*scene->mRootNode, -1, 0);
    if (isObj_) model_.nodes.front().name = path_.filename().string();
    turnMirroredMeshes();
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
      material.name = nameOf(from.GetName().C_Str());
      material.diffuse = readTextures(from, aiTextureType_DIFFUSE);
      material.specular = readTextures(from, aiTextureType_SPECULAR);
      model_.materials.push_back(std::move(material));
    }
    if (model_.materials.empty()) model_.materials.emplace_back();
  }

  std::string nameOf(const std::string& material) const {
    if (!isObj_ || !material.starts_with('m')) return material;
    return plain_.materialNames.at(std::stoul(material.substr(1)));
  }

  std::vector<int> readTextures(const aiMaterial& from, aiTextureType type) {
    std::vector<int> images;
    for (unsigned i = 0; i < from.GetTextureCount(type); ++i) {
      aiString reference;
      if (from.GetTexture(type, i, &reference) != aiReturn_SUCCESS) continue;
      images.push_back(readTexture(std::stoul(reference.C_Str())));
    }
    return images;
  }

  int readTexture(std::size_t index) {
    if (const auto known = images_.find(index); known != images_.end()) return known->second;
    const TextureSource& source = plain_.textures.at(index);
    if (model_.images.size() == kMaxModelImages) fail(source.place, "too many textures");
    std::vector<std::byte> file;
    std::span<const std::byte> bytes = source.bytes;
    if (!source.file.empty()) bytes = file = core::readFile(source.file, kMaxModelFileBytes);
    const std::string name = source.file.empty() ? file_ + ": " + source.place : source.file.string();
    checkSize(bytes, name);
    model_.images.push_back(core::decodePng(bytes, name));
    return images_[index] = static_cast<int>(model_.images.size()) - 1;
  }

  // Before a texel is decoded: a PNG of a few bytes can be very large.
  void checkSize(std::span<const std::byte> png, const std::string& name) {
    constexpr std::size_t kHeaderBytes = 24;  // signature, length and type of IHDR, width, height
    if (png.size() < kHeaderBytes) return;    // which decoding refuses
    const auto side = [&png](std::size_t at) {
      std::uint64_t value = 0;
      for (std::size_t i = 0; i < 4; ++i) value = value << 8 | std::to_integer<std::uint64_t>(png[at + i]);
      return value;
    };
    const std::uint64_t width = side(16), height = side(20);
    if (width > kMaxTextureSide || height > kMaxTextureSide) {
      throw DataError(name, "", "is larger than " + std::to_string(kMaxTextureSide) + " texels a side");
    }
    if ((texels_ += width * height) > kMaxModelTexels) fail(name, "the textures are too large together");
  }

  void readMesh(const aiMesh& from, unsigned materials) {
    ModelMesh mesh;
    mesh.name = from.mName.C_Str();
    if (materials > 0 && from.mMaterialIndex >= materials)
      fail(placeOf(from), "its material is out of range");
    mesh.material = materials > 0 ? static_cast<int>(from.mMaterialIndex) : 0;
    for (unsigned v = 0; v < from.mNumVertices; ++v) mesh.data.vertices.push_back(readVertex(from, v));
    for (unsigned f = 0; f < from.mNumFaces; ++f) {
      const aiFace& face = from.mFaces[f];
      if (face.mNumIndices != 3) fail(placeOf(from), "a face cannot be cut into triangles");
      mesh.data.indices.insert(mesh.data.indices.end(), face.mIndices, face.mIndices + face.mNumIndices);
    }
    addSmoothNormals(mesh.data);
    model_.meshes.push_back(std::move(mesh));
  }

  // Without a normal in the file: (0, 0, 0). A face of an OBJ may have none where others have.
  MeshVertex readVertex(const aiMesh& from, unsigned v) const {
    checkPosition(from, v);
    const aiVector3D& p = from.mVertices[v];
    MeshVertex vertex{{p.x, p.y, p.z}, glm::vec3(0), {}};
    if (from.HasNormals()) {
      const aiVector3D& n = from.mNormals[v];
      const float length = n.Length();
      const bool isUnit = length > 1 - kNormalTolerance && length < 1 + kNormalTolerance;
      if (!isUnit && !(isObj_ && length == 0)) {
        fail(placeOf(from) + ", vertex " + std::to_string(v), "a normal is not of length 1");
      }
      if (isUnit) vertex.normal = glm::vec3(n.x, n.y, n.z) / length;
    }
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

  // A node that mirrors turns its triangles inside out, and back faces are not drawn: it gets a copy of its
  // meshes that winds the other way.
  void turnMirroredMeshes() {
    std::vector<glm::mat4> toModel;
    std::map<int, int> turned;
    for (ModelNode& node : model_.nodes) {
      const glm::mat4 parent =
          node.parent < 0 ? glm::mat4(1) : toModel[static_cast<std::size_t>(node.parent)];
      toModel.push_back(parent * node.toParent);
      if (glm::determinant(glm::mat3(toModel.back())) >= 0) continue;
      for (int& mesh : node.meshes) {
        const auto [known, isNew] = turned.emplace(mesh, static_cast<int>(model_.meshes.size()));
        if (isNew) {
          ModelMesh copy = model_.meshes[static_cast<std::size_t>(mesh)];
          std::vector<std::uint32_t>& indices = copy.data.indices;
          for (std::size_t i = 0; i < indices.size(); i += 3) std::swap(indices[i + 1], indices[i + 2]);
          model_.meshes.push_back(std::move(copy));
        }
        mesh = known->second;
      }
    }
  }

  std::filesystem::path path_;
  std::string file_;
  bool isObj_ = false;
  PlainModel plain_;
  ModelData model_;
  std::map<std::size_t, int> images_;  // by index of the texture
  std::uint64_t texels_ = 0;
};

}  // namespace

ModelData importModel(const std::filesystem::path& path) {
  try {
    return ModelReader(path).read();
  } catch (const DataError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw DataError(path.string(), "", "takes too much memory");
  } catch (const std::exception& error) {  // one of assimp's own
    throw DataError(path.string(), "", error.what());
  }
}

}  // namespace skydrop::render
