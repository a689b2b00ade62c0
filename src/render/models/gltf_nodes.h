// The nodes of a glTF file: a tree of bounded depth whose transforms flatten nothing, and the scene that is
// shown.
#pragma once

#include <glm/mat4x4.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/models/gltf_json.h"
#include "render/models/gltf_mesh_size.h"
#include "render/models/gltf_writer.h"

namespace skydrop::render {

class GltfNodes : private GltfJson {
 public:
  // `sizes` are those of the file's meshes. Both references must outlive read().
  GltfNodes(std::string file, std::span<const GltfMeshSize> sizes, GltfWriter& writer)
      : GltfJson(std::move(file)), sizes_(sizes), writer_(writer) {}

  // Throws core::DataError for what is no tree, too deep, flat or too large as it is shown; writes the rest.
  void read(const json& root);

 private:
  struct NodeRow {
    std::string place;
    glm::dmat4 toParent{1};
    std::vector<std::size_t> children;
    std::optional<std::uint64_t> mesh;
    int parent = -1;
  };

  NodeRow readNode(const json& node, std::size_t i, std::size_t count);
  glm::dmat4 readTransform(const json& node, const std::string& place) const;
  void checkTransform(const glm::dmat4& m, const std::string& place, const std::string& what) const;
  void readScenes(const json& root);
  void walk(std::size_t node, const glm::dmat4& parentToModel);

  std::span<const GltfMeshSize> sizes_;
  GltfWriter& writer_;
  GltfMeshSize shown_;  // a mesh that several nodes show counts as often as it is shown
  std::vector<NodeRow> nodes_;
};

}  // namespace skydrop::render
