#include "skydrop/render/clouds/cloud_plane.h"

#include <algorithm>
#include <cmath>
#include <glm/mat2x2.hpp>
#include <span>
#include <vector>

#include "render/clouds/sheet_layer.h"
#include "render/clouds/sheet_shade.h"
#include "render/clouds/sheet_sun.h"
#include "render/clouds/sheet_view.h"
#include "skydrop/core/shared.h"
#include "skydrop/render/clouds/cloud_plane_mesh.h"
#include "skydrop/render/frame/cloud_transmittance.h"

namespace skydrop::render {
namespace {

namespace shared = core::shared::f64;

constexpr GLuint kNoiseUnit = 0, kLayerUnit = 0, kDepthUnit = 1;

// The copy that varies cover: turned by an angle that fits no lattice, and as much wider. Together the two
// repeat after hundreds of kilometres.
constexpr double kWeatherWidth = 4.73, kWeatherCos = 0.8, kWeatherSin = 0.6;
// The copy that frays edges: finer by this, turned the other way.
constexpr double kFineScale = 6.37, kFineCos = 0.28, kFineSin = -0.96;
// Shade comes from so far away as this height reaches towards the sun, at most kMostShadeM.
constexpr double kShadeHeightM = 160, kMostShadeM = 600;
// The cutoff is shifted at most by so many standard deviations of the noise.
constexpr double kMostShiftSpreads = 1.6;

double wrapped(double x) {
  const double share = x - std::floor(x);
  return share < 1 ? share : 0;  // -1e-20 - floor(-1e-20) is 1
}
glm::dvec2 wrapped(const glm::dvec2& v) { return {wrapped(v.x), wrapped(v.y)}; }

glm::dmat2 turn(double cosine, double sine, double scale) {
  return glm::dmat2(cosine, sine, -sine, cosine) * scale;
}
glm::dmat2 weatherTurn() { return turn(kWeatherCos, kWeatherSin, 1 / kWeatherWidth); }
glm::dmat2 fineTurn() { return turn(kFineCos, kFineSin, kFineScale); }

glm::vec4 columns(const glm::dmat2& m) { return glm::vec4(glm::dvec4(m[0].x, m[0].y, m[1].x, m[1].y)); }

}  // namespace

PlaneAnchor planeAnchor(const clouds::CloudPlaneSettings& layer, const core::WindSettings& wind,
                        const glm::dvec3& eye, double seconds) {
  const glm::dvec2 drift = core::windDrift(wind, seconds) * shared::sheetDriftShare(layer.height);
  const glm::dvec2 place = (glm::dvec2(eye.x, eye.z) - drift) / layer.period;
  return {wrapped(place), wrapped(weatherTurn() * place), wrapped(fineTurn() * place)};
}

CloudPlane::CloudPlane(gl::Context& context)
    : context_(context), job_([](const clouds::CloudPlaneSettings& of, std::stop_token stop) {
        return Made{of, std::make_shared<const SheetNoise>(makeSheetNoise(of, std::move(stop)))};
      }) {}

void CloudPlane::apply(const clouds::CloudPlaneSettings& settings) {
  settings_ = settings;
  if (asked_ && !clouds::isSameNoise(*asked_, settings)) {
    asked_ = settings;
    job_.request(settings);
  }
}

void CloudPlane::take(const clouds::CloudPlaneSettings& madeOf, std::shared_ptr<const SheetNoise> noise) {
  if (!noise || noise->levels.empty()) return;
  if (!asked_) asked_ = madeOf;
  noise_ = std::move(noise);
  isUploaded_ = false;
}

void CloudPlane::prepare() {
  if (asked_ && clouds::isSameNoise(*asked_, settings_)) return;
  asked_ = settings_;
  job_.request(settings_);
}

void CloudPlane::waitForNoise() { job_.wait(); }

void CloudPlane::update() {
  if (std::optional<Made> made = job_.take()) take(made->of, std::move(made->noise));
}

const gl::Texture& CloudPlane::texture() {
  if (isUploaded_) return texture_;
  const auto levels = static_cast<GLsizei>(noise_->levels.size());
  if (!texture_ || texture_.width() != noise_->side) {
    texture_ = gl::Texture::make2D(context_, GL_R32F, noise_->side, noise_->side, "cloud plane", levels);
    texture_.setWrap(GL_REPEAT);
    texture_.setFilter(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
  }
  for (GLint level = 0; level < levels; ++level) {
    texture_.upload(GL_RED, GL_FLOAT,
                    std::as_bytes(std::span(noise_->levels[static_cast<std::size_t>(level)])), level);
  }
  isUploaded_ = true;
  return texture_;
}

CloudPlanes::CloudPlanes(gl::Context& context, const PreparedPlaneNoise* prepared,
                         const clouds::CloudPlanesSettings& settings, const core::WindSettings& wind)
    : context_(context),
      layer_(std::make_unique<SheetLayer>(context, "cloud plane layer")),
      shade_(std::make_unique<SheetShade>()) {
  const CloudPlaneMesh mesh = makeCloudPlaneMesh();
  vertices_ = gl::Buffer::of(context, std::span(mesh.vertices), gl::Buffer::Use::fixed, "cloud plane");
  indices_ = gl::Buffer::of(context, std::span(mesh.indices), gl::Buffer::Use::fixed, "cloud plane");
  mesh_ = gl::VertexArray(context, "cloud plane");
  mesh_.setVertexBuffer(0, vertices_, 0, sizeof(CloudPlaneVertex));
  mesh_.setIndexBuffer(indices_);
  mesh_.setAttribute(0, 0, 2, GL_FLOAT, offsetof(CloudPlaneVertex, place));
  mesh_.setAttribute(1, 0, 1, GL_FLOAT, offsetof(CloudPlaneVertex, alpha));
  indexCount_ = static_cast<GLsizei>(mesh.indices.size());
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    planes_[i] = std::make_unique<CloudPlane>(context);
    if (prepared) planes_[i]->take(prepared->settings[i], prepared->layers[i]);
  }
  apply(settings, wind);
}

CloudPlanes::~CloudPlanes() = default;

void CloudPlanes::apply(const clouds::CloudPlanesSettings& settings, const core::WindSettings& wind) {
  settings_ = settings;
  wind_ = wind;
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    planes_[i]->apply(settings.layers[i]);
    if (i < count()) planes_[i]->prepare();
  }
}

