#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace skydrop::render {

// Writes the geometry as one buffer, and the lists of a glTF file that lead to it.
class GltfWriter {
 public:
  nlohmann::json root = {{"asset", {{"version", "2.0"}}},        {"scene", 0},
                         {"accessors", nlohmann::json::array()}, {"bufferViews", nlohmann::json::array()},
                         {"meshes", nlohmann::json::array()},    {"nodes", nlohmann::json::array()}};

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
    root["buffers"] = nlohmann::json::array({{{"byteLength", buffer_.size()}}});
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

}  // namespace skydrop::render
