#include "skydrop/render/marker_pass.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "render/model/visibility.h"

namespace skydrop::render {
namespace {

constexpr double kBeamHeightM = 900;  // above the hills around a target, below the usual cloud
constexpr double kRingReachM = 400;   // up and down: how far the ground within the ring may rise or fall
constexpr float kRingWidthM = 7;
constexpr float kBeamHalfWidthM = 6;
constexpr float kLeastHalfWidthPixels = 2.5f;
constexpr GLuint kDepthUnit = 8;  // models/scene_depth.glsl

MeshData cylinderMesh() {
  constexpr int kSides = 48;
  // Around the circle, so that the drawn sides stand outside it.
  const double radius = 1 / std::cos(3.14159265358979 / kSides);
  MeshData mesh;
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2 * 3.14159265358979 * i / kSides;
    for (const double y : {-1.0, 1.0}) {
      mesh.vertices.push_back({glm::vec3(radius * std::cos(angle), y, radius * std::sin(angle)), {}, {}});
    }
  }
  mesh.vertices.push_back({{0, -1, 0}, {}, {}});
  mesh.vertices.push_back({{0, 1, 0}, {}, {}});
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % kSides), bottom = 2 * kSides, top = bottom + 1;
    for (const std::uint32_t v : {a, a + 1, b, b, a + 1, b + 1, bottom, a, b, top, b + 1, a + 1})
      mesh.indices.push_back(v);
  }
  return mesh;
}

MeshData stripMesh() {
  MeshData mesh;
  constexpr int kSteps = 16;  // the veil of haze is computed at the vertices' pixels, the fade between them
  for (int i = 0; i <= kSteps; ++i) {
    const float y = static_cast<float>(i) / kSteps;
    mesh.vertices.push_back({{-1, y, 0}, {}, {}});
    mesh.vertices.push_back({{1, y, 0}, {}, {}});
  }
  for (std::uint32_t i = 0; i < kSteps; ++i) {
    const std::uint32_t a = 2 * i;
    for (const std::uint32_t v : {a, a + 1, a + 2, a + 2, a + 1, a + 3}) mesh.indices.push_back(v);
  }
  return mesh;
}

}  // namespace

MarkerPass::MarkerPass(gl::Context& context)
    : cylinder_(context, cylinderMesh(), "target ring"), strip_(context, stripMesh(), "target beam") {}

std::optional<std::string> MarkerPass::idleReason(const FrameInput& frame) const {
  const game::TargetSnapshot& target = frame.snapshot.target;
  if (!target.present) return "no target";
  if (!maySee(frame.view, target.position + glm::dvec3(0, kBeamHeightM / 2, 0),
              kBeamHeightM / 2 + kRingReachM)) {
    return "the target is out of view";
  }
  return std::nullopt;
}

void MarkerPass::draw(FrameContext& context) {
  const game::TargetSnapshot& target = context.frame.snapshot.target;
  const View& view = context.frame.view;
  const gl::Functions& api = context.gl.api();
  const glm::vec3 middle = relativeToEye(view, target.position);
  api.Enable(GL_BLEND);
  api.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  context.sceneDepth.bind(kDepthUnit);

  // The far side of the cylinder: it is there wherever the eye is, inside included.
  gl::Shader& ring = context.shaders.shader("markers/ring.vert", "markers/ring.frag", context.defines);
  ring.use();
  ring.setVec3("middle", middle);
  ring.setVec3("extent", {static_cast<float>(target.radius) + kRingWidthM, static_cast<float>(kRingReachM),
                          static_cast<float>(target.radius) + kRingWidthM});
  ring.setFloat("radiusM", static_cast<float>(target.radius));
  ring.setFloat("widthM", kRingWidthM);
  api.Enable(GL_CULL_FACE);
  api.CullFace(GL_FRONT);
  cylinder_.draw();
  api.CullFace(GL_BACK);
  api.Disable(GL_CULL_FACE);

  gl::Shader& beam = context.shaders.shader("markers/beam.vert", "markers/beam.frag", context.defines);
  beam.use();
  const double pixelRad = 2 * std::tan(view.fovYRad / 2) / view.height;
  const glm::dvec3 away = target.position - view.position;
  // Turned about the vertical towards the eye; from straight above any direction will do.
  const double level = std::sqrt(away.x * away.x + away.z * away.z);
  const glm::dvec3 across =
      level > 1e-3 ? glm::dvec3(-away.z / level, 0, away.x / level) : glm::dvec3(1, 0, 0);
  beam.setVec3("middle", middle);
  beam.setVec3("across", glm::vec3(across));
  beam.setFloat("heightM", static_cast<float>(kBeamHeightM));
  beam.setFloat("halfWidthM", kBeamHalfWidthM);
  beam.setFloat("leastHalfWidthRad", static_cast<float>(kLeastHalfWidthPixels * pixelRad));
  strip_.draw();
}

}  // namespace skydrop::render
