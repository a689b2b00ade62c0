#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "render/models/data_uri.h"
#include "render/models/plain_model.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/json.h"
#include "skydrop/render/models/model_import.h"

namespace skydrop::render {
namespace {

using core::DataError;
using nlohmann::json;

constexpr int kDeepestJson = 32;
constexpr std::size_t kMostValues = 500'000;  // of the JSON
constexpr std::uint64_t kMostObjects = 4096;  // of any list in the file
constexpr std::size_t kLongestName = 256;

// Least length of a node's axis, and least volume that its axes span relative to their lengths: what is
// flatter has no normals.
constexpr double kLeastScale = 1e-6;

constexpr std::uint64_t kByte = 5121, kShort = 5123, kWord = 5125, kFloat = 5126;

const char* const kGlossiness = "KHR_materials_pbrSpecularGlossiness";

std::string at(const std::string& name, std::size_t i) { return name + "[" + std::to_string(i) + "]"; }

// Writes the geometry as one buffer, and the lists of a glTF file that lead to it.
class GltfWriter {
 public:
  json root = {{"asset", {{"version", "2.0"}}}, {"scene", 0},
               {"accessors", json::array()},    {"bufferViews", json::array()},
               {"meshes", json::array()},       {"nodes", json::array()}};

  // Index of an accessor for `count` elements of these numbers.
  std::size_t add(const void* numbers, std::size_t bytes, std::size_t count, const char* type,
                  std::uint64_t component) {
    const std::size_t index = root["accessors"].size();
    root["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes}});
    root["accessors"].push_back(
        {{"bufferView", index}, {"componentType", component}, {"count", count}, {"type", type}});
    buffer_.append(static_cast<const char*>(numbers), bytes);
    return index;
  }

  std::vector<std::byte> bytes() {
    root["buffers"] = json::array({{{"byteLength", buffer_.size()}}});
    std::string text = root.dump();
    text.append((4 - text.size() % 4) % 4, ' ');
    std::string file = "glTF";
    const auto addWord = [&file](std::size_t word) {
      for (int i = 0; i < 4; ++i) file += static_cast<char>(word >> (8 * i));
    };
    addWord(2);
    addWord(12 + 8 + text.size() + 8 + buffer_.size());
    addWord(text.size());
    file += "JSON" + text;
    addWord(buffer_.size());
    file += std::string("BIN\0", 4) + buffer_;
    const auto* data = reinterpret_cast<const std::byte*>(file.data());
    return {data, data + file.size()};
  }

 private:
  std::string buffer_;  // of 4-byte numbers
};

class GltfReader {
 public:
  explicit GltfReader(const std::filesystem::path& path) : file_(path.string()), folder_(path) {}

  PlainModel read(std::vector<std::byte> bytes, ModelFormat format) {
    plain_.storage.push_back(std::move(bytes));
    const std::span<const std::byte> content = plain_.storage.front();
    std::string_view text(reinterpret_cast<const char*>(content.data()), content.size());
    if (format == ModelFormat::glb) splitContainer(content, text);
    const json root = core::parseJson(
        text, file_, {.bytes = kMaxModelFileBytes, .depth = kDeepestJson, .values = kMostValues});
    if (!root.is_object()) fail("", "is not a glTF object");
    checkHeader(root);
    readBuffers(root);
    readAccessors(root);
    readMaterials(root);
    readMeshes(root);
    readNodes(root);
    plain_.bytes = writer_.bytes();
    return std::move(plain_);
  }

 private:
  struct View {
    std::span<const std::byte> bytes;
    std::uint64_t stride;
  };
  struct Accessor {
    std::span<const std::byte> bytes;  // from the first element to the end of the last
    std::uint64_t count, stride, component;
    std::string type;
    bool isNormalized;
  };
  struct MeshSize {
    std::uint64_t vertices = 0, indices = 0;
  };
  struct NodeRow {
    std::string place;
    glm::dmat4 toParent{1};
    std::vector<std::size_t> children;
    std::optional<std::uint64_t> mesh;
    int parent = -1;
  };

