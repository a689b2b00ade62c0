#include <array>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "render/model/file_check.h"
#include "skydrop/core/error.h"
#include "skydrop/render/model_import.h"

namespace skydrop::render {
namespace {

using core::DataError;
using nlohmann::json;

constexpr int kDeepestJson = 32;
constexpr std::uint64_t kMostObjects = 4096;  // of any list in the file

class GltfChecker {
 public:
  explicit GltfChecker(std::string_view file) : file_(file) {}

  void check(std::span<const std::byte> bytes, ModelFormat format) {
    std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    std::optional<std::uint64_t> binary;
    if (format == ModelFormat::glb) splitContainer(bytes, text, binary);
    const json root = parse(text);
    if (!root.is_object()) fail("", "is not a glTF object");
    const json* asset = member(root, "asset");
    const json* version = asset ? member(*asset, "version") : nullptr;
    if (!version || !version->is_string() || !version->get_ref<const std::string&>().starts_with("2.")) {
      fail("asset.version", "is not 2.x");
    }
    if (const json* required = member(root, "extensionsRequired"); required && !required->empty()) {
      fail("extensionsRequired", "no extension can be required");
    }
    checkBuffers(root, binary);
    checkAccessors(root);
    checkMeshes(root);
    checkMaterials(root);
    checkNodes(root);
  }

 private:
  [[noreturn]] void fail(std::string_view place, std::string_view reason) const {
    throw DataError(file_, place, reason);
  }

  static std::uint32_t word(std::span<const std::byte> bytes, std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, 4);  // little-endian, as every platform of the game
    return value;
  }

  void splitContainer(std::span<const std::byte> bytes, std::string_view& text,
                      std::optional<std::uint64_t>& binary) const {
    if (bytes.size() < 20 || word(bytes, 0) != 0x46546c67) fail("header", "is not binary glTF");
    if (word(bytes, 4) != 2) fail("header", "is not version 2");
    if (word(bytes, 8) != bytes.size()) {
      fail("header",
           "says " + std::to_string(word(bytes, 8)) + " bytes, the file has " + std::to_string(bytes.size()));
    }
    const std::size_t jsonBytes = word(bytes, 12);
    if (word(bytes, 16) != 0x4e4f534a || jsonBytes > bytes.size() - 20)
      fail("JSON chunk", "is missing or too long");
    text = std::string_view(reinterpret_cast<const char*>(bytes.data()) + 20, jsonBytes);
    std::size_t at = 20 + jsonBytes;
    if (at == bytes.size()) return;
    if (bytes.size() - at < 8 || word(bytes, at + 4) != 0x004e4942 ||
        word(bytes, at) != bytes.size() - at - 8) {
      fail("BIN chunk", "does not end where the file ends");
    }
    binary = word(bytes, at);
  }

