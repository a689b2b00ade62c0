#include "skydrop/render/clouds/cloud_system.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "render/clouds/cloud_textures.h"
#include "render/clouds/cloud_uniforms.h"
#include "render/clouds/sun_optical_depth_grid.h"
#include "skydrop/clouds/raised_sun.h"
#include "skydrop/core/shared.h"

namespace skydrop::render {
namespace {

constexpr GLuint kNearUnit = 4, kFarUnit = 5, kSceneDepthUnit = 6, kLightUnit = 7,
                 kDistancesUnit = 8;                                          // as in shaders/clouds
constexpr GLuint kTilesBinding = 0, kEdgesBinding = 1, kUnderWayBinding = 2;  // likewise
constexpr int kTileSide = 8;                                                  // rays
constexpr std::size_t kTaskBytes = 16, kEdgeBytes = 4, kHeaderBytes = 16;
constexpr double kNearRadiusCells = 48;  // of the fine light grid
constexpr double kFarCells = 5;          // a cell of the coarse grid in cells of the fine one
// Of rays that are not marched: no light, and a surface like no other,
// because what hides the clouds there may not hide them beside it.
constexpr std::array<float, 4> kNotMarched = {core::shared::f32::kFarDistance, 0, 0, 0};
constexpr double kFineShadowMapM = 60, kFineShadowRadiusM = 6000,
                 kCoarseShadowMapM = 240;  // cells of shadows

struct ListHeader {
  std::array<GLuint, 3> groups{0, 0, 1};
  GLuint count = 0;
};

// The most times that all loops of a ray can run together. A segment with its light is at least so deep, or
// kMaxStepsPerSegment steps long.
double mostIterations(const clouds::CloudSettings& s) {
  const double growthBegins = s.march.stepM / s.march.stepGrowth;
  const double steps =
      growthBegins / s.march.stepM * (1 + std::max(0.0, std::log2(s.fadeDistance / growthBegins)));
  const double segments = steps / core::shared::f64::kMaxStepsPerSegment -
                          std::log(s.march.transmittanceCutoff) / s.march.maxSegmentOpticalDepth;
  return 2 * steps + segments * static_cast<double>(s.march.sunSamples);
}

// Whether one dispatch may not reach the end of a ray.
bool isMultiDispatch(const clouds::CloudSettings& settings) {
  return mostIterations(settings) > core::shared::f64::kMostIterations;
}

// Pixels a side for each ray. Single rays are not carried on, so there are none then.
int divisorOf(const clouds::CloudSettings& settings) {
  return isMultiDispatch(settings) ? 1 : 1 << static_cast<int>(settings.march.resolution);
}

int rays(int pixels, int divisor) { return (pixels + divisor - 1) / divisor; }
int tilesOf(int raysAcross) { return (raysAcross + kTileSide - 1) / kTileSide; }

// Whether no ray of the picture meets the layer before clouds have faded.
bool missesLayer(const View& view, const clouds::CloudLayerSettings& layer, double fadeDistance) {
  const double below = layer.cloudHeight - view.position.y,
               above = view.position.y - layer.cloudHeight - layer.thickness;
  if (below <= 0 && above <= 0) return false;
  const double distance = std::max(below, above);
  if (distance >= fadeDistance) return true;
  // The steepest ray towards the layer: a corner of the picture, or straight up or down where that is in
  // view.
  const glm::dvec3 towards(0, below > 0 ? 1 : -1, 0);
  double steepest = -1;
  for (const double x : {0.0, 1.0}) {
    for (const double y : {0.0, 1.0}) {
      const glm::dvec3 ray = rayDirection(view, {x * view.width, y * view.height});
      steepest = std::max(steepest, glm::dot(ray, towards));
    }
  }
  const glm::dmat3 toView = glm::inverse(rayMatrix(view));
  const glm::dvec3 pole = toView * towards;
  if (pole.z > 0 && std::abs(pole.x) <= pole.z && std::abs(pole.y) <= pole.z) steepest = 1;
  return steepest * fadeDistance <= distance;
}

std::vector<std::string> definesOf(const FrameContext& context, const clouds::CloudSettings& settings) {
  std::vector<std::string> defines(context.defines.begin(), context.defines.end());
  if (settings.march.detail) defines.emplace_back("DETAIL");
  if (settings.march.lightGrid) defines.emplace_back("LIGHT_GRID");
  if (isMultiDispatch(settings)) defines.emplace_back("MULTI_DISPATCH");
  defines.push_back("DIVISOR " + std::to_string(divisorOf(settings)));
  return defines;
}

}  // namespace

CloudSystem::CloudSystem(gl::Context& context, std::shared_ptr<const clouds::PackedCloudNoise> noise,
                         const clouds::CloudSettings& settings, const core::WindSettings& wind)
    : context_(context),
      settings_(settings),
      wind_(wind),
      textures_(std::make_unique<CloudTextures>(context, std::move(noise), settings)),
      near_(std::make_unique<SunOpticalDepthGrid>("near sun optical depth", SunOpticalDepthGridKeeps::all)),
      far_(std::make_unique<SunOpticalDepthGrid>("far sun optical depth", SunOpticalDepthGridKeeps::all)),
      uniforms_(context, sizeof(CloudUniforms), gl::Buffer::Use::write, "cloud uniforms") {
  forgetShadowMap();
}

CloudSystem::~CloudSystem() = default;

void CloudSystem::forgetShadowMap() {
  constexpr auto kBase = SunOpticalDepthGridKeeps::base;
  fineShadowMap_ = std::make_unique<SunOpticalDepthGrid>("fine cloud shadow map", kBase);
  coarseShadowMap_ = std::make_unique<SunOpticalDepthGrid>("coarse cloud shadow map", kBase);
}

void CloudSystem::apply(const clouds::CloudSettings& settings, const core::WindSettings& wind) {
  bool forgetsLight = settings.march.detail != settings_.march.detail;
  for (std::size_t i = 0; i < settings.layers.size(); ++i) {
    if (clouds::isSameField(settings, settings_, i)) continue;
    textures_->rebuild(settings, i);
    forgetsLight = true;
  }
  settings_ = settings;
  wind_ = wind;
  if (!forgetsLight) return;
  for (SunOpticalDepthGrid* grid : {near_.get(), far_.get(), fineShadowMap_.get(), coarseShadowMap_.get()})
    grid->forget();
}

std::optional<std::string> CloudSystem::skipReason(const FrameInput& frame) const {
  if (settings_.tier == clouds::CloudTier::off) return "switched off";
  if (textures_->isEmpty(kMarchedLayer)) return "no cloud anywhere";
  if (missesLayer(frame.view, layer(), settings_.fadeDistance)) return "the layer is out of view";
  return std::nullopt;
}

glm::dvec3 CloudSystem::eyeInField(const FrameInput& frame) const {
  const glm::dvec2 drift = core::windDrift(wind_, frame.simulatedSeconds);
  return frame.view.position - glm::dvec3(drift.x, 0, drift.y);
}

void CloudSystem::resize(const View& view) {
  const int divisor = divisorOf(settings_);
  const int width = rays(view.width, divisor), height = rays(view.height, divisor);
  if (light_ && light_.width() == width && light_.height() == height) return;
  light_ = gl::Texture::make2D(context_, GL_RGBA16F, width, height, "cloud light");
  distances_ = gl::Texture::make2D(context_, GL_RG16F, width, height, "cloud distances");
  const auto tiles = static_cast<std::size_t>(tilesOf(width)) * static_cast<std::size_t>(tilesOf(height));
  tiles_ = gl::Buffer(context_, kHeaderBytes + tiles * kTaskBytes, gl::Buffer::Use::write, "cloud tiles");
  edges_ = {};
  if (divisor == 1) return;
  const std::size_t pixels = static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height);
  edges_ = gl::Buffer(context_, kHeaderBytes + pixels * kEdgeBytes, gl::Buffer::Use::write, "cloud edges");
}

