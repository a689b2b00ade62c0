#include "skydrop/render/terrain/terrain_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/common.hpp>
#include <span>

#include "render/frame/visibility.h"
#include "skydrop/core/shared.h"
#include "skydrop/render/clouds/cloud_shadow_map.h"
#include "skydrop/render/clouds/ice_shade.h"
#include "skydrop/render/frame/fallen_water.h"
#include "skydrop/render/frame/flash_light.h"
#include "skydrop/render/frame/ground_detail.h"
#include "skydrop/render/frame/land_surface.h"
#include "skydrop/render/frame/place_map.h"
#include "skydrop/render/frame/sea_cut.h"
#include "skydrop/render/frame/sea_waves.h"
#include "skydrop/render/frame/spot_light.h"
#include "skydrop/render/frame/standing_woods.h"
#include "skydrop/render/shadows/cast_shadows.h"
#include "skydrop/render/shadows/land_shadow_map.h"
#include "skydrop/terrain/chunk_grid.h"

namespace skydrop::render {
namespace {

constexpr GLuint kHeightsUnit = 0, kNormalsUnit = 1, kTableUnit = 2, kDepthUnit = 3;  // as in shaders/terrain
constexpr GLuint kLightSharesUnit = 4;
constexpr GLuint kMirrorImage = 1;
constexpr GLsizei kSeaVertices = 12;  // four triangles (shaders/terrain/sea.glsl)
constexpr const char* kStripDefine = "GRASS_STRIP";
constexpr int kPatchSide = terrain::kPatchCells + 1;
constexpr GLsizei kPatchIndices = 3 * terrain::kTrianglesPerPatch;

// Rows of cells from north to south, each cut from its north-east to its south-west corner; then each vertex
// once, for drawing points.
std::vector<std::uint16_t> patchIndices() {
  std::vector<std::uint16_t> indices;
  for (int z = 0; z < terrain::kPatchCells; ++z) {
    for (int x = 0; x < terrain::kPatchCells; ++x) {
      const int nw = z * kPatchSide + x, ne = nw + 1, sw = nw + kPatchSide, se = sw + 1;
      for (const int i : {nw, sw, ne, ne, sw, se}) indices.push_back(static_cast<std::uint16_t>(i));
    }
  }
  for (int i = 0; i < kPatchSide * kPatchSide; ++i) indices.push_back(static_cast<std::uint16_t>(i));
  return indices;
}

template <std::size_t N>
std::array<float, N> inFloat(const std::array<double, N>& values) {
  std::array<float, N> result{};
  std::transform(values.begin(), values.end(), result.begin(),
                 [](double v) { return static_cast<float>(v); });
  return result;
}

// The variant of the land's shaders.
std::vector<std::string> landDefines(const FrameContext& context) {
  std::vector<std::string> defines(context.defines.begin(), context.defines.end());
  if (context.settings.landDetail == LandDetail::rich) defines.emplace_back("RICH_LAND");
  return defines;
}

}  // namespace

terrain::ViewVolume viewVolume(const View& view) {
  if (view.offAxis == glm::dvec2(0))
    return terrain::makeViewVolume(view.position, view.worldToView, view.fovYRad, view.width, view.height);
  // Off its axis: as wide to both sides as to the farther one, of pixels of the same size.
  const double tangent = std::tan(view.fovYRad / 2);
  const glm::dvec2 times = 1.0 + glm::abs(view.offAxis) / (tangent * glm::dvec2(view.aspect(), 1));
  const glm::ivec2 size(glm::ceil(times * glm::dvec2(view.width, view.height)));
  return terrain::makeViewVolume(view.position, view.worldToView, 2 * std::atan(times.y * tangent), size.x,
                                 size.y);
}

TerrainPass::TerrainPass(gl::Context& context, bool hasAlpineBelts)
    : context_(context),
      indices_(
          gl::Buffer::of<std::uint16_t>(context, patchIndices(), gl::Buffer::Use::fixed, "patch indices")),
      patches_(context, "patches"),
      triangle_(context),
      seaPlane_(context, "sea"),
      hasAlpineBelts_(hasAlpineBelts) {
  patches_.setIndexBuffer(indices_);
}

void TerrainPass::take(const terrain::TerrainFrame& frame) {
  if (textures_.layers() != frame.layerCount) textures_ = ChunkTextures(context_, frame.layerCount);
  for (const terrain::ChunkUpload& upload : frame.uploads) textures_.upload(upload);
  textures_.setResident(frame.chunks);

  std::vector<Instance> instances;
  instances.reserve(frame.patches.size());
  for (const terrain::PatchDraw& p : frame.patches) {
    const int edges = p.coarser[0] | p.coarser[1] << 4 | p.coarser[2] << 8 | p.coarser[3] << 12;
    instances.push_back({{p.x, p.z, p.layer, p.level}, {p.sampleX, p.sampleZ, p.chunkLevel, edges}});
  }
  const std::size_t bytes = instances.size() * sizeof(Instance);
  if (bytes > instances_.size()) {
    instances_ = gl::Buffer(context_, std::max<std::size_t>(2 * bytes, 1 << 14), gl::Buffer::Use::write,
                            "patch instances");
    patches_.setVertexBuffer(0, instances_, 0, sizeof(Instance), 1);
    patches_.setIntegerAttribute(0, 0, 4, GL_INT, 0);
    patches_.setIntegerAttribute(1, 0, 4, GL_INT, sizeof(glm::ivec4));
  }
  if (bytes > 0) instances_.write(0, std::as_bytes(std::span(instances)));
  instanceCount_ = static_cast<GLsizei>(instances.size());
  nearestM_ = frame.patches.empty() ? 0 : frame.patches.front().distanceM;
  base_ = frame.base;
  heightRange_ = frame.heightRange;
  lod_ = frame.lod;
  farDistanceM_ = frame.farDistanceM;
  seaFloorDepthM_ = frame.seaFloorDepthM;
}

void TerrainPass::wear(const terrain::GroundPicture& picture) { ground_.emplace(context_, picture); }

void TerrainPass::lay(const std::optional<terrain::Strip>& strip) {
  hasStrips_ = true;
  strip_ = strip;
}

std::optional<std::string> TerrainPass::skipReason(const FrameInput&) const {
  if (textures_.layers() == 0) return "no land has been handed over yet";
  return std::nullopt;
}

void TerrainPass::draw(FrameContext& context) {
  const View& view = context.frame.view;
  const auto* given = context.resources.find<LandSurface>();
  drawn_ = given ? given->target : &surface_;
  context.resources.publish<LandGround>(*this);
  if (context.settings.wireframe) {
    drawLines(context);
  } else {
    drawDepth(context);
    drawLitLand(context);
    if (view.position.y > 0 && !context.frame.isMirrored) drawSea(context);
  }
  if (context.settings.terrainNormals && !context.frame.isMirrored) {
    gl::Shader& shader =
        context.shaders.shader("terrain/normals.vert", "terrain/line.frag", {}, "terrain/normals.geom");
    shader.setVec3("lineAlbedo", {0.8f, 0.3f, 0.1f});
    drawPatches(shader, view, GL_POINTS);
  }
}

void TerrainPass::setEye(gl::ShaderProgram& shader, const View& view) const {
  const glm::dvec2 eye = glm::dvec2(view.position.x, view.position.z) - base_;
  shader.setVec3("eyeFromBase", glm::vec3(eye.x, view.position.y, eye.y));
}

void TerrainPass::drawPatches(gl::Shader& shader, const View& view, GLenum mode) {
  if (instanceCount_ == 0) return;
  shader.use();
  setEye(shader, view);
  setHeights(shader);
  textures_.bind(kHeightsUnit, kNormalsUnit, kTableUnit);
  patches_.bind();
  const GLsizei indices = mode == GL_POINTS ? kPatchSide * kPatchSide : kPatchIndices;
  context_.drawElementsInstanced(mode, indices, GL_UNSIGNED_SHORT, mode == GL_POINTS ? kPatchIndices : 0,
                                 instanceCount_);
}

void TerrainPass::drawDepth(FrameContext& context) {
  const View& view = context.frame.view;
  if (!*drawn_) *drawn_ = makeLandSurface(context_, view.width, view.height);
  drawn_->resize(view.width, view.height);
  drawn_->bind();
  context_.api().ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  drawMesh(context);
  context_.api().ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  if (const auto* clouds = context.resources.find<CloudShadowMap>()) drawCloudShadows(context, *clouds);
  if (const auto* ice = context.resources.find<IceShade>()) drawIceShade(context, *ice);
  // Their volumes stand around the eye of the scene; so small a shadow is not missed in a mirror.
  const auto* shadows = context.resources.find<CastShadows>();
  if (shadows && !context.frame.isMirrored) drawShadows(context, *shadows);
  drawn_->unBind();
}

// A mirrored eye stands below the land: its underside, which no ray of the mirror meets, is left out.
void TerrainPass::drawMesh(FrameContext& context) {
  const SeaCut cut(context);
  if (context.frame.isMirrored) {
    const std::string define = SeaCut::kDefine;
    context_.api().Enable(GL_CULL_FACE);
    drawPatches(context.shaders.shader("terrain/depth.vert", "terrain/depth.frag", std::span(&define, 1)),
                context.frame.view, GL_TRIANGLES);
    context_.api().Disable(GL_CULL_FACE);
  } else {
    drawPatches(context.shaders.shader("terrain/depth.vert", "terrain/depth.frag"), context.frame.view,
                GL_TRIANGLES);
  }
}

// Before the land is lit, so that it is lit once, and only pixels that may be in shadow ask for shadows:
// those where the inner faces of a shadow's volume lie behind the land. What the shadows leave is multiplied.
void TerrainPass::drawShadows(FrameContext& context, const CastShadows& shadows) {
  const gl::Functions& api = context_.api();
  gl::Shader& shader = context.shaders.shader("shadow/volume.vert", "terrain/sun_share.frag");
  shader.use();
  setSurface(shader, context.frame.view);
  api.Enable(GL_CULL_FACE);
  api.CullFace(GL_FRONT);
  api.DepthFunc(GL_LEQUAL);
  api.DepthMask(GL_FALSE);
  api.Enable(GL_BLEND);
  api.BlendFunc(GL_ZERO, GL_SRC_COLOR);
  api.TextureBarrier();  // the depth is target and texture at once, to be read alone
  shadows.drawVolumes(shader);
  context_.setDefaultState();
}

void TerrainPass::drawCloudShadows(FrameContext& context, const CloudShadowMap& shadowMap) {
  // Both are asked for, so that none is compiled when the sun rises or sets.
  const auto variant = [&](bool hasSun) -> gl::Shader& {
    return context.shaders.shader("fullscreen.vert", "terrain/cloud_share.frag", shadowMap.defines(hasSun));
  };
  if (context.frame.looksAhead()) variant(!shadowMap.hasSun());
  gl::Shader& shader = variant(shadowMap.hasSun());
  shader.use();
  setSurface(shader, context.frame.view);
  shadowMap.bind(shader, context.frame.eyeRiseM());
  drawShares(true);
}

void TerrainPass::drawIceShade(FrameContext& context, const IceShade& ice) {
  gl::Shader& shader = context.shaders.shader("fullscreen.vert", "terrain/ice_share.frag");
  shader.use();
  setSurface(shader, context.frame.view);
  ice.bind(shader, context.frame.view);
  drawShares(false);
}

void TerrainPass::drawShares(bool replaces) {
  const gl::Functions& api = context_.api();
  api.DepthMask(GL_FALSE);
  api.Disable(GL_DEPTH_TEST);
  if (!replaces) {
    api.Enable(GL_BLEND);
    api.BlendFunc(GL_ZERO, GL_SRC_COLOR);
  }
  api.TextureBarrier();  // the depth is target and texture at once, to be read alone
  triangle_.draw();
  context_.setDefaultState();
}

void TerrainPass::setSurface(gl::ShaderProgram& shader, const View& view) const {
  setEye(shader, view);
  const terrain::ChunkKey base = terrain::chunkAt(base_);
  shader.setIvec2("baseChunk", {terrain::wrappedIndex(base.x), terrain::wrappedIndex(base.z)});
  shader.setFloat("farM", static_cast<float>(farDistanceM_));
  textures_.bind(kHeightsUnit, kNormalsUnit, kTableUnit);
  if (!*drawn_) return;
  drawn_->depthTexture().bind(kDepthUnit);
  drawn_->colorTexture().bind(kLightSharesUnit);
}

void TerrainPass::setLand(gl::ShaderProgram& shader, const View& view) const {
  setSurface(shader, view);
  shader.setFloats("chunkSplit", inFloat(lod_.split));
}

void TerrainPass::setGround(gl::ShaderProgram& shader, const View& view) const {
  setLand(shader, view);
  setHeights(shader);
}

void TerrainPass::setSea(gl::ShaderProgram& shader, const View& view) const {
  setSurface(shader, view);
  setHeights(shader);
  shader.setFloat("seaFloorM", static_cast<float>(seaFloorDepthM_));
}

void TerrainPass::setHeights(gl::ShaderProgram& shader) const {
  shader.setVec2("heightRange", glm::vec2(heightRange_.lowest, heightRange_.step()));
  shader.setFloats("lodMorph", inFloat(lod_.morph));
}

// A triangle at infinity, which the depth test lets through where land is before it: a software renderer
// skips what the test rejects, and would work out the land of the sky's pixels with a discard in the program.
void TerrainPass::drawLand(gl::Shader& shader, const View& view) { drawLandUpTo(shader, view, 0); }

// depth: as a triangle there lets through what is nearer.
void TerrainPass::drawLandUpTo(gl::Shader& shader, const View& view, double depth) {
  context_.api().DepthMask(GL_FALSE);
  context_.api().DepthFunc(GL_LESS);
  shader.use();
  shader.setFloat("triangleDepth", static_cast<float>(depth));
  setLand(shader, view);
  if (ground_) ground_->set(shader, base_, worn_);
  triangle_.draw();
  context_.setDefaultState();
}

// Where the land's shade, lamps, flashes, rain and snow on the ground, or strips may come and go, all
// variants are asked for, and those who warm up draw all that they can.
void TerrainPass::drawLitLand(FrameContext& context) {
  const View& view = context.frame.view;
  context_.api().CopyImageSubData(drawn_->depthTexture().id(), GL_TEXTURE_2D, 0, 0, 0, 0,
                                  context.sceneDepth.id(), GL_TEXTURE_2D, 0, 0, 0, 0, view.width, view.height,
                                  1);
  const FrameFeatures& features = context.frame.features;
  const auto* woods = context.resources.find<StandingWoods>();  // in all frames, or in none
  const auto* detail = context.resources.find<GroundDetail>();  // likewise
  const auto* waves = context.resources.find<SeaWaves>();       // the same
  const auto* places = context.resources.find<PlaceMap>();      // and this
  const auto* fallen = context.resources.find<FallenWater>();
  const auto* spot = context.resources.find<SpotLight>();
  const auto* flash = context.resources.find<FlashLight>();
  const auto* shade = context.resources.find<LandShadowMap>();
  struct Part {
    const char* define;
    bool isThere, mayCome;
    std::function<void(gl::Shader&)> set;
  };
  const std::array<Part, 5> parts{
      {{LandShadowMap::kDefine, shade != nullptr, features.landShadows,
        [&](gl::Shader& shader) {
          shade->bind(shader, {view.position.x, view.position.z});
        }},
       {FallenWater::kDefine, fallen != nullptr, features.fallenWater,
        [&](gl::Shader& shader) { fallen->set(shader); }},
       {SpotLight::kDefine, spot != nullptr, features.spotLight,
        [&](gl::Shader& shader) { spot->set(shader, view); }},
       {FlashLight::kDefine, flash != nullptr, features.flashLight,
        [&](gl::Shader& shader) { flash->set(shader); }},
       {kStripDefine, isStripSeen(view), hasStrips_, [&](gl::Shader& shader) { setStrip(shader); }}}};

  // Plain land that is too far away to show trees and detail is drawn without them; where little may be near,
  // that is drawn a second time with them. All of it twice would cost more than it saves.
  const bool isPlain = context.settings.landDetail != LandDetail::rich;
  const bool mayBeFar = isPlain && (woods || detail);
  const double reachM =
      std::max(woods ? woods->farM : 0, detail ? detail->plainReachM(view.pixelAngleRad()) : 0);
  const bool isNear = !mayBeFar || nearestM_ < reachM;
  const bool isFar = mayBeFar && nearestM_ > 0.5 * reachM;
  const double nearDepth = isFar ? view.nearM / reachM : 0;

  std::vector<std::string> always = landDefines(context);
  if (hasAlpineBelts_) always.emplace_back("ALPINE_BELTS");
  if (ground_) always.emplace_back(GroundTexture::kDefine);
  std::vector<std::string> nearby;
  if (woods) nearby.emplace_back(StandingWoods::kDefine);
  if (detail) nearby.emplace_back(GroundDetail::kDefine);
  if (waves) always.emplace_back(SeaWaves::kDefine);
  if (places) always.emplace_back(PlaceMap::kDefine);
  for (unsigned variant = 0; variant < 2u << parts.size(); ++variant) {
    const bool hasNear = variant >> parts.size() != 0;  // later: over the others
    if (!hasNear && !mayBeFar) continue;
    const auto has = [variant](std::size_t part) { return (variant >> part & 1) != 0; };
    bool isAsked = context.frame.looksAhead(), isThis = hasNear ? isNear : isFar, isPossible = true;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      isAsked = isAsked && (parts[i].mayCome || has(i) == parts[i].isThere);
      isThis = isThis && has(i) == parts[i].isThere;
      isPossible = isPossible && (parts[i].isThere || !has(i));
    }
    if (!isAsked && !isThis) continue;
    std::vector<std::string> defines = always;
    if (hasNear) defines.insert(defines.end(), nearby.begin(), nearby.end());
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (has(i)) defines.emplace_back(parts[i].define);
    gl::Shader& shader = context.shaders.shader("fullscreen.vert", "terrain/land.frag", defines);
    if (!isThis && !(isPossible && context.frame.warmsUp)) continue;
    if (woods && hasNear) woods->set(shader);
    if (detail && hasNear) detail->set(shader);
    if (waves) waves->set(shader);
    if (places) places->set(shader, base_);
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (has(i)) parts[i].set(shader);
    drawLandUpTo(shader, view, hasNear ? nearDepth : 0);
  }
}

