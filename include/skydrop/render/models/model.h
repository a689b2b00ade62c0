// Models on the GPU and how they are posed in a frame. Lengths in metres in the model's own frame (right +x,
// up +y, nose -z). On the context's thread; a Model owns its GL objects and must go before its context, a
// ModelPose refers to its Model and must go before it.
#pragma once

#include <glm/mat4x4.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "skydrop/render/frame/flash_light.h"
#include "skydrop/render/frame/light_shares.h"
#include "skydrop/render/gl/shader_cache.h"
#include "skydrop/render/gl/texture.h"
#include "skydrop/render/models/mesh.h"
#include "skydrop/render/models/model_import.h"
#include "skydrop/render/models/model_lamps.h"

namespace skydrop::render {

class Model;

// How the parts of a model are posed in one frame. Starts at rest with everything shown.
class ModelPose {
 public:
  explicit ModelPose(const Model& model);

  // Turns a node, and what hangs on it, about an axis of its own frame (unit), on top of its place in the
  // file. Nodes that the model does not have are ignored: a model may come without flaps.
  void turn(std::string_view node, const glm::vec3& axis, float angleRad);
  // These two hide what hangs on the hidden nodes too. An unknown node is ignored.
  void hide(std::string_view node);
  void showOnly(std::string_view node);

  bool isShown(int node) const { return shown_[static_cast<std::size_t>(node)]; }
  // Of a node's frame to the model's.
  glm::mat4 toModel(int node) const;

 private:
  const Model* model_;
  std::vector<glm::mat4> toParent_;
  std::vector<bool> shown_;
};

// A model on the GPU: meshes, textures, and nodes with names (thesis, section 3.2.5).
//
// Shaders see, for each mesh: uniform mat4 toEye (of the mesh to eye-relative world axes), mat3 normalToEye,
// and samplers texture_diffuse1.. on units 0.. and texture_specular1.. on units kMaxTextures.., as many as
// the defines DIFFUSE_TEXTURES and SPECULAR_TEXTURES say (at least one each: a material without gets a plain
// one).
class Model {
 public:
  static constexpr int kMaxTextures = 4;  // of a kind; more are refused
  static constexpr GLuint kFreeUnit = 2 * kMaxTextures;

  Model() = default;  // empty: draws nothing, has no nodes
  // Throws core::DataError for a material with too many textures; `label` names it and the GL objects.
  Model(gl::Context& context, const ModelData& data, std::string_view label);

  const std::vector<ModelNode>& nodes() const { return nodes_; }
  int node(std::string_view name) const;  // -1: there is none
  // Radius around the model's origin that holds every vertex at rest, m.
  float radius() const { return radius_; }
  // The box that holds every vertex at rest.
  const glm::vec3& low() const { return low_; }
  const glm::vec3& high() const { return high_; }

  // Draws what the pose shows with programs of these entry points. `defines` are added to the model's own;
  // `lamps` and a flash light it beside sun and sky (programs are then compiled with ModelLamps::kDefine and
  // FlashLight::kDefine).
  // toEye: of the model's frame to eye-relative world axes; no shear without scale of one node's own.
  void draw(gl::ShaderCache& shaders, const std::string& vertex, const std::string& fragment,
            std::span<const std::string> defines, const glm::mat4& toEye, const ModelPose& pose,
            const LightShares& light, const ModelLamps* lamps = nullptr,
            const FlashLight* flash = nullptr) const;
  // Draws the shape alone, with a program that knows `uniform mat4 toClip` and needs no texture.
  // modelToClip: of the model's frame to clip space.
  void drawOutline(gl::Shader& shader, const glm::mat4& modelToClip, const ModelPose& pose) const;

 private:
  struct Material {
    std::vector<int> diffuse, specular;  // indices into textures_
    std::vector<std::string> defines;
  };

  gl::Texture upload(gl::Context& context, const core::Image& image, const std::string& label) const;

  std::vector<ModelNode> nodes_;
  std::vector<Mesh> meshes_;
  std::vector<int> meshMaterials_;
  std::vector<Material> materials_;
  std::vector<gl::Texture> textures_;
  float radius_ = 0;
  glm::vec3 low_{0}, high_{0};
};

}  // namespace skydrop::render