void CloudSystem::update(FrameContext& context, SunOpticalDepthGrid& grid, double cellM, double radiusM,
                         const glm::dvec3& middle) {
  grid.update(context_, context.shaders,
              sunOpticalDepthGridLayout(layer(), clouds::raisedSun(context.light.toSun), cellM,
                                        std::min(radiusM, settings_.fadeDistance), middle, grid.keeps()),
              layer(), settings_, textures_->meanDetail());
}

std::optional<std::string> CloudSystem::shadowSkipReason(const FrameInput& frame) const {
  if (settings_.tier == clouds::CloudTier::off) return "switched off";
  if (textures_->isEmpty(kMarchedLayer)) return "no cloud anywhere";
  if (frame.toSun.y <= 0) return "the sun is below the horizon";
  if (frame.view.position.y > layer().cloudHeight + settings_.fadeDistance) return "the eye is too far above";
  return std::nullopt;
}

CloudShadowMap CloudSystem::shadowMap(FrameContext& context) {
  textures_->bind(kMarchedLayer);
  const glm::dvec3 eye = eyeInField(context.frame);
  // What shades the land around the eye stands where the sun's rays to that land pass the base.
  const glm::dvec3 toSun = clouds::raisedSun(context.light.toSun);
  const glm::dvec3 middle = eye + glm::dvec3(toSun.x, 0, toSun.z) * (layer().cloudHeight / toSun.y);
  const auto map = [&](SunOpticalDepthGrid& grid, double cellM, double radiusM) {
    const double reach = std::min(radiusM, settings_.fadeDistance);
    update(context, grid, cellM, reach, middle);
    const std::array<glm::vec4, 3> rows = toSunOpticalDepthGrid(grid.layout(), eye);
    return CloudShadowMap::Map{&grid.depths(), {rows[0], rows[1]}, reach};
  };
  const CloudShadowMap::Map fine = map(*fineShadowMap_, kFineShadowMapM, kFineShadowRadiusM);
  const CloudShadowMap::Map coarse = map(*coarseShadowMap_, kCoarseShadowMapM, settings_.fadeDistance);
  return {fine, coarse, layer().cloudHeight - context.frame.view.position.y, layer().thickness};
}

