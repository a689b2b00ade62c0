#include "skydrop/render/clouds/cloud_system.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "render/clouds/cloud_history.h"
#include "render/clouds/cloud_textures.h"
#include "render/clouds/cloud_uniforms.h"
#include "render/clouds/light_volumes.h"
#include "render/clouds/march_plan.h"
#include "render/clouds/sun_optical_depth_grid.h"
#include "render/clouds/weather_layers.h"
#include "skydrop/clouds/raised_sun.h"
#include "skydrop/core/shared.h"
#include "skydrop/core/shared_clouds.h"
#include "skydrop/game/snapshot.h"
#include "skydrop/render/clouds/ice_shade.h"

namespace skydrop::render {
namespace {

constexpr GLuint kLightVolumesUnit = 4, kSceneDepthUnit = 6, kLightUnit = 7,
                 kDistancesUnit = 8;  // as in shaders/clouds
struct TilesHeader {
  ListGroups ofOne, ofFour;
};

// Whether no ray of the picture meets the layer before clouds have faded.
bool missesLayer(const View& view, const clouds::CloudLayerSettings& layer, double fadeDistance) {
  const double below = layer.cloudHeight - view.position.y,
               above = view.position.y - layer.cloudHeight - layer.thickness;
  if (below <= 0 && above <= 0) return false;
  if (std::max(below, above) >= fadeDistance) return true;
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
  // As rays that rise over the layer by `bend` times the square of their length.
  const double bend = core::shared::f64::rayBend({std::sqrt(1 - std::min(steepest * steepest, 1.0)), 0, 0});
  if (below > 0) return (steepest + bend * fadeDistance) * fadeDistance <= below;
  if (steepest <= 0) return true;
  const double lowest = std::min(fadeDistance, steepest / std::max(2 * bend, 1e-30));
  return (steepest - bend * lowest) * lowest <= above;
}

}  // namespace

CloudSystem::CloudSystem(gl::Context& context, std::shared_ptr<const clouds::PackedCloudNoise> noise,
                         const clouds::CloudSettings& settings, const core::WindSettings& wind)
    : context_(context),
      settings_(settings),
      wind_(wind),
      flatLoops_(context.isSoftware()),
      textures_(std::make_unique<CloudTextures>(context, noise, settings)),
      noise_(std::move(noise)),
      uniforms_(context, sizeof(CloudUniforms), gl::Buffer::Use::write, "cloud uniforms") {
  forgetShadowMap();
}

CloudSystem::~CloudSystem() = default;

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
  for (SunOpticalDepthGrid* grid : {fineShadowMap_.get(), coarseShadowMap_.get()}) grid->forget();
}

std::optional<std::string> CloudSystem::skipReason(const FrameInput& frame) const {
  if (settings_.tier == clouds::CloudTier::off) return "switched off";
  if (drawsWeather(frame)) {
    std::string reason = "no cloud anywhere";
    for (const DrawnLayer& drawn :
         WeatherLayers::mediaOf(frame.game->weather, {frame.view.position.x, frame.view.position.z})) {
      if (!drawn.isThere) continue;
      if (!missesLayer(frame.view, drawn.medium.layer, settings_.fadeDistance)) return std::nullopt;
      reason = "the layer is out of view";
    }
    return reason;
  }
  if (textures_->isEmpty(kMarchedLayer)) return "no cloud anywhere";
  if (missesLayer(frame.view, layer(), settings_.fadeDistance)) return "the layer is out of view";
  return std::nullopt;
}

bool CloudSystem::drawsWeather(const FrameInput& frame) const { return WeatherLayers::isWeather(frame); }

void CloudSystem::prepare(const FrameInput& frame) {
  if (!drawsWeather(frame)) {
    weather_.reset();
    return;
  }
  if (!weather_) weather_ = std::make_unique<WeatherLayers>(context_, noise_);
  weather_->update(frame);
}

std::vector<std::string> CloudSystem::definesOf(const FrameContext& context) const {
  std::vector<std::string> defines = marchDefines(context.defines, settings_, flatLoops_);
  if (weather_) defines.push_back("LAYERS " + std::to_string(weather_->layers().size()));
  if (weather_ && weather_->mayOverlap()) defines.emplace_back("OVERLAPS");
  if (volumes_) defines.emplace_back("LIGHT_VOLUME");
  return defines;
}

void CloudSystem::takeVolumes(const FrameInput& frame) {
  if ((settings_.light == clouds::CloudLight::volume) != (volumes_ != nullptr)) {
    volumes_.reset();
    if (settings_.light == clouds::CloudLight::volume)
      volumes_ = std::make_unique<LightVolumes>(context_, noise_);
    history_.reset();  // it is of another light
  }
  if (!volumes_) return;
  const clouds::LightCells cells = settings_.march.lightCells;
  const glm::dvec3 eye = eyeInField(frame);
  volumes_->update(weather_ ? lightVolumesKey(weather_->layers(), frame.toSun, cells)
                            : lightVolumesKey(clouds::mediumOf(settings_, kMarchedLayer), frame.toSun, cells),
                   {eye.x, eye.z}, !frame.followsLast);
}

