#include "skydrop/render/models/model.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "skydrop/core/error.h"

namespace skydrop::render {
namespace {

core::Image plainImage(std::array<std::uint8_t, 4> texel) {
  core::Image image(1, 1);
  std::copy(texel.begin(), texel.end(), image.rgba.begin());
  return image;
}

// Without textures: white, and the 4 % that most matt materials reflect (sRGB 57), hardly glossy.
constexpr std::array<std::uint8_t, 4> kPlainDiffuse = {255, 255, 255, 255};
constexpr std::array<std::uint8_t, 4> kPlainSpecular = {57, 57, 57, 40};

}  // namespace

ModelPose::ModelPose(const Model& model) : model_(&model), shown_(model.nodes().size(), true) {
  for (const ModelNode& node : model.nodes()) toParent_.push_back(node.toParent);
}

void ModelPose::turn(std::string_view node, const glm::vec3& axis, float angleRad) {
  const int index = model_->node(node);
  if (index < 0) return;
  glm::mat4& toParent = toParent_[static_cast<std::size_t>(index)];
  toParent = glm::rotate(toParent, angleRad, axis);
}

void ModelPose::hide(std::string_view node) {
  if (const int index = model_->node(node); index >= 0) shown_[static_cast<std::size_t>(index)] = false;
}

void ModelPose::showOnly(std::string_view node) {
  const int index = model_->node(node);
  for (std::size_t i = 0; i < shown_.size(); ++i) shown_[i] = static_cast<int>(i) == index;
}

glm::mat4 ModelPose::toModel(int node) const {
  glm::mat4 result(1);
  for (; node >= 0; node = model_->nodes()[static_cast<std::size_t>(node)].parent) {
    result = toParent_[static_cast<std::size_t>(node)] * result;
  }
  return result;
}

Model::Model(gl::Context& context, const ModelData& data, std::string_view label) : nodes_(data.nodes) {
  const std::string name(label);
  for (const core::Image& image : data.images) textures_.push_back(upload(context, image, name));
  const auto plain = [&](const core::Image& image) {
    textures_.push_back(upload(context, image, name + " plain"));
    return static_cast<int>(textures_.size()) - 1;
  };
  const int plainDiffuse = plain(plainImage(kPlainDiffuse)),
            plainSpecular = plain(plainImage(kPlainSpecular));
  for (const ModelMaterial& from : data.materials) {
    Material material{from.diffuse, from.specular, {}};
    if (material.diffuse.empty()) material.diffuse = {plainDiffuse};
    if (material.specular.empty()) material.specular = {plainSpecular};
    if (material.diffuse.size() > kMaxTextures || material.specular.size() > kMaxTextures) {
      throw core::DataError(name, "material '" + from.name + "'", "has more than four textures of a kind");
    }
    material.defines = {"DIFFUSE_TEXTURES " + std::to_string(material.diffuse.size()),
                        "SPECULAR_TEXTURES " + std::to_string(material.specular.size())};
    materials_.push_back(std::move(material));
  }
  for (const ModelMesh& mesh : data.meshes) {
    meshes_.emplace_back(context, mesh.data, name + " " + mesh.name);
    meshMaterials_.push_back(mesh.material);
  }
  const ModelPose rest(*this);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const glm::mat4 toModel = rest.toModel(static_cast<int>(i));
    for (const int mesh : nodes_[i].meshes) {
      for (const MeshVertex& vertex : data.meshes[static_cast<std::size_t>(mesh)].data.vertices) {
        const glm::vec3 place(toModel * glm::vec4(vertex.position, 1));
        radius_ = std::max(radius_, glm::length(place));
        low_ = glm::min(low_, place);
        high_ = glm::max(high_, place);
      }
    }
  }
}

gl::Texture Model::upload(gl::Context& context, const core::Image& image, const std::string& label) const {
  gl::Texture texture = gl::Texture::make2D(context, GL_SRGB8_ALPHA8, image.width, image.height, label,
                                            gl::mipLevels(image.width, image.height));
  // The importer's v points up: the bottom row comes first.
  std::vector<std::uint8_t> flipped(image.rgba.size());
  const std::size_t row = static_cast<std::size_t>(image.width) * 4;
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
    std::memcpy(flipped.data() + y * row,
                image.rgba.data() + (static_cast<std::size_t>(image.height) - 1 - y) * row, row);
  }
  texture.upload(GL_RGBA, GL_UNSIGNED_BYTE, std::as_bytes(std::span(flipped)));
  texture.generateMipmaps();
  texture.setWrap(GL_REPEAT);
  return texture;
}

int Model::node(std::string_view name) const {
  const auto found =
      std::find_if(nodes_.begin(), nodes_.end(), [&](const ModelNode& n) { return n.name == name; });
  return found == nodes_.end() ? -1 : static_cast<int>(found - nodes_.begin());
}

void Model::draw(gl::ShaderCache& shaders, const std::string& vertex, const std::string& fragment,
                 std::span<const std::string> defines, const glm::mat4& toEye, const ModelPose& pose,
                 const LightShares& light, const ModelLamps* lamps, const FlashLight* flash) const {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const int index = static_cast<int>(i);
    if (nodes_[i].meshes.empty() || !pose.isShown(index)) continue;
    const glm::mat4 meshToEye = toEye * pose.toModel(index);
    for (const int mesh : nodes_[i].meshes) {
      const Material& material =
          materials_[static_cast<std::size_t>(meshMaterials_[static_cast<std::size_t>(mesh)])];
      std::vector<std::string> all(defines.begin(), defines.end());
      all.insert(all.end(), material.defines.begin(), material.defines.end());
      if (lamps) all.emplace_back(ModelLamps::kDefine);
      if (flash) all.emplace_back(FlashLight::kDefine);
      gl::Shader& shader = shaders.shader(vertex, fragment, all);
      shader.use();
      shader.setMatrix("toEye", meshToEye);
      shader.setMatrix("normalToEye", glm::inverseTranspose(glm::mat3(meshToEye)));
      shader.setVec3("lightShares", glm::vec3(glm::dvec3(light.sun, light.sky, light.diffuseSun)));
      if (lamps) {
        shader.setVec4s("lampPlaces", lamps->places);
        shader.setVec4s("lampLights", lamps->lights);
      }
      if (flash) flash->set(shader);
      for (std::size_t k = 0; k < material.diffuse.size(); ++k) {
        textures_[static_cast<std::size_t>(material.diffuse[k])].bind(static_cast<GLuint>(k));
      }
      for (std::size_t k = 0; k < material.specular.size(); ++k) {
        textures_[static_cast<std::size_t>(material.specular[k])].bind(kMaxTextures + static_cast<GLuint>(k));
      }
      meshes_[static_cast<std::size_t>(mesh)].draw();
    }
  }
}

void Model::drawOutline(gl::Shader& shader, const glm::mat4& modelToClip, const ModelPose& pose) const {
  shader.use();
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const int index = static_cast<int>(i);
    if (nodes_[i].meshes.empty() || !pose.isShown(index)) continue;
    shader.setMatrix("toClip", modelToClip * pose.toModel(index));
    for (const int mesh : nodes_[i].meshes) meshes_[static_cast<std::size_t>(mesh)].draw();
  }
}

}  // namespace skydrop::render