  [[noreturn]] void fail(std::string_view place, std::string_view reason) const {
    throw DataError(file_, place, reason);
  }

  static std::uint32_t word(std::span<const std::byte> bytes, std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, 4);  // little-endian, as every platform of the game
    return value;
  }

  void splitContainer(std::span<const std::byte> bytes, std::string_view& text) {
    constexpr std::uint32_t kMagic = 0x46546c67, kJson = 0x4e4f534a, kBinary = 0x004e4942;
    if (bytes.size() < 20 || word(bytes, 0) != kMagic) fail("header", "is not binary glTF");
    if (word(bytes, 4) != 2) fail("header", "is not version 2");
    if (word(bytes, 8) != bytes.size()) {
      fail("header",
           "says " + std::to_string(word(bytes, 8)) + " bytes, the file has " + std::to_string(bytes.size()));
    }
    const std::size_t jsonBytes = word(bytes, 12);
    if (word(bytes, 16) != kJson) fail("JSON chunk", "is not the first");
    if (jsonBytes > bytes.size() - 20) fail("JSON chunk", "is longer than the file");
    text = std::string_view(reinterpret_cast<const char*>(bytes.data()) + 20, jsonBytes);
    const std::size_t at = 20 + jsonBytes;
    if (at == bytes.size()) return;
    if (jsonBytes % 4 != 0) fail("JSON chunk", "its length is not a multiple of 4");
    if (bytes.size() - at < 8) fail("BIN chunk", "the file ends in its header");
    if (word(bytes, at + 4) != kBinary) fail("BIN chunk", "another chunk is in its place");
    if (word(bytes, at) > bytes.size() - at - 8) fail("BIN chunk", "is longer than the file");
    if (word(bytes, at) < bytes.size() - at - 8) fail("BIN chunk", "more follows it");
    binary_ = bytes.subspan(at + 8);
  }

  static const json* member(const json& object, const char* name) {
    if (!object.is_object()) return nullptr;
    const auto found = object.find(name);
    return found == object.end() ? nullptr : &*found;
  }

  const json& list(const json& object, const char* name, const std::string& place) const {
    static const json empty = json::array();
    const json* found = member(object, name);
    if (!found) return empty;
    if (!found->is_array() || found->size() > kMostObjects) fail(place + name, "is not a list, or too long");
    return *found;
  }

  // A list of objects.
  const json& objects(const json& root, const char* name) const {
    const json& all = list(root, name, "");
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!all[i].is_object()) fail(at(name, i), "is not an object");
    }
    return all;
  }

  // A whole number; `fallback` where it is not given.
  std::uint64_t whole(const json& object, const char* name, const std::string& place,
                      std::optional<std::uint64_t> fallback = std::nullopt) const {
    const json* value = member(object, name);
    if (!value && fallback) return *fallback;
    if (!value || !value->is_number_unsigned()) fail(place + "." + name, "is not a whole number");
    return value->get<std::uint64_t>();
  }

  // An index into a list of `size`; nullopt where it is not given.
  std::optional<std::uint64_t> index(const json& object, const char* name, const std::string& place,
                                     std::uint64_t size) const {
    if (!object.is_object()) fail(place, "is not an object");
    if (!member(object, name)) return std::nullopt;
    const std::uint64_t value = whole(object, name, place);
    if (value >= size) fail(place + "." + name, std::to_string(value) + " is out of range");
    return value;
  }

  // Empty where it is not given.
  std::string text(const json& object, const char* name, const std::string& place,
                   std::size_t longest) const {
    const json* value = member(object, name);
    if (!value) return {};
    if (!value->is_string()) fail(place + "." + name, "is not a text");
    const std::string& text = value->get_ref<const std::string&>();
    if (text.size() > longest)
      fail(place + "." + name, "is longer than " + std::to_string(longest) + " bytes");
    if (text.find('\0') != std::string::npos) fail(place + "." + name, "holds a zero byte");
    return text;
  }