void CloudSystem::marchMultiDispatch() {
  const gl::Functions& api = context_.api();
  const int width = light_.width(), height = light_.height();
  if (!rayLight_ || rayLight_.width() != width || rayLight_.height() != height) {
    rayLight_ = gl::Texture::make2D(context_, GL_RGBA32F, width, height, "ray light");
    rayState_ = gl::Texture::make2D(context_, GL_RGBA32F, width, height, "ray state");
  }
  const std::array<float, 4> untouched = {0, 0, 0, 1};
  api.ClearTexImage(rayLight_.id(), 0, GL_RGBA, GL_FLOAT, untouched.data());
  api.ClearTexImage(rayState_.id(), 0, GL_RGBA, GL_FLOAT, untouched.data());
  rayLight_.bindImage(2, GL_READ_WRITE);
  rayState_.bindImage(3, GL_READ_WRITE);
  GLuint underWay = 0;
  gl::Buffer counter(context_, sizeof underWay, gl::Buffer::Use::write, "rays under way");
  counter.bindBase(GL_SHADER_STORAGE_BUFFER, kUnderWayBinding);
  do {
    counter.writeValue(0, GLuint{0});
    context_.dispatchIndirect(0);
    api.MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    counter.read(0, std::as_writable_bytes(std::span(&underWay, 1)));
  } while (underWay > 0);
}

