#include "skydrop/render/places/places_pass.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>

#include "render/clouds/placing_shader.h"
#include "render/places/place_map_data.h"
#include "render/places/place_meshes.h"
#include "skydrop/render/frame/sea_cut.h"

namespace skydrop::render {
namespace {

constexpr int kLists = 2;  // buildings, hedges: as in shaders/places/instance.glsl
constexpr std::size_t kHedgeRoom = 8192;
constexpr GLuint kGroup = 32;  // invocations, as in shaders/places/place_houses.comp
constexpr GLuint kBlocks = core::shared::f64::kFieldBlocks * core::shared::f64::kFieldBlocks;
constexpr double kFieldsReachM = 720;  // of a village, from its middle
constexpr double kFadeBand = 0.75;     // of a distance, where what is drawn begins to fade

// Windows: a room's lamps of 2700 K behind curtains, brighter than they are, as an eye at dusk sees them; lit
// from where the sun is 2 degrees up to 5 below.
constexpr double kWindowLight = 0.25;  // kcd/m^2
constexpr glm::dvec3 kWindowColor{1.9, 0.92, 0.26};
constexpr double kBrightestWindow = 3.0;
constexpr double kDuskSine = 0.035, kNightSine = -0.09;

struct Instance {
  glm::vec4 foot, form, turn, sun, above, below, air;  // as in shaders/places/instance.glsl
};

struct Command {
  GLuint count = 0, instanceCount = 0, firstIndex = 0;
  GLint baseVertex = 0;
  GLuint baseInstance = 0;
};

}  // namespace

WindowsLit windowsLit(const PlacesViewSettings& settings, double sunSine, double exposure) {
  const double dark = std::clamp((kDuskSine - sunSine) / (kDuskSine - kNightSine), 0.0, 1.0);
  const double seen = kWindowLight * settings.light * exposure;
  return {settings.windows * dark, kWindowColor * (seen / (1 + seen / kBrightestWindow))};
}

PlacesPass::PlacesPass(gl::Context& context, const PlaceMapPass& map, const PlacesViewSettings& settings)
    : context_(context),
      map_(map),
      settings_(settings),
      houses_(context, "houses"),
      hedges_(context, "hedges") {
  const PlaceMesh house = makeHouseMesh(), hedge = makeHedgeMesh();
  std::vector<std::uint16_t> indices = house.indices;
  indices.insert(indices.end(), hedge.indices.begin(), hedge.indices.end());
  houseIndices_ = static_cast<GLsizei>(house.indices.size());
  hedgeIndices_ = static_cast<GLsizei>(hedge.indices.size());
  houseVertices_ =
      gl::Buffer::of<PlaceVertex>(context, house.vertices, gl::Buffer::Use::fixed, "house vertices");
  hedgeVertices_ =
      gl::Buffer::of<PlaceVertex>(context, hedge.vertices, gl::Buffer::Use::fixed, "hedge vertices");
  indices_ = gl::Buffer::of<std::uint16_t>(context, indices, gl::Buffer::Use::fixed, "house indices");
  commands_ = gl::Buffer(context, kLists * sizeof(Command), gl::Buffer::Use::write, "house commands");
  for (gl::VertexArray* array : {&houses_, &hedges_}) {
    array->setVertexBuffer(0, array == &houses_ ? houseVertices_ : hedgeVertices_, 0, sizeof(PlaceVertex));
    array->setAttribute(0, 0, 4, GL_FLOAT, 0);
    array->setAttribute(1, 0, 4, GL_FLOAT, sizeof(glm::vec4));
    array->setIndexBuffer(indices_);
  }
}

std::optional<std::string> PlacesPass::skipReason(const FrameInput& frame) const {
  if (frame.warmsUp) return std::nullopt;
  if (settings_.houseM <= 0 && settings_.hedgeM <= 0) return "villages are painted alone";
  const double over =
      frame.view.position.y - map_.places().ground().range().highest - terrain::kTallestHouseM;
  if (over > std::max(settings_.houseM, settings_.hedgeM)) return "the view is too high for houses";
  return std::nullopt;
}

std::optional<std::string> PlacesPass::skipReasonAfter(const FrameInput& frame,
                                                       const FrameResources& resources) const {
  if (!resources.find<LandGround>()) return "no land has been drawn";
  if (!frame.warmsUp && map_.villages().empty()) return "no village is near";
  return std::nullopt;
}

gl::ComputeShader& PlacesPass::placing(FrameContext& context, const LandGround& land,
                                       const char* file) const {
  gl::ComputeShader& shader = placingShader(context, land, file);
  shader.setVec4("placeReach", glm::vec4(kFadeBand * settings_.houseM, std::max(settings_.houseM, 1e-3),
                                         kFadeBand * settings_.hedgeM, std::max(settings_.hedgeM, 1e-3)));
  shader.setVec2("placeRoom", glm::vec2(houseRoom_, kHedgeRoom));
  shader.setFloat(
      "windowShare",
      static_cast<float>(windowsLit(settings_, context.frame.sunSine, context.light.exposure).share));
  instances_.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
  commands_.bindBase(GL_SHADER_STORAGE_BUFFER, 2);
  return shader;
}

void PlacesPass::place(FrameContext& context, const LandGround& land) {
  const std::array<Command, kLists> commands{
      {{static_cast<GLuint>(houseIndices_), 0, 0, 0, 0},
       {static_cast<GLuint>(hedgeIndices_), 0, static_cast<GLuint>(houseIndices_), 0,
        static_cast<GLuint>(houseRoom_)}}};
  commands_.write(0, std::as_bytes(std::span(commands)));
  gl::ComputeShader& houses = placing(context, land, "places/place_houses.comp");
  houses.setInt("partCount", static_cast<int>(map_.partCount()));
  if (map_.partCount() > 0 && settings_.houseM > 0) {
    map_.parts().bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    houses.dispatch((static_cast<GLuint>(map_.partCount()) + kGroup - 1) / kGroup, 1);
  }
  gl::ComputeShader& hedges = placing(context, land, "places/place_hedges.comp");
  const View& view = context.frame.view;
  int village = 0;
  for (const glm::dvec2& middle : map_.villages()) {
    const double away = glm::length(middle - glm::dvec2(view.position.x, view.position.z));
    if (settings_.hedgeM > 0 && away < settings_.hedgeM + kFieldsReachM) {
      hedges.setInt("hedgeVillage", village);
      hedges.dispatch(kBlocks, 1);
    }
    ++village;
  }
  context_.api().MemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
}

void PlacesPass::draw(FrameContext& context) {
  const LandGround& land = context.resources.get<LandGround>();
  const std::size_t room = std::max<std::size_t>(256, map_.partCount());
  if (!instances_ || room > houseRoom_) {
    houseRoom_ = 2 * room;
    instances_ =
        gl::Buffer(context_, (houseRoom_ + kHedgeRoom) * sizeof(Instance), gl::Buffer::Use::fixed, "houses");
    for (gl::VertexArray* array : {&houses_, &hedges_}) {
      array->setVertexBuffer(1, instances_, 0, sizeof(Instance), 1);
      for (GLuint i = 0; i < 7; ++i) array->setAttribute(2 + i, 1, 4, GL_FLOAT, i * sizeof(glm::vec4));
    }
  }
  place(context, land);
  gl::Shader& house = context.shaders.shader("places/house.vert", "places/house.frag", context.meshDefines);
  gl::Shader& hedge = context.shaders.shader("places/hedge.vert", "places/hedge.frag", context.meshDefines);
  house.use();
  house.setVec4("windowLight",
                glm::vec4(windowsLit(settings_, context.frame.sunSine, context.light.exposure).light, 0));
  const SeaCut cut(context);
  context_.api().Enable(GL_CULL_FACE);
  context_.api().CullFace(GL_BACK);
  houses_.bind();
  context_.drawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, commands_, 0, 1, sizeof(Command));
  hedge.use();
  hedges_.bind();
  context_.drawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, commands_, sizeof(Command), 1,
                                sizeof(Command));
  context_.setDefaultState();
}

std::array<std::uint32_t, 2> PlacesPass::drawn() const {
  std::array<Command, kLists> commands{};
  context_.api().MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  commands_.read(0, std::as_writable_bytes(std::span(commands)));
  return {std::min<std::uint32_t>(commands[0].instanceCount, static_cast<std::uint32_t>(houseRoom_)),
          std::min<std::uint32_t>(commands[1].instanceCount, kHedgeRoom)};
}

std::vector<glm::vec4> PlacesPass::feet() const {
  std::vector<Instance> read(drawn()[0]);
  if (!read.empty()) instances_.read(0, std::as_writable_bytes(std::span(read)));
  std::vector<glm::vec4> feet;
  for (const Instance& house : read) feet.push_back(house.foot);
  return feet;
}

}  // namespace skydrop::render
