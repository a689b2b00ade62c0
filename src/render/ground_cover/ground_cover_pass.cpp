#include "skydrop/render/ground_cover/ground_cover_pass.h"

#include <algorithm>
#include <cmath>

#include "render/clouds/placing_shader.h"
#include "render/ground_cover/cover_meshes.h"
#include "render/ground_cover/cover_tiles.h"
#include "skydrop/game/snapshot.h"
#include "skydrop/render/frame/sea_cut.h"
#include "skydrop/terrain/strips.h"

namespace skydrop::render {
namespace {

namespace shared = core::shared::f64;

constexpr std::size_t kCellsInTile = kCoverTileCells * kCoverTileCells;
constexpr double kAroundStripM = 1.5;  // no plant stands nearer to what is mown
constexpr double kStripReachM = 2500;  // no strip reaches farther from its middle
constexpr double kFineShare = 0.5;     // of the reach of the finest lattice, up to which blades are fine
constexpr double kLowestM = -0.7;      // reeds stand no deeper

struct Instance {
  std::array<glm::vec4, 9> rows;  // as in shaders/ground_cover/instance.glsl
};

struct Command {
  GLuint count = 0, instanceCount = 0, firstIndex = 0;
  GLint baseVertex = 0;
  GLuint baseInstance = 0;
};

static_assert(kCoverLists == GroundCoverPass::kLists);

}  // namespace

GroundCoverPass::GroundCoverPass(gl::Context& context, std::shared_ptr<const terrain::HeightSource> ground,
                                 const GroundCoverSettings& settings)
    : context_(context), ground_(std::move(ground)), settings_(settings), cover_(context, "ground cover") {
  std::vector<glm::vec4> vertices;
  std::vector<std::uint16_t> indices;
  std::size_t list = 0;
  for (const CoverMesh& mesh : makeCoverMeshes()) {
    meshes_[list++] = {static_cast<GLuint>(mesh.indices.size()), static_cast<GLuint>(indices.size()),
                       static_cast<GLint>(vertices.size())};
    vertices.insert(vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    indices.insert(indices.end(), mesh.indices.begin(), mesh.indices.end());
  }
  vertices_ = gl::Buffer::of<glm::vec4>(context, vertices, gl::Buffer::Use::fixed, "ground cover vertices");
  indices_ = gl::Buffer::of<std::uint16_t>(context, indices, gl::Buffer::Use::fixed, "ground cover indices");
  commands_ = gl::Buffer(context, kLists * sizeof(Command), gl::Buffer::Use::write, "ground cover commands");
  cover_.setVertexBuffer(0, vertices_, 0, sizeof(glm::vec4));
  cover_.setAttribute(0, 0, 4, GL_FLOAT, 0);
  cover_.setIndexBuffer(indices_);
}

std::optional<std::string> GroundCoverPass::skipReason(const FrameInput& frame) const {
  if (frame.warmsUp) return std::nullopt;
  if (settings_.density <= 0 || settings_.reachM <= 0) return "nothing is to stand on the ground";
  const glm::dvec2 eye(frame.view.position.x, frame.view.position.z);
  const terrain::HeightBounds near = ground_->bounds(eye - settings_.reachM, eye + settings_.reachM);
  if (frame.view.position.y - near.highest > settings_.reachM) return "the ground is too far below";
  if (near.highest < kLowestM) return "there is deep water alone near by";
  return std::nullopt;
}

std::optional<std::string> GroundCoverPass::skipReasonAfter(const FrameInput&,
                                                            const FrameResources& resources) const {
  if (!resources.find<LandGround>()) return "no land has been drawn";
  return std::nullopt;
}

void GroundCoverPass::draw(FrameContext& context) {
  const LandGround& land = context.resources.get<LandGround>();
  const CoverReaches reaches = coverReaches(settings_.reachM, settings_.density);
  const std::vector<glm::ivec4> tiles = coverTiles(context.frame.view, land.base(), *ground_, reaches);
  makeRoom(std::max(tiles.size(), mostCoverTiles(reaches)));
  if (!tiles.empty()) tiles_.write(0, std::as_bytes(std::span(tiles)));
  gl::Shader& tufts =
      context.shaders.shader("ground_cover/tuft.vert", "ground_cover/plant.frag", context.meshDefines);
  gl::Shader& plants =
      context.shaders.shader("ground_cover/plant.vert", "ground_cover/plant.frag", context.meshDefines);
  gl::Shader& farStones = context.shaders.shader("ground_cover/far_stone.vert", "ground_cover/far_stone.frag",
                                                 context.meshDefines);
  gl::Shader& stones =
      context.shaders.shader("ground_cover/stone.vert", "ground_cover/stone.frag", context.meshDefines);
  place(context, land, tiles.size());
  if (tiles.empty() && !context.frame.warmsUp) return;
  const SeaCut cut(context);
  cover_.bind();
  const auto drawLists = [&](gl::Shader& shader, std::size_t first, std::size_t last) {
    shader.use();
    context_.drawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, commands_, first * sizeof(Command),
                                  static_cast<GLsizei>(last - first), sizeof(Command));
  };
  drawLists(tufts, 0, kTuftLists);
  drawLists(plants, kTuftLists, kPlantLists);
  drawLists(farStones, kPlantLists, kSmallLists);
  drawLists(stones, kSmallLists, kLists);
}

// A cell has one thing at most, so no list can run over. The room is that of all squares within reach,
// whatever the view shows of them: it does not depend on where one has looked before.
void GroundCoverPass::makeRoom(std::size_t tiles) {
  if (!tiles_ || tiles * sizeof(glm::ivec4) > tiles_.size())
    tiles_ = gl::Buffer(context_, tiles * sizeof(glm::ivec4), gl::Buffer::Use::write, "ground cover squares");
  if (instances_ && tiles * kCellsInTile <= room_) return;
  room_ = tiles * kCellsInTile;
  instances_ = gl::Buffer(context_, room_ * sizeof(Instance), gl::Buffer::Use::fixed, "ground cover");
  lists_ =
      gl::Buffer(context_, kLists * room_ * sizeof(GLuint), gl::Buffer::Use::fixed, "ground cover lists");
  cover_.setVertexBuffer(1, lists_, 0, sizeof(GLuint), 1);
  cover_.setIntegerAttribute(1, 1, 1, GL_UNSIGNED_INT, 0);
}

void GroundCoverPass::place(FrameContext& context, const LandGround& land, std::size_t tiles) {
  gl::ComputeShader& shader = placingShader(context, land, "ground_cover/place.comp");
  std::array<Command, kLists> commands{};
  for (std::size_t i = 0; i < kLists; ++i) {
    commands[i] = {meshes_[i].indices, 0, meshes_[i].firstIndex, meshes_[i].baseVertex,
                   static_cast<GLuint>(i * room_)};
  }
  commands_.write(0, std::as_bytes(std::span(commands)));
  if (tiles == 0) return;
  const View& view = context.frame.view;
  const CoverReaches reaches = coverReaches(settings_.reachM, settings_.density);
  shader.setVec4("coverReaches", glm::vec4(glm::dvec4(reaches[0], reaches[1], reaches[2], reaches[3])));
  shader.setFloat("coverFineM", static_cast<float>(std::max(kFineShare * reaches[0], 1e-3)));
  const glm::dvec3 wind = context.frame.game ? context.frame.game->wind : glm::dvec3(0);
  shader.setVec4("coverWind", glm::vec4(wind.x, wind.z, settings_.sway, 0));
  const terrain::Strips* strips = ground_->strips();
  const auto strip =
      strips ? strips->nearest({view.position.x, view.position.z}, settings_.reachM + kStripReachM)
             : std::nullopt;
  shader.setVec4("mownFrame", strip
                                  ? glm::vec4(glm::vec2(strip->middle - land.base()), glm::vec2(strip->along))
                                  : glm::vec4(0, 0, 1, 0));
  shader.setVec2("mownHalf", strip
                                 ? glm::vec2(glm::dvec2(strip->halfLength, strip->halfWidth) + kAroundStripM)
                                 : glm::vec2(-1));
  tiles_.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
  instances_.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
  commands_.bindBase(GL_SHADER_STORAGE_BUFFER, 2);
  lists_.bindBase(GL_SHADER_STORAGE_BUFFER, 3);
  shader.dispatch(static_cast<GLuint>(tiles), 1);
  context_.api().MemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                               GL_COMMAND_BARRIER_BIT);
}

std::array<std::uint32_t, GroundCoverPass::kLists> GroundCoverPass::drawn() const {
  std::array<Command, kLists> commands{};
  context_.api().MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  commands_.read(0, std::as_writable_bytes(std::span(commands)));
  std::array<std::uint32_t, kLists> counts{};
  for (std::size_t i = 0; i < kLists; ++i) counts[i] = commands[i].instanceCount;
  return counts;
}

std::vector<glm::vec4> GroundCoverPass::feet(std::size_t list) const {
  std::vector<GLuint> numbers(drawn()[list]);
  if (numbers.empty()) return {};
  lists_.read(list * room_ * sizeof(GLuint), std::as_writable_bytes(std::span(numbers)));
  std::vector<Instance> all(room_);
  instances_.read(0, std::as_writable_bytes(std::span(all)));
  std::vector<glm::vec4> feet;
  for (const GLuint number : numbers) feet.push_back(all[number].rows[0]);
  return feet;
}

}  // namespace skydrop::render