  json parse(std::string_view text) const {
    const auto onEvent = [this](int depth, json::parse_event_t, json&) {
      if (depth > kDeepestJson) fail("JSON", "is nested too deeply");
      return true;
    };
    try {
      return json::parse(text, onEvent);
    } catch (const json::exception& error) {
      const std::string what = error.what();
      fail("JSON", what.substr(0, 160));
    }
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

  static std::string at(const char* name, std::size_t i) {
    return std::string(name) + "[" + std::to_string(i) + "]";
  }

  void checkBuffers(const json& root, std::optional<std::uint64_t> binary) {
    const json& buffers = list(root, "buffers", "");
    for (std::size_t i = 0; i < buffers.size(); ++i) {
      const std::uint64_t bytes = whole(buffers[i], "byteLength", at("buffers", i));
      if (bytes > kMaxModelFileBytes) fail(at("buffers", i), "is too large");
      if (const json* uri = member(buffers[i], "uri")) {
        if (!uri->is_string()) fail(at("buffers", i) + ".uri", "is not a text");
      } else if (i != 0 || !binary || bytes > *binary) {
        fail(at("buffers", i), "its bytes are missing");
      }
      bufferBytes_.push_back(bytes);
    }
    const json& views = list(root, "bufferViews", "");
    for (std::size_t i = 0; i < views.size(); ++i) {
      const std::string place = at("bufferViews", i);
      const auto buffer = index(views[i], "buffer", place, bufferBytes_.size());
      if (!buffer) fail(place, "has no buffer");
      const std::uint64_t offset = whole(views[i], "byteOffset", place, 0);
      const std::uint64_t bytes = whole(views[i], "byteLength", place);
      if (offset > bufferBytes_[*buffer] || bytes > bufferBytes_[*buffer] - offset)
        fail(place, "leaves its buffer");
      const std::uint64_t stride = whole(views[i], "byteStride", place, 0);
      if (stride > 252) fail(place + ".byteStride", "is out of range");
      views_.push_back({bytes, stride});
    }
  }

  void checkAccessors(const json& root) {
    const json& accessors = list(root, "accessors", "");
    for (std::size_t i = 0; i < accessors.size(); ++i) {
      const std::string place = at("accessors", i);
      if (member(accessors[i], "sparse")) fail(place, "sparse accessors are not read");
      const auto view = index(accessors[i], "bufferView", place, views_.size());
      if (!view) fail(place, "has no bufferView");
      const std::uint64_t count = whole(accessors[i], "count", place);
      const std::uint64_t offset = whole(accessors[i], "byteOffset", place, 0);
      const std::uint64_t element = elementBytes(accessors[i], place);
      const std::uint64_t stride = views_[*view].stride ? views_[*view].stride : element;
      if (count == 0 || count > kMaxModelIndices)
        fail(place + ".count", std::to_string(count) + " is out of range");
      if (stride < element || offset > views_[*view].bytes ||
          (count - 1) * stride + element > views_[*view].bytes - offset) {
        fail(place, "leaves its bufferView");
      }
      accessors_.push_back({count, member(accessors[i], "type")->get<std::string>(),
                            whole(accessors[i], "componentType", place)});
    }
  }

  std::uint64_t elementBytes(const json& accessor, const std::string& place) const {
    static const std::array<std::pair<const char*, std::uint64_t>, 7> kinds = {
        {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}}};
    static const std::array<std::pair<std::uint64_t, std::uint64_t>, 6> components = {
        {{5120, 1}, {5121, 1}, {5122, 2}, {5123, 2}, {5125, 4}, {5126, 4}}};
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

  void checkMeshes(const json& root) {
    const json& meshes = list(root, "meshes", "");
    if (meshes.empty()) fail("meshes", "holds no mesh");
    meshCount_ = meshes.size();
    const std::size_t materials = list(root, "materials", "").size();
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      const json& primitives = list(meshes[i], "primitives", at("meshes", i) + ".");
      if (primitives.empty()) fail(at("meshes", i), "holds no primitive");
      for (std::size_t k = 0; k < primitives.size(); ++k) {
        const std::string place = at("meshes", i) + "." + at("primitives", k);
        if (whole(primitives[k], "mode", place, 4) != 4) fail(place + ".mode", "only triangles are read");
        if (member(primitives[k], "targets")) fail(place + ".targets", "morph targets are not read");
        index(primitives[k], "material", place, materials);
        checkAttributes(primitives[k], place);
      }
    }
  }

  void checkAttributes(const json& primitive, const std::string& place) {
    const json* attributes = member(primitive, "attributes");
    if (!attributes || !attributes->is_object() || !attributes->contains("POSITION"))
      fail(place, "has no POSITION");
    const auto positions = index(*attributes, "POSITION", place, accessors_.size());
    for (const auto& [name, value] : attributes->items()) {
      const Accessor& accessor = accessors_[*index(*attributes, name.c_str(), place, accessors_.size())];
      if (accessor.count != accessors_[*positions].count)
        fail(place + "." + name, "has another count than POSITION");
      const bool isVector = name == "POSITION" || name == "NORMAL";
      if (isVector && (accessor.type != "VEC3" || accessor.component != 5126))
        fail(place + "." + name, "is not VEC3 of float");
      if (name == "TEXCOORD_0" && accessor.type != "VEC2") fail(place + "." + name, "is not VEC2");
      if (name.starts_with("JOINTS") || name.starts_with("WEIGHTS"))
        fail(place + "." + name, "skins are not read");
    }
    vertices_ += accessors_[*positions].count;
    indices_ += accessors_[*positions].count;
    if (const auto indices = index(primitive, "indices", place, accessors_.size())) {
      const Accessor& accessor = accessors_[*indices];
      if (accessor.type != "SCALAR" || accessor.component == 5126 || accessor.component == 5120 ||
          accessor.component == 5122 || accessor.count % 3 != 0) {
        fail(place + ".indices", "are not triangles of unsigned numbers");
      }
      indices_ += accessor.count;
    }
    if (vertices_ > kMaxModelVertices || indices_ > kMaxModelIndices) fail(place, "the model is too large");
  }