bool TerrainPass::isStripSeen(const View& view) const {
  if (!strip_) return false;
  const glm::dvec3 middle(strip_->middle.x, strip_->height, strip_->middle.y);
  const double radius = std::hypot(strip_->halfLength, strip_->halfWidth) + core::shared::f64::kStripReachM;
  return isPotentiallyVisible(view, middle, radius);
}

void TerrainPass::setStrip(gl::Shader& shader) const {
  const glm::dvec2 middle = strip_->middle - base_;
  shader.setVec4("stripFrame", glm::vec4(middle.x, middle.y, strip_->along.x, strip_->along.y));
  shader.setVec2("stripHalf", glm::vec2(strip_->halfLength, strip_->halfWidth));
}

// Separate from the land, so that only pixels that show water pay for it: a software renderer runs both sides
// of a branch, but skips what the depth test rejects.
void TerrainPass::drawSea(FrameContext& context) {
  const auto* flash = context.resources.find<FlashLight>();
  const auto* shade = context.resources.find<LandShadowMap>();
  const auto* waves = context.resources.find<SeaWaves>();
  const View& view = context.frame.view;
  const FrameFeatures& features = context.frame.features;
  for (const bool hasShade : {false, true}) {
    for (const bool hasFlash : {false, true}) {
      const bool isThis = hasFlash == (flash != nullptr) && hasShade == (shade != nullptr);
      const bool mayCome = context.frame.looksAhead() &&
                           (features.flashLight || hasFlash == (flash != nullptr)) &&
                           (features.landShadows || hasShade == (shade != nullptr));
      if (!isThis && !mayCome) continue;
      std::vector<std::string> defines(context.defines.begin(), context.defines.end());
      if (hasShade) defines.emplace_back(LandShadowMap::kDefine);
      if (hasFlash) defines.emplace_back(FlashLight::kDefine);
      if (waves) defines.emplace_back(SeaWaves::kDefine);
      if (waves && waves->mirror) defines.emplace_back(SeaWaves::kKeepsDefine);
      gl::Shader& shader = context.shaders.shader("terrain/sea.vert", "terrain/sea.frag", defines);
      const bool isPossible = (flash || !hasFlash) && (shade || !hasShade);
      if (!isThis && !(isPossible && context.frame.warmsUp)) continue;
      if (hasShade) shade->bind(shader, {view.position.x, view.position.z});
      if (hasFlash) flash->set(shader);
      shader.use();
      if (waves) {
        waves->set(shader);
        setSea(shader, view);
        if (waves->mirror) waves->mirror->bindImage(kMirrorImage, GL_WRITE_ONLY);
      } else {
        setSurface(shader, view);
        shader.setFloat("seaFloorM", static_cast<float>(seaFloorDepthM_));
      }
      context_.api().Enable(GL_BLEND);
      context_.api().BlendFunc(GL_ONE, GL_SRC1_COLOR);
      seaPlane_.bind();
      context_.drawArrays(GL_TRIANGLES, 0, kSeaVertices);
      context_.api().Disable(GL_BLEND);
    }
  }
}

void TerrainPass::drawLines(FrameContext& context) {
  context_.api().PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  gl::Shader& shader = context.shaders.shader("terrain/depth.vert", "terrain/line.frag");
  shader.setVec3("lineAlbedo", {0.25f, 0.4f, 0.2f});
  drawPatches(shader, context.frame.view, GL_TRIANGLES);
  context_.api().PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

}  // namespace skydrop::render
