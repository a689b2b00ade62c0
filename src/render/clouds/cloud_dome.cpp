#include "skydrop/render/clouds/cloud_dome.h"

#include <cmath>
#include <glm/mat3x3.hpp>
#include <span>

#include "render/clouds/sheet_layer.h"
#include "render/clouds/sheet_shade.h"
#include "render/clouds/sheet_sun.h"
#include "render/clouds/sheet_view.h"
#include "skydrop/core/shared.h"
#include "skydrop/render/clouds/cloud_dome_mesh.h"

namespace skydrop::render {
namespace {

namespace shared = core::shared::f64;

constexpr GLuint kNoiseUnit = 0, kLayerUnit = 0;

double wrapped(double x) {
  const double share = x - std::floor(x);
  return share < 1 ? share : 0;
}

}  // namespace

glm::dvec3 domeOffset(const clouds::CloudDomeSettings& settings, double seconds) {
  return {wrapped(settings.speedX * seconds), wrapped(settings.speedY * seconds), 0};
}

CloudDome::CloudDome(gl::Context& context, const PreparedDomeNoise* prepared,
                     const clouds::CloudDomeSettings& settings)
    : context_(context),
      settings_(settings),
      asked_(prepared ? prepared->settings : settings),
      layer_(std::make_unique<SheetLayer>(context, "cloud dome layer")),
      shade_(std::make_unique<SheetShade>()),
      job_([](const clouds::CloudDomeSettings& of, std::stop_token stop) {
        return Made{of, std::make_shared<const SheetNoise>(makeSheetNoise(of, std::move(stop)))};
      }) {
  const CloudDomeMesh mesh = makeCloudDomeMesh();
  vertices_ = gl::Buffer::of(context, std::span(mesh.vertices), gl::Buffer::Use::fixed, "cloud dome");
  indices_ = gl::Buffer::of(context, std::span(mesh.indices), gl::Buffer::Use::fixed, "cloud dome");
  mesh_ = gl::VertexArray(context, "cloud dome");
  mesh_.setVertexBuffer(0, vertices_, 0, sizeof(CloudDomeVertex));
  mesh_.setIndexBuffer(indices_);
  mesh_.setAttribute(0, 0, 3, GL_FLOAT, offsetof(CloudDomeVertex, direction));
  mesh_.setAttribute(1, 0, 1, GL_FLOAT, offsetof(CloudDomeVertex, alpha));
  indexCount_ = static_cast<GLsizei>(mesh.indices.size());
  if (prepared)
    take(prepared->volume);
  else
    job_.request(settings);
  apply(settings);
}

CloudDome::~CloudDome() = default;

void CloudDome::take(std::shared_ptr<const SheetNoise> noise) {
  if (!noise || noise->levels.empty()) return;
  noise_ = std::move(noise);
  isUploaded_ = false;
}

void CloudDome::apply(const clouds::CloudDomeSettings& settings) {
  settings_ = settings;
  if (clouds::isSameNoise(asked_, settings)) return;
  asked_ = settings;
  job_.request(settings);
}

void CloudDome::waitForNoise() { job_.wait(); }

std::optional<std::string> CloudDome::skipReason(const FrameInput& frame) const {
  if (frame.warmsUp) return std::nullopt;
  if (settings_.cutoff >= 1) return "the cutoff leaves no cloud";
  if (settings_.bias <= 0) return "the bias leaves no cloud";
  if (steepestUp(frame.view) <= 0) return "no sky above the horizon in view";
  return std::nullopt;
}

void CloudDome::upload() {
  if (isUploaded_) return;
  if (!texture_ || texture_.width() != noise_->side) {
    texture_ = gl::Texture::make3D(context_, GL_R32F, noise_->side, noise_->side, noise_->side, "cloud dome");
    texture_.setWrap(GL_REPEAT);
  }
  texture_.upload(GL_RED, GL_FLOAT, std::as_bytes(std::span(noise_->levels.front())));
  isUploaded_ = true;
}

void CloudDome::draw(FrameContext& context) {
  if (std::optional<Made> made = job_.take()) take(std::move(made->noise));
  if (!noise_) return;
  upload();
  const gl::Functions& gl = context.gl.api();
  gl.DepthMask(GL_FALSE);
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  mesh_.bind();
  const bool shaded = shade_->take(context, shared::kDomeHeightM);
  // Later frames may do without the shade: in frames that nobody sees, that is compiled too.
  if (shaded && context.frame.warmsUp) drawSheet(context, false);
  drawSheet(context, shaded);
}

void CloudDome::drawSheet(FrameContext& context, bool shaded) {
  const gl::Functions& gl = context.gl.api();
  gl::Shader& light =
      shade_->shader(context, "clouds/dome.vert", "clouds/dome.frag", context.defines, shaded);
  if (settings_.resolution == clouds::SheetResolution::full) {
    layer_->release();
    gl.Enable(GL_BLEND);
    drawLight(context, light);
    return;
  }
  gl::Shader& compose = context.shaders.shader("clouds/dome_compose.vert", "clouds/dome_compose.frag");
  layer_->begin(context.frame.view, settings_.resolution);
  gl.Disable(GL_BLEND);
  drawLight(context, light);
  gl.Enable(GL_BLEND);
  layer_->end(kLayerUnit);
  drawMesh(context, compose);
}

void CloudDome::drawMesh(FrameContext& context, gl::Shader& shader) {
  shader.use();
  context.gl.drawElements(GL_TRIANGLES, indexCount_, GL_UNSIGNED_SHORT);
}

void CloudDome::drawLight(FrameContext& context, gl::Shader& shader) {
  texture_.bind(kNoiseUnit);
  const auto set = [&shader](const char* name, double value) {
    shader.setFloat(name, static_cast<float>(value));
  };
  set("scale", settings_.scale);
  set("flatness", settings_.flatness);
  shader.setVec3("offset", glm::vec3(domeOffset(settings_, context.frame.simulatedSeconds)));
  set("cutoff", settings_.cutoff);
  set("depthPerNoise", shared::sheetDepthPerNoise(settings_.exponent));
  set("bias", settings_.bias);
  set("noiseMean", noise_->mean);
  shader.setVec3("cloudColor", glm::vec3(glm::dvec3(settings_.red, settings_.green, settings_.blue)));
  shader.setVec3("sheetSun", glm::vec3(sunOnSheet(context.light, shared::kDomeHeightM)));
  set("selfShadow", settings_.selfShadow);
  drawMesh(context, shader);
}

}  // namespace skydrop::render
