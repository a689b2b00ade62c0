#include "skydrop/render/vegetation/vegetation_pass.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render/clouds/placing_shader.h"
#include "render/vegetation/tree_meshes.h"
#include "render/vegetation/tree_tiles.h"
#include "skydrop/core/shared_woods.h"
#include "skydrop/game/snapshot.h"
#include "skydrop/render/frame/sea_cut.h"

namespace skydrop::render {
namespace {

constexpr int kLists = 4;  // meshes of the three kinds, impostors: as in shaders/vegetation/instance.glsl
constexpr int kImpostors = 3;
constexpr std::size_t kTreesInTile = kTileCells * kTileCells;
constexpr std::size_t kMostClearings = 4;  // as in shaders/vegetation/place.glsl
constexpr GLuint kAtlasUnit = 6;           // as in shaders/vegetation/impostor_look.glsl
constexpr double kMeshBand = 0.75,
                 kFarBand = 0.7;  // of a distance, where a form begins to turn into the next

struct Instance {
  glm::vec4 foot, form, sun, above, below, air, bend;  // as in shaders/vegetation/instance.glsl
};

struct Command {
  GLuint count = 0, instanceCount = 0, firstIndex = 0;
  GLint baseVertex = 0;
  GLuint baseInstance = 0;
};

// Meshes, impostors: where they begin to give way and where they end, m.
glm::dvec4 reachOf(const VegetationSettings& s) {
  const double mesh = std::min(s.meshM, kFarBand * s.farM);
  return {kMeshBand * mesh, std::max(mesh, 1e-3), kFarBand * s.farM, std::max(s.farM, 2e-3)};
}

// Most tiles that a square around the eye touches which reaches so far, m.
std::size_t tilesWithin(double reachM) {
  const auto side = static_cast<std::size_t>(2 * std::ceil(reachM / kTileM) + 2);
  return side * side;
}

}  // namespace

void WoodFloorPass::draw(FrameContext& context) {
  const glm::dvec4 reach = reachOf(settings_);
  woods_ = {reach.z, reach.w, std::min(settings_.shadowM, settings_.farM), settings_.shadow, density_};
  context.resources.publish(woods_);
}

VegetationPass::VegetationPass(gl::Context& context, std::shared_ptr<const terrain::Woods> woods,
                               const VegetationSettings& settings)
    : context_(context), woods_(std::move(woods)), settings_(settings), trees_(context, "trees") {
  std::vector<TreeVertex> vertices;
  std::vector<std::uint16_t> indices;
  std::size_t kind = 0;
  for (const TreeMesh& mesh : makeTreeMeshes()) {
    kinds_[kind++] = {static_cast<GLsizei>(mesh.indices.size()), static_cast<GLuint>(indices.size()),
                      static_cast<GLint>(vertices.size()), mesh.slender, mesh.reach};
    vertices.insert(vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    indices.insert(indices.end(), mesh.indices.begin(), mesh.indices.end());
  }
  firstQuadIndex_ = static_cast<GLuint>(indices.size());
  for (const int i : {0, 1, 2, 2, 1, 3}) indices.push_back(static_cast<std::uint16_t>(i));
  vertices_ = gl::Buffer::of<TreeVertex>(context, vertices, gl::Buffer::Use::fixed, "tree vertices");
  indices_ = gl::Buffer::of<std::uint16_t>(context, indices, gl::Buffer::Use::fixed, "tree indices");
  commands_ = gl::Buffer(context, kLists * sizeof(Command), gl::Buffer::Use::write, "tree commands");
  trees_.setVertexBuffer(0, vertices_, 0, sizeof(TreeVertex));
  trees_.setAttribute(0, 0, 3, GL_FLOAT, 0);
  trees_.setAttribute(1, 0, 3, GL_FLOAT, sizeof(glm::vec3));
  trees_.setAttribute(2, 0, 2, GL_FLOAT, 2 * sizeof(glm::vec3));
  trees_.setIndexBuffer(indices_);
}

void VegetationPass::apply(std::shared_ptr<const terrain::Woods> woods, const VegetationSettings& settings) {
  const bool isAnotherAtlas =
      settings.atlasTexels != settings_.atlasTexels || settings.atlasViews != settings_.atlasViews;
  if (isAnotherAtlas) atlas_ = {};
  woods_ = std::move(woods);
  settings_ = settings;
}

std::optional<std::string> VegetationPass::skipReason(const FrameInput& frame) const {
  if (frame.warmsUp) return std::nullopt;
  if (settings_.farM <= 0) return "trees are painted alone";
  if (woods_->density() <= 0) return "no trees stand";
  const double over = frame.view.position.y - woods_->ground().range().highest - terrain::kTallestTreeM;
  if (over > settings_.farM) return "the view is too high for single trees";
  return std::nullopt;
}

std::optional<std::string> VegetationPass::skipReasonAfter(const FrameInput&,
                                                           const FrameResources& resources) const {
  if (!resources.find<LandGround>()) return "no land has been drawn";
  return std::nullopt;
}

void VegetationPass::draw(FrameContext& context) {
  const LandGround& land = context.resources.get<LandGround>();
  // Asked for in every frame: a program that frames need now and then counts as used.
  context.shaders.shader("vegetation/impostor_bake.vert", "vegetation/impostor_bake.frag");
  if (!atlas_) bakeAtlas(context);
  const glm::dvec4 reach = reachOf(settings_);
  const TreeTiles tiles = treeTiles(context.frame.view, land.base(), woods_->ground(), reach.y, reach.w);
  makeRoom(tiles.corners.size(), tiles.near);
  if (!tiles.corners.empty()) tiles_.write(0, std::as_bytes(std::span(tiles.corners)));
  place(context, land, tiles.corners.size());
  const SeaCut cut(context);
  drawMeshes(context);
  drawImpostors(context);
}

// A cell has one tree at most, so no list can run over. The room is that of all tiles within reach, whatever
// the view shows of them: it does not depend on where one has looked before.
void VegetationPass::makeRoom(std::size_t tiles, std::size_t nearTiles) {
  const glm::dvec4 reach = reachOf(settings_);
  const std::size_t wanted = std::max(tiles, tilesWithin(reach.w));
  const std::size_t mesh = std::max(nearTiles, tilesWithin(reach.y)) * kTreesInTile;
  const std::size_t impostor = wanted * kTreesInTile;
  if (!tiles_ || wanted * sizeof(glm::ivec2) > tiles_.size())
    tiles_ = gl::Buffer(context_, wanted * sizeof(glm::ivec2), gl::Buffer::Use::write, "tree tiles");
  if (instances_ && mesh <= meshRoom_ && impostor <= impostorRoom_) return;
  meshRoom_ = std::max(mesh, meshRoom_);
  impostorRoom_ = std::max(impostor, impostorRoom_);
  instances_ = gl::Buffer(context_, (3 * meshRoom_ + impostorRoom_) * sizeof(Instance),
                          gl::Buffer::Use::fixed, "trees");
  trees_.setVertexBuffer(1, instances_, 0, sizeof(Instance), 1);
  for (GLuint i = 0; i < 7; ++i) trees_.setAttribute(3 + i, 1, 4, GL_FLOAT, i * sizeof(glm::vec4));
}

void VegetationPass::place(FrameContext& context, const LandGround& land, std::size_t tiles) {
  gl::ComputeShader& shader = placingShader(context, land, "vegetation/place.comp");
  std::array<Command, kLists> commands{};
  for (std::size_t i = 0; i < kinds_.size(); ++i) {
    commands[i] = {static_cast<GLuint>(kinds_[i].indices), 0, kinds_[i].firstIndex, kinds_[i].baseVertex,
                   static_cast<GLuint>(i * meshRoom_)};
  }
  commands[kImpostors] = {6, 0, firstQuadIndex_, 0, static_cast<GLuint>(3 * meshRoom_)};
  commands_.write(0, std::as_bytes(std::span(commands)));
  if (tiles == 0) return;
  const View& view = context.frame.view;
  const glm::vec4 reach(reachOf(settings_));
  shader.setVec4("treeReach", reach);
  const glm::dvec3 wind = context.frame.game ? context.frame.game->wind : glm::dvec3(0);
  shader.setVec4("treeWind", glm::vec4(wind.x, wind.z, settings_.sway, 0));
  shader.setFloat("treeDensity", static_cast<float>(woods_->density()));
  std::array<glm::vec4, 2 * kMostClearings> clearings{};
  std::size_t count = 0;
  for (const terrain::Strip& strip : woods_->clearings({view.position.x, view.position.z}, settings_.farM)) {
    if (count == kMostClearings) break;
    clearings[2 * count] = glm::vec4(glm::vec2(strip.middle - land.base()), glm::vec2(strip.along));
    clearings[2 * count + 1] = glm::vec4(strip.halfLength + terrain::kClearBeforeStripM,
                                         strip.halfWidth + terrain::kClearBesideStripM, 0, 0);
    ++count;
  }
  shader.setVec4s("clearings", clearings);
  shader.setInt("clearingCount", static_cast<int>(count));
  tiles_.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
  instances_.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
  commands_.bindBase(GL_SHADER_STORAGE_BUFFER, 2);
  shader.dispatch(static_cast<GLuint>(tiles), 1);
  context_.api().MemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
}

void VegetationPass::drawMeshes(FrameContext& context) {
  gl::Shader& shader =
      context.shaders.shader("vegetation/tree.vert", "vegetation/tree.frag", context.meshDefines);
  shader.use();
  trees_.bind();
  context_.drawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, commands_, 0, kImpostors, sizeof(Command));
}

void VegetationPass::drawImpostors(FrameContext& context) {
  gl::Shader& shader =
      context.shaders.shader("vegetation/impostor.vert", "vegetation/impostor.frag", context.meshDefines);
  shader.use();
  std::array<glm::vec4, 3> shapes{};
  for (std::size_t i = 0; i < kinds_.size(); ++i) shapes[i] = {kinds_[i].slender, kinds_[i].reach, 0, 0};
  shader.setVec4s("impostorShapes", shapes);
  shader.setFloat("impostorViews", static_cast<float>(settings_.atlasViews));
  atlas_.bind(kAtlasUnit);
  trees_.bind();
  context_.drawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, commands_, kImpostors * sizeof(Command), 1,
                                sizeof(Command));
}

