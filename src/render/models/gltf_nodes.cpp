#include "render/models/gltf_nodes.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

namespace skydrop::render {
namespace {

// Least length of a node's axis, and least volume that its axes span relative to their lengths: what is
// flatter has no normals.
constexpr double kLeastScale = 1e-6;

}  // namespace

void GltfNodes::read(const json& root) {
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

GltfNodes::NodeRow GltfNodes::readNode(const json& node, std::size_t i, std::size_t count) {
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

glm::dmat4 GltfNodes::readTransform(const json& node, const std::string& place) const {
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

void GltfNodes::checkTransform(const glm::dmat4& m, const std::string& place, const std::string& what) const {
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
void GltfNodes::readScenes(const json& root) {
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

void GltfNodes::walk(std::size_t node, const glm::dmat4& parentToModel) {
  const NodeRow& row = nodes_[node];
  const glm::dmat4 toModel = parentToModel * row.toParent;
  checkTransform(toModel, row.place, "its transform with that of its parents");
  if (row.mesh) {
    shown_ += sizes_[*row.mesh];
    if (shown_.isTooLarge()) fail(row.place, "the model is too large");
  }
  for (const std::size_t child : row.children) walk(child, toModel);
}

}  // namespace skydrop::render