glm::dvec3 CloudSystem::inField(const glm::dvec3& place, const FrameInput& frame) const {
  const glm::dvec2 drift = core::windDrift(wind_, frame.simulatedSeconds);
  return place - glm::dvec3(drift.x, 0, drift.y);
}

void CloudSystem::resize(const View& view) {
  const int side = tileSideOf(settings_), widest = widestSpacing(settings_);
  const auto size = [&](int spacing) {
    return glm::ivec2(raysAcross(view.width, spacing, widest), raysAcross(view.height, spacing, widest));
  };
  // Tiles for all rays, those beyond the picture's edge too.
  const glm::ivec2 tiles = (size(widest) * widest - widest + side) / side;
  const auto has = [&](int spacing) {
    const gl::Texture& light = raysApart(spacing).light;
    const bool isThere = light && glm::ivec2(light.width(), light.height()) == size(spacing);
    return spacing <= widest ? isThere : !light;
  };
  const std::size_t spanBytes = kSpansBytes * (weather_ ? weather_->layers().size() : 1);
  const std::size_t all = static_cast<std::size_t>(tiles.x) * static_cast<std::size_t>(tiles.y);
  if (tiles == tileCount_ && has(1) && has(2) && has(4) && spans_.size() == all * spanBytes) return;
  for (const int spacing : {1, 2, 4}) {
    raysApart(spacing) = {};
    if (spacing > widest) continue;
    const glm::ivec2 rays = size(spacing);
    raysApart(spacing) = {gl::Texture::make2D(context_, GL_RGBA16F, rays.x, rays.y, "cloud light"),
                          gl::Texture::make2D(context_, GL_R16F, rays.x, rays.y, "cloud distances")};
  }
  tileCount_ = tiles;
  tiles_ =
      gl::Buffer(context_, sizeof(TilesHeader) + all * kTaskBytes, gl::Buffer::Use::write, "cloud tiles");
  spans_ = gl::Buffer(context_, all * spanBytes, gl::Buffer::Use::fixed, "cloud spans");
  for (const int spacing : {1, 2}) {
    gl::Buffer& list = listedRays_[static_cast<std::size_t>(spacing) - 1];
    list = {};
    if (spacing >= widest) continue;
    // Three of four texels in each tile, at most.
    const std::size_t most = all * static_cast<std::size_t>(side * side / (spacing * spacing));
    list = gl::Buffer(context_, sizeof(ListGroups) + most * sizeof(GLuint), gl::Buffer::Use::write,
                      "cloud rays");
  }
}