void CloudPlanes::waitForNoise() {
  for (const std::unique_ptr<CloudPlane>& plane : planes_) plane->waitForNoise();
}

const char* CloudPlanes::idleReason(const FrameInput& frame, const CloudPlane& plane) const {
  if (frame.warmsUp) return nullptr;
  const clouds::CloudPlaneSettings& layer = plane.settings();
  if (layer.cutoff >= 1) return "the cutoff leaves no cloud";
  if (missesLevelPlane(frame.view, layer.height, settings_.radiusM)) return "the layers are out of view";
  return nullptr;
}

std::optional<std::string> CloudPlanes::skipReason(const FrameInput& frame) const {
  if (count() == 0) return "no layers";
  const char* reason = nullptr;
  for (std::size_t i = 0; i < count(); ++i) {
    reason = idleReason(frame, *planes_[i]);
    if (!reason) return std::nullopt;
  }
  return reason;
}

void CloudPlanes::draw(FrameContext& context) {
  std::vector<CloudPlane*> planes;
  for (std::size_t i = 0; i < count(); ++i) {
    planes_[i]->update();
    if (planes_[i]->noise() && !idleReason(context.frame, *planes_[i])) planes.push_back(planes_[i].get());
  }
  // Far to near: what is farther from the eye's height lies behind along every ray that meets both. Layers at
  // one height keep their order.
  const double eye = context.frame.view.position.y;
  std::ranges::stable_sort(planes, std::ranges::greater(),
                           [&](const CloudPlane* plane) { return std::abs(plane->settings().height - eye); });
  const gl::Functions& gl = context.gl.api();
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  context.sceneDepth.bind(kDepthUnit);
  mesh_.bind();
  for (CloudPlane* plane : planes) {
    const bool shaded = shade_->take(context, plane->settings().height);
    // Later frames may do without the shade: in frames that nobody sees, that is compiled too.
    if (shaded && context.frame.warmsUp) drawPlane(context, *plane, false);
    drawPlane(context, *plane, shaded);
  }
}

