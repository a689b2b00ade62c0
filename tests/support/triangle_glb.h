// A small glTF file in memory that tests break in one place at a time.
#pragma once

#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "skydrop/core/file.h"

namespace skydrop::test {

// One triangle in the x-y plane, facing +z, under a root node named "root".
struct TriangleGlb {
  TriangleGlb() {
    const float positions[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const float normals[9] = {0, 0, 1, 0, 0, 1, 0, 0, 1};
    const std::uint32_t indices[3] = {0, 1, 2};
    append(positions, sizeof positions);
    append(normals, sizeof normals);
    append(indices, sizeof indices);
    json = nlohmann::json::parse(R"({
      "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
      "nodes": [{"name": "root", "children": [1]}, {"name": "part", "mesh": 0, "translation": [1, 2, 3]}],
      "meshes": [{"name": "part", "primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}, "indices": 2}]}],
      "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
        {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC3"},
        {"bufferView": 2, "componentType": 5125, "count": 3, "type": "SCALAR"}],
      "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 36},
        {"buffer": 0, "byteOffset": 72, "byteLength": 12}],
      "buffers": [{"byteLength": 84}]})");
  }

  std::string bytes() const { return bytes(json.dump()); }
  // The same with any text as JSON.
  std::string bytes(std::string text) const {
    text.append((4 - text.size() % 4) % 4, ' ');
    std::string file = "glTF";
    appendWord(file, 2);
    appendWord(file, static_cast<std::uint32_t>(12 + 8 + text.size() + 8 + binary.size()));
    appendWord(file, static_cast<std::uint32_t>(text.size()));
    file += "JSON" + text;
    appendWord(file, static_cast<std::uint32_t>(binary.size()));
    file += std::string("BIN\0", 4) + binary;
    return file;
  }

  void setFloat(std::size_t offset, float value) { std::memcpy(binary.data() + offset, &value, 4); }
  void setIndex(std::size_t corner, std::uint32_t value) {
    std::memcpy(binary.data() + 72 + 4 * corner, &value, 4);
  }

  nlohmann::json json;
  std::string binary;

 private:
  void append(const void* data, std::size_t size) { binary.append(static_cast<const char*>(data), size); }
  static void appendWord(std::string& file, std::uint32_t word) {
    file.append(reinterpret_cast<const char*>(&word), 4);
  }
};

}  // namespace skydrop::test