  void checkHeader(const json& root) const {
    const json* asset = member(root, "asset");
    const json* version = asset ? member(*asset, "version") : nullptr;
    if (!version || !version->is_string() || !version->get_ref<const std::string&>().starts_with("2.")) {
      fail("asset.version", "is not 2.x");
    }
    for (const json& required : list(root, "extensionsRequired", "")) {
      fail(
          "extensionsRequired",
          (required.is_string() ? "'" + required.get<std::string>() + "'" : "an extension") + " is not read");
    }
    list(root, "extensionsUsed", "");
    for (const char* unread : {"skins", "animations", "cameras"}) {
      if (!list(root, unread, "").empty()) fail(unread, "are not read");
    }
  }

  void readBuffers(const json& root) {
    std::vector<std::span<const std::byte>> buffers;
    const json& all = objects(root, "buffers");
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::string place = at("buffers", i);
      const std::uint64_t bytes = whole(all[i], "byteLength", place);
      std::span<const std::byte> content;
      if (member(all[i], "uri")) {
        const std::string uri = text(all[i], "uri", place, kMaxModelFileBytes);
        plain_.storage.push_back(isDataUri(uri)
                                     ? decodeDataUri(uri, file_, place + ".uri")
                                     : folder_.read(place + ".uri", decodePercent(uri, file_, place)));
        content = plain_.storage.back();
      } else if (i == 0 && binary_) {
        content = *binary_;
      } else {
        fail(place, "its bytes are missing");
      }
      if (bytes > content.size()) {
        fail(place, "says " + std::to_string(bytes) + " bytes and has " + std::to_string(content.size()));
      }
      buffers.push_back(content.first(static_cast<std::size_t>(bytes)));
    }
    const json& views = objects(root, "bufferViews");
    for (std::size_t i = 0; i < views.size(); ++i) {
      const std::string place = at("bufferViews", i);
      const auto buffer = index(views[i], "buffer", place, buffers.size());
      if (!buffer) fail(place, "has no buffer");
      const std::span<const std::byte> content = buffers[*buffer];
      const std::uint64_t offset = whole(views[i], "byteOffset", place, 0);
      const std::uint64_t bytes = whole(views[i], "byteLength", place);
      if (offset > content.size() || bytes > content.size() - offset) fail(place, "leaves its buffer");
      const std::uint64_t stride = whole(views[i], "byteStride", place, 0);
      if (stride > 252 || (member(views[i], "byteStride") && stride < 4)) {
        fail(place + ".byteStride", "is out of range");
      }
      views_.push_back(
          {content.subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(bytes)), stride});
    }
  }

  void readAccessors(const json& root) {
    const json& accessors = objects(root, "accessors");
    for (std::size_t i = 0; i < accessors.size(); ++i) {
      const std::string place = at("accessors", i);
      if (member(accessors[i], "sparse")) fail(place, "sparse accessors are not read");
      const auto view = index(accessors[i], "bufferView", place, views_.size());
      if (!view) fail(place, "has no bufferView");
      const std::uint64_t count = whole(accessors[i], "count", place);
      const std::uint64_t offset = whole(accessors[i], "byteOffset", place, 0);
      const std::uint64_t element = elementBytes(accessors[i], place);
      const std::uint64_t stride = views_[*view].stride ? views_[*view].stride : element;
      const std::uint64_t there = views_[*view].bytes.size();
      if (count == 0 || count > kMaxModelIndices)
        fail(place + ".count", std::to_string(count) + " is out of range");
      const std::uint64_t extent = (count - 1) * stride + element;
      if (stride < element || offset > there || extent > there - offset) {
        fail(place, "leaves its bufferView");
      }
      const json* normalized = member(accessors[i], "normalized");
      if (normalized && !normalized->is_boolean()) fail(place + ".normalized", "is neither true nor false");
      accessors_.push_back(
          {views_[*view].bytes.subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(extent)),
           count, stride, whole(accessors[i], "componentType", place),
           member(accessors[i], "type")->get<std::string>(), normalized && normalized->get<bool>()});
    }
  }

  std::uint64_t elementBytes(const json& accessor, const std::string& place) const {
    static const std::array<std::pair<const char*, std::uint64_t>, 7> kinds = {
        {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}}};
    static const std::array<std::pair<std::uint64_t, std::uint64_t>, 6> components = {
        {{5120, 1}, {kByte, 1}, {5122, 2}, {kShort, 2}, {kWord, 4}, {kFloat, 4}}};
    const json* kind = member(accessor, "type");
    const std::uint64_t component = whole(accessor, "componentType", place);
    for (const auto& [name, numbers] : kinds) {
      if (!kind || !kind->is_string() || kind->get_ref<const std::string&>() != name) continue;
      for (const auto& [id, bytes] : components) {
        if (id == component) return numbers * bytes;
      }
    }
    fail(place, "has no known type");
  }

  // The numbers of an accessor, as they lie in the file; floats of normalised whole numbers.
  static std::vector<float> floats(const Accessor& accessor, std::size_t numbers) {
    std::vector<float> result;
    result.reserve(static_cast<std::size_t>(accessor.count) * numbers);
    for (std::size_t i = 0; i < accessor.count; ++i) {
      const std::byte* element = accessor.bytes.data() + i * accessor.stride;
      for (std::size_t k = 0; k < numbers; ++k) {
        float value = 0;
        if (accessor.component == kFloat) {
          std::memcpy(&value, element + 4 * k, 4);
        } else if (accessor.component == kShort) {
          std::uint16_t whole = 0;
          std::memcpy(&whole, element + 2 * k, 2);
          value = static_cast<float>(whole) / 65535.0f;
        } else {
          value = static_cast<float>(std::to_integer<std::uint8_t>(element[k])) / 255.0f;
        }
        result.push_back(value);
      }
    }
    return result;
  }

  static std::vector<std::uint32_t> wholes(const Accessor& accessor) {
    std::vector<std::uint32_t> result;
    result.reserve(static_cast<std::size_t>(accessor.count));
    const std::size_t size = accessor.component == kByte ? 1 : accessor.component == kShort ? 2 : 4;
    for (std::size_t i = 0; i < accessor.count; ++i) {
      std::uint32_t value = 0;
      std::memcpy(&value, accessor.bytes.data() + i * accessor.stride, size);
      result.push_back(value);
    }
    return result;
  }

  void readMeshes(const json& root) {
    const json& meshes = objects(root, "meshes");
    if (meshes.empty()) fail("meshes", "holds no mesh");
    std::size_t primitiveCount = 0;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      const json& primitives = list(meshes[i], "primitives", at("meshes", i) + ".");
      if (primitives.empty()) fail(at("meshes", i), "holds no primitive");
      if ((primitiveCount += primitives.size()) > kMaxModelMeshes)
        fail(at("meshes", i), "the model is too large");
      json written = {{"name", text(meshes[i], "name", at("meshes", i), kLongestName)},
                      {"primitives", json::array()}};
      sizes_.emplace_back();
      for (std::size_t k = 0; k < primitives.size(); ++k) {
        written["primitives"].push_back(readPrimitive(primitives[k], at(at("meshes", i) + ".primitives", k)));
      }
      writer_.root["meshes"].push_back(std::move(written));
    }
  }

  json readPrimitive(const json& primitive, const std::string& place) {
    if (!primitive.is_object()) fail(place, "is not an object");
    if (whole(primitive, "mode", place, 4) != 4) fail(place + ".mode", "only triangles are read");
    if (member(primitive, "targets")) fail(place + ".targets", "morph targets are not read");
    const json* attributes = member(primitive, "attributes");
    if (!attributes || !attributes->is_object() || !attributes->contains("POSITION"))
      fail(place, "has no POSITION");
    const Accessor& positions = accessors_[*index(*attributes, "POSITION", place, accessors_.size())];
    const auto indices = index(primitive, "indices", place, accessors_.size());
    const std::uint64_t corners = indices ? accessors_[*indices].count : positions.count;
    if (corners % 3 != 0) fail(place, std::to_string(corners) + " corners do not make triangles");
    addSize(sizes_.back(), {positions.count, corners}, place);
    addSize(allMeshes_, {positions.count, corners}, place);
    json written = {{"mode", 4}, {"attributes", readAttributes(*attributes, positions, place)}};
    if (indices) written["indices"] = readIndices(accessors_[*indices], positions.count, place + ".indices");
    if (const auto material = index(primitive, "material", place, materialCount_))
      written["material"] = *material;
    return written;
  }

  // Tangents, colours and further texture coordinates are not drawn, and left out.
  json readAttributes(const json& attributes, const Accessor& positions, const std::string& place) {
    json written = json::object();
    for (const auto& [name, value] : attributes.items()) {
      const Accessor& accessor = accessors_[*index(attributes, name.c_str(), place, accessors_.size())];
      const std::string here = place + "." + name;
      if (accessor.count != positions.count) fail(here, "has another count than POSITION");
      if (name.starts_with("JOINTS") || name.starts_with("WEIGHTS")) fail(here, "skins are not read");
      const bool isVector = name == "POSITION" || name == "NORMAL";
      if (isVector && (accessor.type != "VEC3" || accessor.component != kFloat))
        fail(here, "is not VEC3 of float");
      if (name == "TEXCOORD_0") {
        const bool isFraction =
            (accessor.component == kByte || accessor.component == kShort) && accessor.isNormalized;
        if (accessor.type != "VEC2" || !(accessor.component == kFloat || isFraction)) {
          fail(here, "is not VEC2 of float or of normalised bytes or shorts");
        }
      } else if (!isVector) {
        continue;
      }
      const std::vector<float> numbers = floats(accessor, isVector ? 3 : 2);
      written[name] =
          writer_.add(numbers.data(), numbers.size() * 4, static_cast<std::size_t>(accessor.count),
                      isVector ? "VEC3" : "VEC2", kFloat);
    }
    return written;
  }

  std::size_t readIndices(const Accessor& accessor, std::uint64_t vertices, const std::string& place) {
    const bool isUnsigned =
        accessor.component == kByte || accessor.component == kShort || accessor.component == kWord;
    if (accessor.type != "SCALAR" || !isUnsigned) fail(place, "are not unsigned numbers");
    const std::vector<std::uint32_t> indices = wholes(accessor);
    for (std::size_t i = 0; i < indices.size(); ++i) {
      if (indices[i] >= vertices) {
        fail(at(place, i), std::to_string(indices[i]) + " is out of range: there are " +
                               std::to_string(vertices) + " vertices");
      }
    }
    return writer_.add(indices.data(), indices.size() * 4, indices.size(), "SCALAR", kWord);
  }

  void addSize(MeshSize& sum, const MeshSize& mesh, const std::string& place) const {
    sum.vertices += mesh.vertices;
    sum.indices += mesh.indices;
    if (sum.vertices > kMaxModelVertices || sum.indices > kMaxModelIndices)
      fail(place, "the model is too large");
  }

  void readMaterials(const json& root) {
    const json& images = objects(root, "images");
    const json& textures = objects(root, "textures");
    for (std::size_t i = 0; i < images.size(); ++i) {
      const std::string place = at("images", i);
      index(images[i], "bufferView", place, views_.size());
      text(images[i], "uri", place, kMaxModelFileBytes);
      if (member(images[i], "uri") && member(images[i], "bufferView")) fail(place, "has two contents");
      if (!member(images[i], "uri") && !member(images[i], "bufferView")) fail(place, "has no content");
    }
    const std::size_t samplers = objects(root, "samplers").size();
    for (std::size_t i = 0; i < textures.size(); ++i) {
      index(textures[i], "source", at("textures", i), images.size());
      index(textures[i], "sampler", at("textures", i), samplers);
    }
    const json& materials = objects(root, "materials");
    materialCount_ = materials.size();
    for (std::size_t i = 0; i < materials.size(); ++i) {
      const std::string place = at("materials", i);
      checkTextureUses(materials[i], place, textures.size());
      writer_.root["materials"].push_back(readMaterial(materials[i], place, textures, images));
    }
    if (!plain_.textures.empty()) writeTextures();
  }

  // Every "...Texture" within a material, its extensions included, must name a texture.
  void checkTextureUses(const json& value, const std::string& place, std::size_t textures) const {
    if (!value.is_object()) return;
    for (const auto& [name, inner] : value.items()) {
      const std::string here = place + "." + name;
      if (name.ends_with("Texture") && !index(inner, "index", here, textures)) fail(here, "names no texture");
      checkTextureUses(inner, here, textures);
    }
  }

  // Only textures are drawn: no factors, no transparency, no other maps.
  json readMaterial(const json& material, const std::string& place, const json& textures,
                    const json& images) {
    json written = {{"name", text(material, "name", place, kLongestName)}};
    const auto read = [&](const json* group, const char* name, const std::string& here, json& target) {
      const json* use = group ? member(*group, name) : nullptr;
      if (use) target[name] = {{"index", readTexture(*use, here + "." + name, textures, images)}};
    };
    if (const json* plain = member(material, "pbrMetallicRoughness")) {
      json& target = written["pbrMetallicRoughness"] = json::object();
      read(plain, "baseColorTexture", place + ".pbrMetallicRoughness", target);
    }
    const json* extensions = member(material, "extensions");
    if (const json* glossy = extensions ? member(*extensions, kGlossiness) : nullptr) {
      json& target = written["extensions"][kGlossiness] = json::object();
      for (const char* name : {"diffuseTexture", "specularGlossinessTexture"}) {
        read(glossy, name, place + ".extensions." + kGlossiness, target);
      }
      writer_.root["extensionsUsed"] = json::array({kGlossiness});
    }
    return written;
  }

  int readTexture(const json& use, const std::string& place, const json& textures, const json& images) {
    if (whole(use, "texCoord", place, 0) != 0) fail(place + ".texCoord", "only TEXCOORD_0 is read");
    if (member(use, "extensions") && member(use["extensions"], "KHR_texture_transform")) {
      fail(place, "transformed textures are not read");
    }
    const std::uint64_t texture = *index(use, "index", place, textures.size());
    const auto source = index(textures[texture], "source", at("textures", texture), images.size());
    if (!source) fail(at("textures", texture), "has no image of a kind that is read");
    const auto [known, isNew] = imageTextures_.emplace(*source, 0);
    if (isNew) known->second = readImage(images[*source], at("images", *source));
    return known->second;
  }

  int readImage(const json& image, const std::string& place) {
    if (const auto view = index(image, "bufferView", place, views_.size())) {
      plain_.textures.push_back({place, {}, views_[*view].bytes});
    } else {
      const std::string uri = text(image, "uri", place, kMaxModelFileBytes);
      if (!isDataUri(uri)) return folder_.texture(plain_, place, decodePercent(uri, file_, place));
      plain_.storage.push_back(decodeDataUri(uri, file_, place + ".uri"));
      plain_.textures.push_back({place, {}, plain_.storage.back()});
    }
    return static_cast<int>(plain_.textures.size()) - 1;
  }

  void writeTextures() {
    for (std::size_t i = 0; i < plain_.textures.size(); ++i) {
      writer_.root["images"].push_back({{"uri", std::to_string(i)}});
      writer_.root["textures"].push_back({{"source", i}});
    }
  }

  void readNodes(const json& root) {
    const json& nodes = objects(root, "nodes");
    if (nodes.empty() || nodes.size() > kMaxModelNodes) fail("nodes", "there are none, or too many");
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes_.push_back(readNode(nodes[i], i, nodes.size()));
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      for (const std::size_t child : nodes_[i].children) {
        if (nodes_[child].parent >= 0) fail(nodes_[child].place, "has two parents");
        nodes_[child].parent = static_cast<int>(i);
      }
    }
    for (const NodeRow& row : nodes_) {
      int depth = 1;
      for (int node = row.parent; node >= 0; node = nodes_[static_cast<std::size_t>(node)].parent) {
        if (++depth > kMaxModelDepth) fail(row.place, "lies too deep, or is its own ancestor");
      }
    }
    readScenes(root);
  }

  NodeRow readNode(const json& node, std::size_t i, std::size_t count) {
    const std::string name = text(node, "name", at("nodes", i), kLongestName);
    NodeRow row;
    row.place = at("nodes", i) + (name.empty() ? "" : " '" + name + "'");
    for (const char* unread : {"skin", "camera", "weights"}) {
      if (member(node, unread)) fail(row.place + "." + unread, "is not read");
    }
    // Those of nodes hang lights on them, or repeat them.
    if (const json* extensions = member(node, "extensions"); extensions && !extensions->empty()) {
      fail(row.place + ".extensions",
           "'" + (extensions->is_object() ? extensions->begin().key() : "") + "' is not read");
    }
    row.mesh = index(node, "mesh", row.place, sizes_.size());
    row.toParent = readTransform(node, row.place);
    for (const json& child : list(node, "children", row.place + ".")) {
      if (!child.is_number_unsigned() || child.get<std::uint64_t>() >= count) {
        fail(row.place + ".children", "a node that does not exist");
      }
      row.children.push_back(child.get<std::size_t>());
    }
    json written = {{"name", name.empty() ? at("nodes", i) : name}};
    if (row.mesh) written["mesh"] = *row.mesh;
    if (!row.children.empty()) written["children"] = row.children;
    if (row.toParent != glm::dmat4(1)) {
      const glm::mat4 matrix(row.toParent);
      written["matrix"] = std::vector<float>(glm::value_ptr(matrix), glm::value_ptr(matrix) + 16);
    }
    writer_.root["nodes"].push_back(std::move(written));
    return row;
  }

  // Empty where it is not given.
  std::vector<double> numbers(const json& node, const char* name, std::size_t count,
                              const std::string& place) const {
    const json* given = member(node, name);
    if (!given) return {};
    bool good = given->is_array() && given->size() == count;
    for (std::size_t k = 0; good && k < count; ++k) good = (*given)[k].is_number();
    if (!good) fail(place + "." + name, "is not a list of " + std::to_string(count) + " numbers");
    const std::vector<double> values = given->get<std::vector<double>>();
    for (const double value : values) {
      if (!(std::abs(value) <= kMaxModelCoordinate)) fail(place + "." + name, "a number is beyond 1e6");
    }
    return values;
  }

  glm::dmat4 readTransform(const json& node, const std::string& place) const {
    const std::vector<double> matrix = numbers(node, "matrix", 16, place),
                              moved = numbers(node, "translation", 3, place),
                              turned = numbers(node, "rotation", 4, place),
                              scaled = numbers(node, "scale", 3, place);
    glm::dmat4 result(1);
    if (!matrix.empty()) {
      if (!moved.empty() || !turned.empty() || !scaled.empty()) {
        fail(place + ".matrix", "stands beside translation, rotation or scale");
      }
      result = glm::make_mat4(matrix.data());
      const glm::dvec4 last(result[0][3], result[1][3], result[2][3], result[3][3]);
      if (glm::length(last - glm::dvec4(0, 0, 0, 1)) > 1e-6) fail(place + ".matrix", "is not affine");
      result[0][3] = result[1][3] = result[2][3] = 0, result[3][3] = 1;
    }
    if (!turned.empty()) {
      const glm::dquat rotation(turned[3], turned[0], turned[1], turned[2]);
      if (std::abs(glm::length(rotation) - 1) > 1e-2) fail(place + ".rotation", "is not of length 1");
      result = glm::mat4_cast(glm::normalize(rotation));
    }
    for (int k = 0; k < 3 && !scaled.empty(); ++k) result[k] *= scaled[static_cast<std::size_t>(k)];
    if (!moved.empty()) result[3] = glm::dvec4(moved[0], moved[1], moved[2], 1);
    checkTransform(result, place, "its transform");
    return result;
  }

  void checkTransform(const glm::dmat4& m, const std::string& place, const std::string& what) const {
    const double x = glm::length(m[0]), y = glm::length(m[1]), z = glm::length(m[2]);
    const double volume = std::abs(glm::determinant(glm::dmat3(m)));
    if (!(glm::length(glm::dvec3(m[3])) <= 2 * kMaxModelCoordinate &&
          std::max({x, y, z}) <= 2 * kMaxModelCoordinate)) {
      fail(place, what + " is beyond 1e6");
    }
    if (!(std::min({x, y, z}) >= kLeastScale && volume >= kLeastScale * x * y * z)) {
      fail(place, what + " flattens what it moves");
    }
  }

  // Only the scene that is shown is written. A node has one parent, so a walk meets each at most once.
  void readScenes(const json& root) {
    const json& scenes = objects(root, "scenes");
    if (scenes.empty()) fail("scenes", "holds no scene");
    const std::size_t shown =
        static_cast<std::size_t>(index(root, "scene", "scene", scenes.size()).value_or(0));
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      std::vector<bool> isListed(nodes_.size(), false);
      for (const json& node : list(scenes[i], "nodes", at("scenes", i) + ".")) {
        if (!node.is_number_unsigned() || node.get<std::uint64_t>() >= nodes_.size()) {
          fail(at("scenes", i), "a node that does not exist");
        }
        const std::size_t root_ = node.get<std::size_t>();
        if (isListed[root_]) fail(at("scenes", i), "lists a node twice");
        if (nodes_[root_].parent >= 0) fail(nodes_[root_].place, "has a parent and is listed in a scene");
        isListed[root_] = true;
        if (i == shown) walk(root_, glm::dmat4(1));
      }
      if (i == shown) {
        if (!list(scenes[i], "nodes", at("scenes", i) + ".").empty()) {
          writer_.root["scenes"] = json::array({{{"nodes", scenes[i]["nodes"]}}});
        } else {
          fail(at("scenes", i), "shows no node");
        }
      }
    }
  }

  void walk(std::size_t node, const glm::dmat4& parentToModel) {
    const NodeRow& row = nodes_[node];
    const glm::dmat4 toModel = parentToModel * row.toParent;
    checkTransform(toModel, row.place, "its transform with that of its parents");
    if (row.mesh) addSize(shown_, sizes_[*row.mesh], row.place);
    for (const std::size_t child : row.children) walk(child, toModel);
  }

  std::string file_;
  ModelFolder folder_;
  PlainModel plain_;
  GltfWriter writer_;
  std::optional<std::span<const std::byte>> binary_;
  std::vector<View> views_;
  std::vector<Accessor> accessors_;
  std::map<std::uint64_t, int> imageTextures_;  // by index of the image
  std::size_t materialCount_ = 0;
  std::vector<MeshSize> sizes_;  // of each mesh
  MeshSize allMeshes_, shown_;   // a mesh that several nodes show counts once, and as often as it is shown
  std::vector<NodeRow> nodes_;
};

}  // namespace

PlainModel readPlainGltf(const std::filesystem::path& path, ModelFormat format) {
  return GltfReader(path).read(core::readFile(path, kMaxModelFileBytes), format);
}

}  // namespace skydrop::render