void CloudSystem::draw(FrameContext& context) {
  const std::vector<std::string> defines = definesOf(context, settings_);
  resize(context.frame.view);
  setUniforms(context);
  classify(context, defines);
  march(context, defines);
  compose(context, defines);
  transmittance_ = {&light_, &distances_};
  context.resources.publish(transmittance_);
  context_.api().MemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

// What all shaders of the pass read, light grids included.
void CloudSystem::setUniforms(FrameContext& context) {
  const View& view = context.frame.view;
  const glm::dvec3 eye = eyeInField(context.frame);
  textures_->bind(kMarchedLayer);
  CloudUniforms uniforms = fieldUniforms(layer(), settings_.fadeDistance, eye, textures_->meanDetail());
  addLight(uniforms, layer(), settings_.march, context.light);
  addMarch(uniforms, settings_.march, view, kTileSide * divisorOf(settings_));
  if (settings_.march.lightGrid) {
    const double cell = settings_.march.lightCellM;
    update(context, *near_, cell, kNearRadiusCells * cell, eye);
    update(context, *far_, kFarCells * cell, settings_.fadeDistance, eye);
    uniforms.nearGrid = toSunOpticalDepthGrid(near_->layout(), eye);
    uniforms.farGrid = toSunOpticalDepthGrid(far_->layout(), eye);
    near_->depths().bind(kNearUnit);
    far_->depths().bind(kFarUnit);
  }
  uniforms_.writeValue(0, uniforms);
  uniforms_.bindBase(GL_UNIFORM_BUFFER, kCloudUniformsBinding);
  context.sceneDepth.bind(kSceneDepthUnit);
}

// Lists the tiles to be marched; all other rays see nothing.
void CloudSystem::classify(FrameContext& context, Defines defines) {
  const gl::Functions& api = context_.api();
  const glm::ivec2 tiles(tilesOf(light_.width()), tilesOf(light_.height()));
  tiles_.writeValue(0, ListHeader{});
  tiles_.bindBase(GL_SHADER_STORAGE_BUFFER, kTilesBinding);
  gl::ComputeShader& shader = context.shaders.computeShader("clouds/classify.comp", defines);
  shader.setIvec2("tileCount", tiles);
  shader.dispatch(static_cast<GLuint>(tiles.x + 7) / 8, static_cast<GLuint>(tiles.y + 7) / 8);
  const std::array<float, 4> clear = {0, 0, 0, 1};
  api.ClearTexImage(light_.id(), 0, GL_RGBA, GL_FLOAT, clear.data());
  api.ClearTexImage(distances_.id(), 0, GL_RGBA, GL_FLOAT, kNotMarched.data());
  api.MemoryBarrier(GL_COMMAND_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
}

void CloudSystem::march(FrameContext& context, Defines defines) {
  gl::ComputeShader& shader = context.shaders.computeShader("clouds/march.comp", defines);
  shader.use();
  shader.setInt("sunSamples", static_cast<int>(settings_.march.sunSamples));
  light_.bindImage(0, GL_WRITE_ONLY);
  distances_.bindImage(1, GL_WRITE_ONLY);
  tiles_.bind(GL_DISPATCH_INDIRECT_BUFFER);
  if (isMultiDispatch(settings_))
    marchMultiDispatch();
  else
    context_.dispatchIndirect(0);
  context_.api().MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

// Lays what was marched over the scene; pixels that this does not tell enough of are marched by themselves.
void CloudSystem::compose(FrameContext& context, Defines defines) {
  const bool hasEdges = divisorOf(settings_) > 1;
  if (hasEdges) {
    edges_.writeValue(0, ListHeader{});
    edges_.bindBase(GL_SHADER_STORAGE_BUFFER, kEdgesBinding);
  }
  context.shaders.computeShader("clouds/compose.comp", defines).use();
  context.sceneColor.bindImage(0, GL_READ_WRITE);
  light_.bind(kLightUnit);
  distances_.bind(kDistancesUnit);
  context_.dispatchIndirect(0);
  if (!hasEdges) return;
  context_.api().MemoryBarrier(GL_COMMAND_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                               GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  gl::ComputeShader& single = context.shaders.computeShader("clouds/march_edges.comp", defines);
  single.use();
  single.setInt("sunSamples", static_cast<int>(settings_.march.sunSamples));
  edges_.bind(GL_DISPATCH_INDIRECT_BUFFER);
  context_.dispatchIndirect(0);
}

CloudSystem::Work CloudSystem::lastWork() const {
  const auto count = [](const gl::Buffer& list) {
    ListHeader header;
    if (list) list.read(0, std::as_writable_bytes(std::span(&header, 1)));
    return header.count;
  };
  return {count(tiles_), count(edges_)};
}

}  // namespace skydrop::render