void CloudSystem::marchMultiDispatch() {
  const gl::Functions& api = context_.api();
  const int width = rays_[0].light.width(), height = rays_[0].light.height();
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
  prepare(context.frame);
  takeVolumes(context.frame);
  const std::vector<std::string> defines = definesOf(context);
  beginHistory(context);
  resize(context.frame.view);
  setUniforms(context);
  classify(context, defines);
  const bool shaded = takeLandShade(context);
  // Later frames may do without the shade: in frames that nobody sees, that march is compiled too.
  if (shaded && context.frame.warmsUp) marchAll(context, defines, false);
  marchAll(context, defines, shaded);
  cover(context, defines);
  if (history_) history_->keep(context);
  transmittance_ = {&rays_[0].light, &rays_[0].distances};
  context.resources.publish(transmittance_);
  context_.api().MemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

// Whether land may take light from the sun in the layer. The shade of mountains ends below their summits.
bool CloudSystem::takeLandShade(FrameContext& context) {
  if (!context.frame.features.landShadows) {
    landShade_ = {};
    return false;
  }
  const auto* map = context.resources.find<LandShadowMap>();
  const double baseM = weather_ ? hullOf(weather_->layers()).cloudHeight : layer().cloudHeight;
  if (!map || (map->shade() && map->shade()->topM() <= baseM)) return false;
  landShade_.take(context.gl, *map);
  return true;
}

void CloudSystem::marchAll(FrameContext& context, Defines defines, bool shaded) {
  isShaded_ = shaded;
  if (settings_.march.exact)
    marchExactly(context, defines);
  else
    march(context, defines);
}

// In use. Where a later frame may need the other variant, that is asked for too (Pass::draw).
gl::ComputeShader& CloudSystem::marchShader(FrameContext& context, const std::string& file, Defines defines) {
  std::vector<std::string> withShade(defines.begin(), defines.end());
  withShade.emplace_back(LandShadowMap::kDefine);
  const auto variant = [&](bool shaded) -> gl::ComputeShader& {
    return context.shaders.computeShader(file, shaded ? Defines(withShade) : defines);
  };
  if (context.frame.features.landShadows && context.frame.looksAhead()) variant(!isShaded_);
  gl::ComputeShader& shader = variant(isShaded_);
  shader.use();
  const glm::dvec3& eye = context.frame.view.position;
  if (isShaded_) landShade_.bind(shader, {eye.x, eye.z});
  return shader;
}

void CloudSystem::beginHistory(const FrameContext& context) {
  const bool isAsked = context.frame.followsLast && !settings_.march.exact &&
                       settings_.march.history != clouds::MarchHistory::off;
  if (!isAsked) {
    history_.reset();
    return;
  }
  // What the last frame saw of another weather is no past of this one.
  auto weather = weather_ ? weather_->settings() : nullptr;
  if (historyWeather_ != weather) history_.reset();
  historyWeather_ = std::move(weather);
  if (!history_) history_ = std::make_unique<CloudHistory>();
  history_->begin(context, eyeInField(context.frame), settings_, rays_[0]);
}

// What all shaders of the pass read.
void CloudSystem::setUniforms(FrameContext& context) {
  const View& view = context.frame.view;
  textures_->bind(kMarchedLayer);
  context.sceneDepth.bind(kSceneDepthUnit);
  if (volumes_) volumes_->bind(kLightVolumesUnit);
  if (weather_) {
    constexpr GLuint kOccupancyUnit = 3;
    weather_->distances().bind(kOccupancyUnit);
    CloudUnionUniforms all = unionUniforms(weather_->layers(), settings_.fadeDistance,
                                           eyeInField(context.frame), textures_->meanDetail());
    // One phase function for the droplets of all layers.
    all.common.scattering.x = static_cast<float>(layer().anisotropy);
    all.common.scattering.y = static_cast<float>(layer().forwardShare);
    addLight(all, weather_->layers(), context.light);
    if (const auto* ice = context.resources.find<IceShade>())
      addIceShade(all, weather_->layers(), *ice, view.position);
    addMarch(all, weather_->layers(), settings_, view, tileSideOf(settings_));
    if (!unionUniforms_)
      unionUniforms_ = gl::Buffer(context_, sizeof all, gl::Buffer::Use::write, "cloud layers");
    unionUniforms_.writeValue(0, all);
    unionUniforms_.bindBase(GL_UNIFORM_BUFFER, kCloudUniformsBinding);
    return;
  }
  CloudUniforms uniforms =
      fieldUniforms(layer(), settings_.fadeDistance, eyeInField(context.frame), textures_->meanDetail());
  addLight(uniforms, layer(), textures_->skyCover(kMarchedLayer).meanShare(), context.light);
  if (const auto* ice = context.resources.find<IceShade>())
    addIceShade(uniforms, layer(), *ice, view.position);
  addMarch(uniforms, settings_, textures_->clearAir(kMarchedLayer), view, tileSideOf(settings_));
  uniforms_.writeValue(0, uniforms);
  uniforms_.bindBase(GL_UNIFORM_BUFFER, kCloudUniformsBinding);
}

// Lists the tiles to be marched; all other rays see nothing.
void CloudSystem::classify(FrameContext& context, Defines defines) {
  const gl::Functions& api = context_.api();
  tiles_.writeValue(0, TilesHeader{});
  tiles_.bindBase(GL_SHADER_STORAGE_BUFFER, kTilesBinding);
  spans_.bindBase(GL_SHADER_STORAGE_BUFFER, kSpansBinding);
  gl::ComputeShader& shader = context.shaders.computeShader("clouds/classify.comp", defines);
  shader.setIvec2("tileCount", tileCount_);
  shader.dispatch(static_cast<GLuint>(tileCount_.x + 7) / 8, static_cast<GLuint>(tileCount_.y + 7) / 8);
  api.MemoryBarrier(GL_COMMAND_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
  clearOthers(context, defines);
}

// Not by clearing whole pictures: a graphics card took a quarter of the march's time for that.
void CloudSystem::clearOthers(FrameContext& context, Defines defines) {
  gl::ComputeShader& shader = context.shaders.computeShader("clouds/clear_tiles.comp", defines);
  shader.use();
  for (const int spacing : {1, 2, 4}) {
    const CloudRays& rays = raysApart(spacing);
    if (!rays.light) continue;
    shader.setInt("raySpacing", spacing);
    rays.light.bindImage(0, GL_WRITE_ONLY);
    rays.distances.bindImage(1, GL_WRITE_ONLY);
    shader.dispatch(static_cast<GLuint>(tileCount_.x), static_cast<GLuint>(tileCount_.y));
  }
}

// Rays as far apart as they may be, then those between them that have to be marched.
void CloudSystem::march(FrameContext& context, Defines defines) {
  const int widest = widestSpacing(settings_);
  if (history_) {
    const gl::Buffer& list =
        history_->recallTiles(context, defines, widest, raysApart(widest), tiles_, tileCount_);
    marchListed(context, defines, widest, list);
  } else {
    marchTiles(context, defines, widest);
  }
  for (int spacing = widest / 2; spacing > 0; spacing /= 2) refine(context, defines, spacing);
}

void CloudSystem::marchTiles(FrameContext& context, Defines defines, int widest) {
  gl::ComputeShader& shader = marchShader(context, "clouds/march_tiles.comp", withGroups(defines, widest));
  shader.setIvec2("tileCount", tileCount_);
  shader.setInt("raySpacing", widest);
  raysApart(widest).light.bindImage(0, GL_WRITE_ONLY);
  raysApart(widest).distances.bindImage(1, GL_WRITE_ONLY);
  tiles_.bind(GL_DISPATCH_INDIRECT_BUFFER);
  context_.dispatchIndirect(widest == 4 ? kFourBytes : 0);
}

void CloudSystem::refine(FrameContext& context, Defines defines, int spacing) {
  std::vector<std::string> all = withSpacing(defines, spacing);
  gl::Buffer& list = listedRays_[static_cast<std::size_t>(spacing) - 1];
  gl::Buffer& found = history_ ? history_->candidates() : list;
  found.writeValue(0, ListGroups{});
  found.bindBase(GL_SHADER_STORAGE_BUFFER, kRaysBinding);
  context_.api().MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  raysApart(2 * spacing).light.bind(kLightUnit);
  raysApart(2 * spacing).distances.bind(kDistancesUnit);
  raysApart(spacing).light.bindImage(0, GL_WRITE_ONLY);
  raysApart(spacing).distances.bindImage(1, GL_WRITE_ONLY);
  std::vector<std::string> ofRefine = all;
  if (history_) ofRefine.emplace_back("HISTORY");
  context.shaders.computeShader("clouds/refine.comp", ofRefine).use();
  tiles_.bind(GL_DISPATCH_INDIRECT_BUFFER);
  context_.dispatchIndirect(spacing == 2 ? kFourBytes : 0);
  context_.api().MemoryBarrier(GL_COMMAND_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                               GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  if (history_) history_->recallCandidates(context, all, raysApart(spacing), tileCount_, list);
  marchListed(context, defines, spacing, list);
}

void CloudSystem::marchListed(FrameContext& context, Defines defines, int spacing, const gl::Buffer& list) {
  list.bindBase(GL_SHADER_STORAGE_BUFFER, kRaysBinding);
  raysApart(spacing).light.bindImage(0, GL_WRITE_ONLY);
  raysApart(spacing).distances.bindImage(1, GL_WRITE_ONLY);
  // One program for all spacings: the march is what takes longest to compile.
  gl::ComputeShader& shader = marchShader(context, "clouds/march_rays.comp", defines);
  shader.setIvec2("tileCount", tileCount_);
  shader.setInt("raySpacing", spacing);
  list.bind(GL_DISPATCH_INDIRECT_BUFFER);
  context_.dispatchIndirect(0);
}

void CloudSystem::marchExactly(FrameContext& context, Defines defines) {
  gl::ComputeShader& shader = marchShader(context, "clouds/exact_march.comp", defines);
  shader.setInt("sunSamples", static_cast<int>(settings_.march.sunSamples));
  rays_[0].light.bindImage(0, GL_WRITE_ONLY);
  rays_[0].distances.bindImage(1, GL_WRITE_ONLY);
  tiles_.bind(GL_DISPATCH_INDIRECT_BUFFER);
  if (isMultiDispatch(settings_))
    marchMultiDispatch();
  else
    context_.dispatchIndirect(0);
}

// Lays what was marched over the scene.
void CloudSystem::cover(FrameContext& context, Defines defines) {
  context_.api().MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  context.shaders.computeShader("clouds/cover_tiles.comp", defines).use();
  context.sceneColor.bindImage(0, GL_READ_WRITE);
  rays_[0].light.bind(kLightUnit);
  tiles_.bind(GL_DISPATCH_INDIRECT_BUFFER);
  context_.dispatchIndirect(0);
}

CloudSystem::Work CloudSystem::lastWork() const {
  Work work;
  const auto count = [](const gl::Buffer& list, std::size_t offset) {
    ListGroups header;
    if (list) list.read(offset, std::as_writable_bytes(std::span(&header, 1)));
    return header.count;
  };
  work.tiles = count(tiles_, 0);
  work.finestRays = count(listedRays_[0], 0);
  work.raysBetween = count(listedRays_[1], 0);
  if (history_) work.widestRays = count(history_->widestRays(), 0);
  return work;
}

}  // namespace skydrop::render