  void checkMaterials(const json& root) const {
    const json& images = list(root, "images", "");
    const json& textures = list(root, "textures", "");
    for (std::size_t i = 0; i < images.size(); ++i) {
      index(images[i], "bufferView", at("images", i), views_.size());
      const json* uri = member(images[i], "uri");
      if (uri && !uri->is_string()) fail(at("images", i) + ".uri", "is not a text");
      if (!uri && !member(images[i], "bufferView")) fail(at("images", i), "has no content");
    }
    const std::size_t samplers = list(root, "samplers", "").size();
    for (std::size_t i = 0; i < textures.size(); ++i) {
      index(textures[i], "source", at("textures", i), images.size());
      index(textures[i], "sampler", at("textures", i), samplers);
    }
    const json& materials = list(root, "materials", "");
    for (std::size_t i = 0; i < materials.size(); ++i)
      checkTextureUses(materials[i], at("materials", i), textures.size());
  }

  // Every "...Texture" within a material, its extensions included, must name a texture.
  void checkTextureUses(const json& value, const std::string& place, std::size_t textures) const {
    if (!value.is_object()) return;
    for (const auto& [name, inner] : value.items()) {
      const std::string here = place + "." + name.substr(0, 48);
      if (name.ends_with("Texture") && !index(inner, "index", here, textures)) fail(here, "names no texture");
      checkTextureUses(inner, here, textures);
    }
  }

  void checkNodes(const json& root) const {
    const json& nodes = list(root, "nodes", "");
    if (nodes.empty() || nodes.size() > kMaxModelNodes) fail("nodes", "there are none, or too many");
    std::vector<int> parents(nodes.size(), -1);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      index(nodes[i], "mesh", at("nodes", i), meshCount_);
      for (const char* unread : {"skin", "camera", "weights"}) {
        if (member(nodes[i], unread)) fail(at("nodes", i) + "." + unread, "is not read");
      }
      for (const auto& [name, length] :
           {std::pair{"matrix", 16}, {"translation", 3}, {"rotation", 4}, {"scale", 3}}) {
        const json* numbers = member(nodes[i], name);
        if (!numbers) continue;
        bool good = numbers->is_array() && static_cast<int>(numbers->size()) == length;
        for (std::size_t k = 0; good && k < numbers->size(); ++k) good = (*numbers)[k].is_number();
        if (!good)
          fail(at("nodes", i) + "." + name, "is not a list of " + std::to_string(length) + " numbers");
      }
      for (const json& child : list(nodes[i], "children", at("nodes", i) + ".")) {
        if (!child.is_number_unsigned() || child.get<std::uint64_t>() >= nodes.size()) {
          fail(at("nodes", i) + ".children", "a node that does not exist");
        }
        int& parent = parents[child.get<std::size_t>()];
        if (parent >= 0) fail(at("nodes", i) + ".children", "a node with two parents");
        parent = static_cast<int>(i);
      }
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      int depth = 0;
      for (int node = static_cast<int>(i); node >= 0; node = parents[static_cast<std::size_t>(node)]) {
        if (++depth > kMaxModelDepth) fail(at("nodes", i), "lies too deep, or is its own ancestor");
      }
    }
    const json& scenes = list(root, "scenes", "");
    index(root, "scene", "scene", scenes.size());
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      for (const json& node : list(scenes[i], "nodes", at("scenes", i) + ".")) {
        if (!node.is_number_unsigned() || node.get<std::uint64_t>() >= nodes.size()) {
          fail(at("scenes", i), "a node that does not exist");
        }
      }
    }
    if (scenes.empty()) fail("scenes", "holds no scene");
    for (const char* unread : {"skins", "animations", "cameras"}) {
      if (!list(root, unread, "").empty()) fail(unread, "are not read");
    }
  }

  struct View {
    std::uint64_t bytes, stride;
  };
  struct Accessor {
    std::uint64_t count;
    std::string type;
    std::uint64_t component;
  };

  std::string file_;
  std::vector<std::uint64_t> bufferBytes_;
  std::vector<View> views_;
  std::vector<Accessor> accessors_;
  std::size_t meshCount_ = 0;
  std::uint64_t vertices_ = 0, indices_ = 0;
};

}  // namespace

void checkGltf(std::string_view file, std::span<const std::byte> bytes, ModelFormat format) {
  GltfChecker(file).check(bytes, format);
}

}  // namespace skydrop::render
