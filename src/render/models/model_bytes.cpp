#include "skydrop/render/models/model_bytes.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "skydrop/core/error.h"

namespace skydrop::render {
namespace {

static_assert(std::is_trivially_copyable_v<MeshVertex> && sizeof(MeshVertex) == 32);

class Writer {
 public:
  template <class T>
  void value(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class T>
  void list(const T& list) {
    using Item = typename T::value_type;
    static_assert(std::is_trivially_copyable_v<Item>);
    value(static_cast<std::uint64_t>(list.size()));
    if (!list.empty()) bytes_.append(reinterpret_cast<const char*>(list.data()), list.size() * sizeof(Item));
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class Reader {
 public:
  Reader(std::string_view bytes, std::string_view file) : bytes_(bytes), file_(file) {}

  void require(bool holds) const {
    if (!holds) throw core::DataError(file_, "", "what reads it handed over a model that is none");
  }
  template <class T>
  T value() {
    T value;
    require(bytes_.size() >= sizeof value);
    std::memcpy(static_cast<void*>(&value), bytes_.data(), sizeof value);
    bytes_.remove_prefix(sizeof value);
    return value;
  }
  // How many follow, each of which takes at least so many bytes.
  std::size_t count(std::size_t bytesEach, std::size_t most) {
    const auto count = value<std::uint64_t>();
    require(count <= most && count <= bytes_.size() / bytesEach);
    return static_cast<std::size_t>(count);
  }
  template <class T>
  T list(std::size_t most) {
    using Item = typename T::value_type;
    T list;
    list.resize(count(sizeof(Item), most));
    const std::size_t size = list.size() * sizeof(Item);
    if (size > 0) std::memcpy(static_cast<void*>(list.data()), bytes_.data(), size);
    bytes_.remove_prefix(size);
    return list;
  }
  std::string name() { return list<std::string>(std::size_t{1} << 20); }
  // Indices below `limit`.
  std::vector<int> indices(std::size_t most, std::size_t limit) {
    auto indices = list<std::vector<int>>(most);
    for (const int index : indices) requireIndex(index, limit);
    return indices;
  }
  void requireIndex(int index, std::size_t limit) const {
    require(index >= 0 && static_cast<std::size_t>(index) < limit);
  }
  void requireEnd() const { require(bytes_.empty()); }

 private:
  std::string_view bytes_, file_;
};

constexpr std::size_t kMostMaterials = std::size_t{1} << 16;
// Meshes of mirrored nodes are copies.
constexpr std::size_t kMostMeshes = 2 * kMaxModelMeshes, kMostVertices = 2 * kMaxModelVertices,
                      kMostIndices = 2 * kMaxModelIndices;

core::Image readImage(Reader& reader) {
  core::Image image;
  image.width = reader.value<int>();
  image.height = reader.value<int>();
  reader.require(image.width > 0 && image.width <= kMaxTextureSide && image.height > 0 &&
                 image.height <= kMaxTextureSide);
  image.rgba = reader.list<std::vector<std::uint8_t>>(4 * kMaxModelTexels);
  reader.require(image.rgba.size() == std::size_t{4} * static_cast<std::size_t>(image.width) *
                                          static_cast<std::size_t>(image.height));
  return image;
}

void requireSound(const Reader& reader, const MeshData& mesh) {
  for (const MeshVertex& vertex : mesh.vertices) {
    for (int axis = 0; axis < 3; ++axis) {
      reader.require(std::abs(vertex.position[axis]) <= kMaxModelCoordinate);
      reader.require(std::abs(vertex.normal[axis]) <= 1.01f);
    }
    reader.require(std::isfinite(vertex.uv.x) && std::isfinite(vertex.uv.y));
  }
  reader.require(mesh.indices.size() % 3 == 0);
  for (const std::uint32_t index : mesh.indices) reader.require(index < mesh.vertices.size());
}

}  // namespace

std::string bytesOf(const ModelData& model) {
  Writer writer;
  writer.value(static_cast<std::uint64_t>(model.images.size()));
  for (const core::Image& image : model.images) {
    writer.value(image.width);
    writer.value(image.height);
    writer.list(image.rgba);
  }
  writer.value(static_cast<std::uint64_t>(model.materials.size()));
  for (const ModelMaterial& material : model.materials) {
    writer.list(material.name);
    writer.list(material.diffuse);
    writer.list(material.specular);
  }
  writer.value(static_cast<std::uint64_t>(model.meshes.size()));
  for (const ModelMesh& mesh : model.meshes) {
    writer.list(mesh.name);
    writer.list(mesh.data.vertices);
    writer.list(mesh.data.indices);
    writer.value(mesh.material);
  }
  writer.value(static_cast<std::uint64_t>(model.nodes.size()));
  for (const ModelNode& node : model.nodes) {
    writer.list(node.name);
    writer.value(node.parent);
    writer.value(node.toParent);
    writer.list(node.meshes);
  }
  return writer.take();
}

ModelData modelOf(std::string_view bytes, std::string_view file) {
  constexpr std::size_t kLeast = 8;  // bytes of an image, a material, a mesh, a node
  Reader reader(bytes, file);
  ModelData model;
  for (std::size_t n = reader.count(kLeast, kMaxModelImages); n > 0; --n)
    model.images.push_back(readImage(reader));
  for (std::size_t n = reader.count(kLeast, kMostMaterials); n > 0; --n) {
    ModelMaterial& material = model.materials.emplace_back();
    material.name = reader.name();
    material.diffuse = reader.indices(kMostMaterials, model.images.size());
    material.specular = reader.indices(kMostMaterials, model.images.size());
  }
  reader.require(!model.materials.empty());
  for (std::size_t n = reader.count(kLeast, kMostMeshes); n > 0; --n) {
    ModelMesh& mesh = model.meshes.emplace_back();
    mesh.name = reader.name();
    mesh.data.vertices = reader.list<std::vector<MeshVertex>>(kMostVertices);
    mesh.data.indices = reader.list<std::vector<std::uint32_t>>(kMostIndices);
    mesh.material = reader.value<int>();
    reader.requireIndex(mesh.material, model.materials.size());
    requireSound(reader, mesh.data);
  }
  reader.require(!model.meshes.empty());
  for (std::size_t n = reader.count(kLeast, kMaxModelNodes); n > 0; --n) {
    ModelNode node;
    node.name = reader.name();
    node.parent = reader.value<int>();
    reader.require(node.parent >= -1 && node.parent < static_cast<int>(model.nodes.size()));
    node.toParent = reader.value<glm::mat4>();
    for (int i = 0; i < 16; ++i) reader.require(std::isfinite(node.toParent[i / 4][i % 4]));
    node.meshes = reader.indices(kMostMeshes, model.meshes.size());
    model.nodes.push_back(std::move(node));
  }
  reader.require(!model.nodes.empty());
  reader.requireEnd();
  return model;
}

}  // namespace skydrop::render
