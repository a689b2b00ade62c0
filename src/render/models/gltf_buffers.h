// The binary content of a glTF file: its chunks, buffers, views and accessors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/models/gltf_json.h"
#include "render/models/plain_model.h"

namespace skydrop::render {

// Component types of accessors, as glTF numbers them (OpenGL's).
inline constexpr std::uint64_t kGltfByte = 5121, kGltfShort = 5123, kGltfWord = 5125, kGltfFloat = 5126;

struct GltfAccessor {
  std::span<const std::byte> bytes;  // from the first element to the end of the last
  std::uint64_t count, stride, component;
  std::string type;
  bool isNormalized;
};

// The numbers of an accessor of so many a component, as they are in the file; floats of normalised whole
// numbers.
std::vector<float> floatsOf(const GltfAccessor& accessor, std::size_t numbers);
std::vector<std::uint32_t> wholesOf(const GltfAccessor& accessor);

class GltfBuffers : private GltfJson {
 public:
  explicit GltfBuffers(std::string file) : GltfJson(std::move(file)) {}

  // Of binary glTF: the text of the JSON chunk; the binary chunk, if there is one, is kept as the first
  // buffer.
  std::string_view splitContainer(std::span<const std::byte> bytes);
  // Reads what the JSON lists. Files go to `storage`, which must not give them up as long as the spans are
  // used.
  void read(const json& root, ModelFolder& folder, std::vector<std::vector<std::byte>>& storage);

  std::size_t views() const { return views_.size(); }
  std::span<const std::byte> view(std::size_t i) const { return views_[i].bytes; }
  const std::vector<GltfAccessor>& accessors() const { return accessors_; }

 private:
  struct View {
    std::span<const std::byte> bytes;
    std::uint64_t stride;
  };

  void readBuffers(const json& root, ModelFolder& folder, std::vector<std::vector<std::byte>>& storage);
  void readAccessors(const json& root);
  std::uint64_t elementBytes(const json& accessor, const std::string& place) const;

  std::optional<std::span<const std::byte>> binary_;
  std::vector<View> views_;
  std::vector<GltfAccessor> accessors_;
};

}  // namespace skydrop::render