// All views of all kinds, a row of views above the other and a kind above the other.
void VegetationPass::bakeAtlas(FrameContext& context) {
  namespace shared = core::shared::f32;
  const auto texels = static_cast<GLsizei>(settings_.atlasTexels);
  const auto views = static_cast<GLsizei>(settings_.atlasViews);
  constexpr GLsizei kLevels = 4;  // smaller ones would mix neighbouring views
  atlas_ = gl::Texture::make2D(context_, GL_RGBA8, texels * views, 3 * texels * views, "tree atlas", kLevels);
  atlas_.setFilter(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
  const gl::Texture depth = gl::Texture::make2D(context_, GL_DEPTH_COMPONENT32F, texels * views,
                                                3 * texels * views, "depth of the tree atlas");
  gl::FrameBuffer target(context_, &atlas_, &depth, "tree atlas");
  target.bind();
  gl::Shader& shader =
      context.shaders.shader("vegetation/impostor_bake.vert", "vegetation/impostor_bake.frag");
  shader.use();
  trees_.bind();
  for (int kind = 0; kind < 3; ++kind) {
    const Kind& of = kinds_[static_cast<std::size_t>(kind)];
    shader.setVec4("bakeShape", {of.slender, of.reach, kind, 0});
    for (int row = 0; row < views; ++row) {
      for (int column = 0; column < views; ++column) {
        const glm::vec2 square = glm::vec2(column, row) / static_cast<float>(views - 1);
        const glm::vec3 towards = shared::directionOfHemiOct(square);
        const glm::vec3 level(-towards.z, 0, towards.x);
        const glm::vec3 right = glm::length(level) > 1e-4f ? glm::normalize(level) : glm::vec3(1, 0, 0);
        glm::vec3 up = glm::cross(towards, right);
        if (up.y < 0) up = -up;
        shader.setVec3("bakeTowards", towards);
        shader.setVec3("bakeRight", right);
        shader.setVec3("bakeUp", up);
        context_.api().Viewport(column * texels, (kind * views + row) * texels, texels, texels);
        context_.drawElements(GL_TRIANGLES, of.indices, GL_UNSIGNED_SHORT, of.firstIndex, of.baseVertex);
      }
    }
  }
  target.unBind();
  atlas_.generateMipmaps();
}

std::array<std::uint32_t, 4> VegetationPass::drawn() const {
  std::array<Command, kLists> commands{};
  context_.api().MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  commands_.read(0, std::as_writable_bytes(std::span(commands)));
  return {commands[0].instanceCount, commands[1].instanceCount, commands[2].instanceCount,
          commands[3].instanceCount};
}

std::vector<glm::vec4> VegetationPass::feet(int list) const {
  const std::uint32_t count = drawn()[static_cast<std::size_t>(list)];
  std::vector<Instance> read(count);
  if (count > 0)
    instances_.read(static_cast<std::size_t>(list) * meshRoom_ * sizeof(Instance),
                    std::as_writable_bytes(std::span(read)));
  std::vector<glm::vec4> feet;
  for (const Instance& tree : read) feet.push_back(tree.foot);
  return feet;
}

}  // namespace skydrop::render
