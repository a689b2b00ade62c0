#include "render/models/gltf_buffers.h"

#include <array>
#include <cstring>

#include "render/models/data_uri.h"

namespace skydrop::render {
namespace {

std::uint32_t word(std::span<const std::byte> bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, 4);  // little-endian, as every platform of the game
  return value;
}

}  // namespace

std::vector<float> floatsOf(const GltfAccessor& accessor, std::size_t numbers) {
  std::vector<float> result;
  result.reserve(static_cast<std::size_t>(accessor.count) * numbers);
  for (std::size_t i = 0; i < accessor.count; ++i) {
    const std::byte* element = accessor.bytes.data() + i * accessor.stride;
    for (std::size_t k = 0; k < numbers; ++k) {
      float value = 0;
      if (accessor.component == kGltfFloat) {
        std::memcpy(&value, element + 4 * k, 4);
      } else if (accessor.component == kGltfShort) {
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

std::vector<std::uint32_t> wholesOf(const GltfAccessor& accessor) {
  std::vector<std::uint32_t> result;
  result.reserve(static_cast<std::size_t>(accessor.count));
  const std::size_t size = accessor.component == kGltfByte ? 1 : accessor.component == kGltfShort ? 2 : 4;
  for (std::size_t i = 0; i < accessor.count; ++i) {
    std::uint32_t value = 0;
    std::memcpy(&value, accessor.bytes.data() + i * accessor.stride, size);
    result.push_back(value);
  }
  return result;
}

std::string_view GltfBuffers::splitContainer(std::span<const std::byte> bytes) {
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
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()) + 20, jsonBytes);
  const std::size_t at = 20 + jsonBytes;
  if (at == bytes.size()) return text;
  if (jsonBytes % 4 != 0) fail("JSON chunk", "its length is not a multiple of 4");
  if (bytes.size() - at < 8) fail("BIN chunk", "the file ends in its header");
  if (word(bytes, at + 4) != kBinary) fail("BIN chunk", "another chunk is in its place");
  if (word(bytes, at) > bytes.size() - at - 8) fail("BIN chunk", "is longer than the file");
  if (word(bytes, at) < bytes.size() - at - 8) fail("BIN chunk", "more follows it");
  binary_ = bytes.subspan(at + 8);
  return text;
}

void GltfBuffers::read(const json& root, ModelFolder& folder, std::vector<std::vector<std::byte>>& storage) {
  readBuffers(root, folder, storage);
  readAccessors(root);
}

void GltfBuffers::readBuffers(const json& root, ModelFolder& folder,
                              std::vector<std::vector<std::byte>>& storage) {
  std::vector<std::span<const std::byte>> buffers;
  const json& all = objects(root, "buffers");
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string place = at("buffers", i);
    const std::uint64_t bytes = whole(all[i], "byteLength", place);
    std::span<const std::byte> content;
    if (member(all[i], "uri")) {
      const std::string uri = text(all[i], "uri", place, kMaxModelFileBytes);
      storage.push_back(isDataUri(uri) ? decodeDataUri(uri, file(), place + ".uri")
                                       : folder.read(place + ".uri", decodePercent(uri, file(), place)));
      content = storage.back();
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

void GltfBuffers::readAccessors(const json& root) {
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

std::uint64_t GltfBuffers::elementBytes(const json& accessor, const std::string& place) const {
  static const std::array<std::pair<const char*, std::uint64_t>, 7> kinds = {
      {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}}};
  static const std::array<std::pair<std::uint64_t, std::uint64_t>, 6> components = {
      {{5120, 1}, {kGltfByte, 1}, {5122, 2}, {kGltfShort, 2}, {kGltfWord, 4}, {kGltfFloat, 4}}};
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

}  // namespace skydrop::render
