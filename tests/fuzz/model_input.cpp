#include "fuzz/model_input.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "skydrop/core/assets.h"
#include "skydrop/render/models/model_import.h"

namespace skydrop::fuzz {
namespace {

void copyCompanions() {
  const std::set<std::string> companions = {".mtl", ".png", ".bin"};
  for (const auto& entry :
       std::filesystem::directory_iterator(core::dataFolder().string() + "/tests/corpus/models")) {
    if (companions.contains(entry.path().extension().string()))
      std::filesystem::copy_file(entry.path(), inputFolder() / entry.path().filename(),
                                 std::filesystem::copy_options::overwrite_existing);
  }
}

void requireSound(const render::ModelData& model) {
  require(!model.materials.empty() && !model.nodes.empty(), "a model has a material and a node");
  for (const render::ModelMesh& mesh : model.meshes) {
    require(static_cast<std::size_t>(mesh.material) < model.materials.size(), "a material is in range");
    for (const render::MeshVertex& vertex : mesh.data.vertices)
      require(std::abs(glm::length(vertex.normal) - 1) < 1e-3f, "a normal has length 1");
    for (const std::uint32_t index : mesh.data.indices)
      require(index < mesh.data.vertices.size(), "an index is in range");
  }
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    require(model.nodes[i].parent < static_cast<int>(i), "parents come before their children");
    for (const int mesh : model.nodes[i].meshes)
      require(static_cast<std::size_t>(mesh) < model.meshes.size(), "a mesh is in range");
  }
}

}  // namespace

void readModel(const std::string& ending, const std::uint8_t* data, std::size_t size) {
  static const bool isCopied = (copyCompanions(), true);
  static_cast<void>(isCopied);
  const std::filesystem::path file = inputFile("a" + ending, data, size);
  accepts(inputFolder().filename().string(), [&] { requireSound(render::importModel(file)); });
}

}  // namespace skydrop::fuzz