void CloudPlanes::drawPlane(FrameContext& context, CloudPlane& plane, bool shaded) {
  const std::vector<std::string> defines = withCloudTransmittance(context.defines, context.resources);
  if (settings_.resolution == clouds::SheetResolution::full) {
    layer_->release();
    drawLight(context, plane,
              shade_->shader(context, "clouds/plane.vert", "clouds/plane.frag", defines, shaded));
    return;
  }
  gl::Shader& light =
      shade_->shader(context, "clouds/plane.vert", "clouds/plane_layer.frag", context.defines, shaded);
  gl::Shader& compose =
      context.shaders.shader("clouds/plane_compose.vert", "clouds/plane_compose.frag", defines);
  const gl::Functions& gl = context.gl.api();
  layer_->begin(context.frame.view, settings_.resolution);
  gl.Disable(GL_BLEND);
  drawLight(context, plane, light);
  gl.Enable(GL_BLEND);
  layer_->end(kLayerUnit);
  setPlace(compose, context.frame.view, plane);
  drawMesh(context, compose);
}

void CloudPlanes::setPlace(gl::Shader& shader, const View& view, const CloudPlane& plane) const {
  shader.setFloat("radiusM", static_cast<float>(settings_.radiusM));
  shader.setFloat("riseM", static_cast<float>(plane.settings().height - view.position.y));
}

void CloudPlanes::drawMesh(FrameContext& context, gl::Shader& shader) {
  shader.use();
  context.gl.drawElements(GL_TRIANGLES, indexCount_, GL_UNSIGNED_SHORT);
}

void CloudPlanes::drawLight(FrameContext& context, CloudPlane& plane, gl::Shader& shader) {
  const View& view = context.frame.view;
  const clouds::CloudPlaneSettings& layer = plane.settings();
  const SheetNoise& noise = *plane.noise();
  plane.texture().bind(kNoiseUnit);
  setPlace(shader, view, plane);
  const auto set = [&shader](const char* name, double value) {
    shader.setFloat(name, static_cast<float>(value));
  };
  const PlaneAnchor anchor = planeAnchor(layer, wind_, view.position, context.frame.simulatedSeconds);
  set("texturesPerM", 1 / layer.period);
  shader.setVec2("textureAnchor", glm::vec2(anchor.texture));
  shader.setVec2("weatherAnchor", glm::vec2(anchor.weather));
  shader.setVec4("weatherTurn", columns(weatherTurn()));
  shader.setVec2("fineAnchor", glm::vec2(anchor.fine));
  shader.setVec4("fineTurn", columns(fineTurn()));
  set("fineScale", kFineScale);
  set("detail", settings_.detail);
  set("cutoff", layer.cutoff);
  set("depthPerNoise", shared::sheetDepthPerNoise(layer.density));
  set("variation", settings_.variation);
  set("noiseMean", noise.mean);
  set("mostShift", kMostShiftSpreads * noise.spread);
  set("texels", noise.side);
  const auto lostAt = [&](std::size_t level) {
    return static_cast<float>(noise.lost[std::min(level, noise.lost.size() - 1)]);
  };
  shader.setVec4("lost", {lostAt(2), lostAt(4), lostAt(6), lostAt(8)});
  const glm::dvec3 sun = context.light.direct.toSun;
  const double level = std::max(std::hypot(sun.x, sun.z), 1e-9);
  const double shadeM = std::min(kShadeHeightM * level / std::max(sun.y, 0.01), kMostShadeM);
  shader.setVec2("towardsSun", glm::vec2(glm::dvec2(sun.x, sun.z) / level * (shadeM / layer.period)));
  shader.setVec3("sheetSun", glm::vec3(sunOnSheet(context.light, layer.height)));
  set("selfShadow", settings_.selfShadow);
  drawMesh(context, shader);
}

}  // namespace skydrop::render
