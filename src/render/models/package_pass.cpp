#include "skydrop/render/models/package_pass.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "render/frame/visibility.h"
#include "skydrop/core/assets.h"
#include "skydrop/game/snapshot.h"
#include "skydrop/render/frame/sea_cut.h"

namespace skydrop::render {
namespace {

// Of assets/scripts/make_package.py.
constexpr double kHarnessM = 0.58;     // where the lines meet, above the crate's centre
constexpr double kFallenLiftM = 0.12;  // over the plane of the ground, which is not quite one
constexpr double kFallenM = 3.2;       // from the crate to the middle of the canopy on the ground
constexpr double kSeenRadiusM = 8;     // crate and open parachute, around the crate
constexpr double kCrateAreaM2 = 1, kCanopyAreaM2 = 30;  // of the outlines, roughly

Model load(gl::Context& context, const ModelImport& import, const char* name) {
  return Model(context, import(core::assetPath(std::string("models/") + name)), name);
}

// The canopy trails behind the package's way through the air; hanging still it stands upright.
glm::dquat canopyAttitude(const game::PackageSnapshot& package, const glm::dvec3& wind) {
  const glm::dvec3 against = wind - package.velocity;
  const double speed = glm::length(against);
  const glm::dvec3 up = speed < 0.5 ? glm::dvec3(0, 1, 0) : against / speed;
  const glm::dvec3 half = up + glm::dvec3(0, 1, 0);
  const double length = glm::length(half);
  if (length < 1e-6) return {0, 1, 0, 0};  // straight down: half a turn about x
  const glm::dvec3 between = half / length;
  return {between.y, glm::cross(glm::dvec3(0, 1, 0), between)};
}

// Of the parachute's model to its own place, by how far it is open: first a streamer, then it fills.
glm::mat4 shapeOf(const game::PackageSnapshot& package) {
  const auto open = static_cast<float>(std::clamp(package.parachuteOpen, 0.0, 1.0));
  const float width = 0.10f + 0.90f * open * open;
  return glm::scale(glm::mat4(1), glm::vec3(width, 0.75f + 0.25f * open, width));
}

// Upright on the ground's slope, turned so that the body's +x points down the wind.
glm::dquat lyingAttitude(const game::PackageSnapshot& package, const glm::dvec3& wind) {
  const glm::dvec3 level(wind.x, 0, wind.z), up = package.groundNormal;
  const glm::dvec3 along = glm::dot(level, level) > 0.01 ? level : glm::dvec3(1, 0, 0);
  const glm::dvec3 right = glm::normalize(along - up * glm::dot(along, up));
  return glm::normalize(glm::quat_cast(glm::dmat3(right, up, glm::cross(right, up))));
}

bool isSeen(const FrameInput& frame, const game::PackageSnapshot& package) {
  return isPotentiallyVisible(frame.view, package.position, kSeenRadiusM);
}

void drawCrate(const PackageModels& models, const game::PackageSnapshot& package, const View& view,
               const DrawPart& draw) {
  draw(models.crate, bodyMatrix(view, package.position, package.orientation), ModelPose(models.crate));
}

void drawParachute(const PackageModels& models, const game::PackageSnapshot& package, const glm::dvec3& wind,
                   const View& view, const DrawPart& draw) {
  if (package.parachuteOpen <= 0) return;
  ModelPose pose(models.parachute);
  if (package.landed) {  // emptied, beside the crate
    pose.showOnly("fallen");
    const glm::dquat attitude = lyingAttitude(package, wind);
    const glm::dvec3 middle = package.position + attitude * glm::dvec3(kFallenM, kFallenLiftM, 0);
    draw(models.parachute, bodyMatrix(view, middle, attitude), pose);
    return;
  }
  pose.hide("fallen");
  const glm::dvec3 harness = package.orientation * glm::dvec3(0, kHarnessM, 0);
  const glm::mat4 toEye = bodyMatrix(view, package.position + harness, canopyAttitude(package, wind));
  draw(models.parachute, toEye * shapeOf(package), pose);
}

}  // namespace

PackageModels::PackageModels(gl::Context& context, const ModelImport& import)
    : crate(load(context, import, "package.glb")), parachute(load(context, import, "parachute.glb")) {}

ShadowSource packageShadows(std::shared_ptr<const PackageModels> models) {
  return [models = std::move(models)](const FrameInput& frame, std::vector<ShadowCaster>& casters) {
    if (!frame.game) return;
    for (const game::PackageSnapshot& package : frame.game->packages) {
      const auto parts = [models, &package, wind = frame.game->wind](const View& view, const DrawPart& draw) {
        drawCrate(*models, package, view, draw);
        drawParachute(*models, package, wind, view, draw);
      };
      const double area = package.parachuteOpen > 0 ? kCanopyAreaM2 : kCrateAreaM2;
      casters.push_back({package.position, kSeenRadiusM, area, parts});
    }
  };
}

std::optional<std::string> PackagePass::skipReason(const FrameInput& frame) const {
  if (!frame.game || frame.game->packages.empty()) return "no package has been dropped";
  const auto& packages = frame.game->packages;
  if (std::none_of(packages.begin(), packages.end(), [&](const auto& p) { return isSeen(frame, p); })) {
    return "no package in view";
  }
  return std::nullopt;
}

PixelBox PackagePass::extent(const FrameInput& frame) const {
  PixelBox all;
  const glm::dvec3 half(kSeenRadiusM);
  for (const game::PackageSnapshot& package : frame.game->packages) {
    if (!isSeen(frame, package)) continue;
    const glm::mat4 toEye = bodyMatrix(frame.view, package.position, glm::dquat(1, 0, 0, 0));
    all = unite(all, pixelsOf(frame.view, toEye, -half, half));
  }
  return all;
}

void PackagePass::draw(FrameContext& context) {
  const View& view = context.frame.view;
  std::vector<std::string> cloth(context.meshDefines.begin(), context.meshDefines.end());
  cloth.emplace_back("CLOTH");
  LightShares light;  // at the package
  const auto with = [&](std::span<const std::string> defines) {
    return [&context, &light, defines](const Model& model, const glm::mat4& toEye, const ModelPose& pose) {
      model.draw(context.shaders, "models/model.vert", "models/model.frag", defines, toEye, pose, light);
    };
  };
  const SeaCut cut(context);
  context.gl.api().Enable(GL_CULL_FACE);
  for (const game::PackageSnapshot& package : context.frame.game->packages) {
    if (!isSeen(context.frame, package)) continue;
    light = lightAt(context.resources, package.position);
    drawCrate(*models_, package, view, with(context.meshDefines));
    drawParachute(*models_, package, context.frame.game->wind, view, with(cloth));
  }
}

}  // namespace skydrop::render
