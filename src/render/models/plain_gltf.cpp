#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "render/models/data_uri.h"
#include "render/models/gltf_buffers.h"
#include "render/models/gltf_json.h"
#include "render/models/gltf_mesh_size.h"
#include "render/models/gltf_nodes.h"
#include "render/models/gltf_writer.h"
#include "render/models/plain_model.h"
#include "skydrop/core/file.h"
#include "skydrop/core/json.h"

namespace skydrop::render {
namespace {

constexpr int kDeepestJson = 32;
constexpr std::size_t kMostValues = 500'000;  // of the JSON

const char* const kGlossiness = "KHR_materials_pbrSpecularGlossiness";

class GltfReader : private GltfJson {
 public:
  explicit GltfReader(const std::filesystem::path& path)
      : GltfJson(path.string()), folder_(path), buffers_(path.string()) {}

  PlainModel read(std::vector<std::byte> bytes, ModelFormat format) {
    plain_.storage.push_back(std::move(bytes));
    const std::span<const std::byte> content = plain_.storage.front();
    std::string_view text(reinterpret_cast<const char*>(content.data()), content.size());
    if (format == ModelFormat::glb) text = buffers_.splitContainer(content);
    const json root = core::parseJson(
        text, file(), {.bytes = kMaxModelFileBytes, .depth = kDeepestJson, .values = kMostValues});
    if (!root.is_object()) fail("", "is not a glTF object");
    checkHeader(root);
    buffers_.read(root, folder_, plain_.storage);
    readMaterials(root);
    readMeshes(root);
    GltfNodes(file(), sizes_, writer_).read(root);
    plain_.bytes = writer_.bytes();
    return std::move(plain_);
  }

 private:
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
    const GltfAccessor& positions =
        buffers_.accessors()[*index(*attributes, "POSITION", place, buffers_.accessors().size())];
    const auto indices = index(primitive, "indices", place, buffers_.accessors().size());
    const std::uint64_t corners = indices ? buffers_.accessors()[*indices].count : positions.count;
    if (corners % 3 != 0) fail(place, std::to_string(corners) + " corners do not make triangles");
    sizes_.back() += {positions.count, corners};
    allMeshes_ += {positions.count, corners};
    if (allMeshes_.isTooLarge()) fail(place, "the model is too large");
    json written = {{"mode", 4}, {"attributes", readAttributes(*attributes, positions, place)}};
    if (indices)
      written["indices"] = readIndices(buffers_.accessors()[*indices], positions.count, place + ".indices");
    if (const auto material = index(primitive, "material", place, materialCount_))
      written["material"] = *material;
    return written;
  }

  // Tangents, colours and further texture coordinates are not drawn, and left out.
  json readAttributes(const json& attributes, const GltfAccessor& positions, const std::string& place) {
    json written = json::object();
    for (const auto& [name, value] : attributes.items()) {
      const GltfAccessor& accessor =
          buffers_.accessors()[*index(attributes, name.c_str(), place, buffers_.accessors().size())];
      const std::string here = place + "." + name;
      if (accessor.count != positions.count) fail(here, "has another count than POSITION");
      if (name.starts_with("JOINTS") || name.starts_with("WEIGHTS")) fail(here, "skins are not read");
      const bool isVector = name == "POSITION" || name == "NORMAL";
      if (isVector && (accessor.type != "VEC3" || accessor.component != kGltfFloat))
        fail(here, "is not VEC3 of float");
      if (name == "TEXCOORD_0") {
        const bool isFraction =
            (accessor.component == kGltfByte || accessor.component == kGltfShort) && accessor.isNormalized;
        if (accessor.type != "VEC2" || !(accessor.component == kGltfFloat || isFraction)) {
          fail(here, "is not VEC2 of float or of normalised bytes or shorts");
        }
      } else if (!isVector) {
        continue;
      }
      const std::vector<float> numbers = floatsOf(accessor, isVector ? 3 : 2);
      written[name] =
          writer_.add(numbers.data(), numbers.size() * 4, static_cast<std::size_t>(accessor.count),
                      isVector ? "VEC3" : "VEC2", kGltfFloat);
    }
    return written;
  }

  std::size_t readIndices(const GltfAccessor& accessor, std::uint64_t vertices, const std::string& place) {
    const bool isUnsigned = accessor.component == kGltfByte || accessor.component == kGltfShort ||
                            accessor.component == kGltfWord;
    if (accessor.type != "SCALAR" || !isUnsigned) fail(place, "are not unsigned numbers");
    const std::vector<std::uint32_t> indices = wholesOf(accessor);
    for (std::size_t i = 0; i < indices.size(); ++i) {
      if (indices[i] >= vertices) {
        fail(at(place, i), std::to_string(indices[i]) + " is out of range: there are " +
                               std::to_string(vertices) + " vertices");
      }
    }
    return writer_.add(indices.data(), indices.size() * 4, indices.size(), "SCALAR", kGltfWord);
  }

  void readMaterials(const json& root) {
    const json& images = objects(root, "images");
    const json& textures = objects(root, "textures");
    for (std::size_t i = 0; i < images.size(); ++i) {
      const std::string place = at("images", i);
      index(images[i], "bufferView", place, buffers_.views());
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
    if (const auto view = index(image, "bufferView", place, buffers_.views())) {
      plain_.textures.push_back({place, {}, buffers_.view(*view)});
    } else {
      const std::string uri = text(image, "uri", place, kMaxModelFileBytes);
      if (!isDataUri(uri)) return folder_.texture(plain_, place, decodePercent(uri, file(), place));
      plain_.storage.push_back(decodeDataUri(uri, file(), place + ".uri"));
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

  ModelFolder folder_;
  PlainModel plain_;
  GltfWriter writer_;
  GltfBuffers buffers_;
  std::map<std::uint64_t, int> imageTextures_;  // by index of the image
  std::size_t materialCount_ = 0;
  std::vector<GltfMeshSize> sizes_;  // of each mesh
  GltfMeshSize allMeshes_;           // a mesh that several nodes show counts once
};

}  // namespace

PlainModel readPlainGltf(const std::filesystem::path& path, ModelFormat format) {
  return GltfReader(path).read(core::readFile(path, kMaxModelFileBytes), format);
}

}  // namespace skydrop::render
