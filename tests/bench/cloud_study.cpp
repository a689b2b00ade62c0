#include "bench/cloud_study.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "app/session/open_context.h"
#include "app/settings/cloud_tier.h"
#include "app/settings/settings.h"
#include "skydrop/render/frame/camera.h"
#include "support/shared_noise.h"

namespace skydrop::bench {
namespace {

constexpr float kLeastOpacity = 0.01f;  // of a ray whose error counts

class TimedPass final : public render::Pass {
 public:
  TimedPass(std::unique_ptr<render::Pass> pass, Cost& cost) : pass_(std::move(pass)), cost_(cost) {}

  std::string_view name() const override { return pass_->name(); }
  render::RenderStage stage() const override { return pass_->stage(); }
  std::optional<std::string> skipReason(const render::FrameInput& frame) const override {
    return pass_->skipReason(frame);
  }
  void draw(render::FrameContext& context) override {
    const auto finish = context.gl.api().Finish;
    finish();
    const auto begin = std::chrono::steady_clock::now();
    const std::clock_t processorBegin = std::clock();
    pass_->draw(context);
    finish();
    cost_.processorMs = 1e3 * static_cast<double>(std::clock() - processorBegin) / CLOCKS_PER_SEC;
    cost_.wallMs =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  }

 private:
  std::unique_ptr<render::Pass> pass_;
  Cost& cost_;
};

render::View viewOf(const CloudView& from, app::Size size) {
  render::Camera camera;
  camera.setMode(render::CameraMode::free);
  camera.setPose(from.position, glm::radians(from.yawDegrees), glm::radians(from.pitchDegrees),
                 glm::radians(from.rollDegrees));
  return camera.view(game::Snapshot{}, render::CameraSettings{}, size.width, size.height);
}

std::vector<glm::vec4> texelsOf(const render::gl::Texture& texture) {
  std::vector<glm::vec4> texels(static_cast<std::size_t>(texture.width()) *
                                static_cast<std::size_t>(texture.height()));
  texture.read(GL_RGBA, GL_FLOAT, std::as_writable_bytes(std::span(texels)));
  return texels;
}

std::vector<glm::vec3> radianceOf(const render::gl::Texture& texture) {
  const std::vector<glm::vec4> texels = texelsOf(texture);
  return {texels.begin(), texels.end()};
}

}  // namespace

Cost best(const Cost& a, const Cost& b) {
  return {std::min(a.processorMs, b.processorMs), std::min(a.wallMs, b.wallMs)};
}

double relativeError(const std::vector<glm::vec3>& radiance, const CloudPicture& reference) {
  double error = 0, whole = 0;
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    if (reference.opacity[i] <= kLeastOpacity) continue;
    const glm::dvec3 expected(reference.radiance[i]), difference = glm::dvec3(radiance[i]) - expected;
    error += glm::dot(difference, difference);
    whole += glm::dot(expected, expected);
  }
  return std::sqrt(error / whole);
}

clouds::CloudSettings settingsOf(clouds::CloudTier tier) {
  app::Settings settings;
  const core::SettingsTable table(settings);
  app::applyCloudTier(table, app::readCloudTier(app::cloudTierPath(tier)));
  settings.clouds.light = clouds::CloudLight::octaves;  // what the march alone takes
  return settings.clouds;
}

CloudStudy::CloudStudy(app::Size size)
    : size_(size), context_(app::openContext(std::nullopt, size)), renderer_(*context_, {}, false) {
  drawFrame(kCloudViews[0], false);
  bytesWithoutClouds_ = context_->resources().bytes();
  auto clouds = std::make_unique<render::CloudSystem>(*context_, test::sharedNoise(), settings_, wind_);
  auto plain = std::make_unique<PlainMarch>();
  clouds_ = clouds.get();
  plain_ = plain.get();
  renderer_.add(std::make_unique<TimedPass>(std::move(clouds), cloudCost_));
  renderer_.add(std::make_unique<TimedPass>(std::move(plain), plainCost_));
}

std::uint64_t CloudStudy::cloudBytes() const { return context_->resources().bytes() - bytesWithoutClouds_; }

void CloudStudy::use(const clouds::CloudSettings& settings) {
  settings_ = settings;
  clouds_->apply(settings_, wind_);
}

void CloudStudy::drawFrame(const CloudView& view, bool plain) {
  if (plain_) plain_->asked = plain;
  renderer_.draw({.view = viewOf(view, size_),
                  .features = {.haze = true},
                  .simulatedSeconds = view.seconds,
                  .game = snapshot_.weather ? &snapshot_ : nullptr,
                  .followsLast = view.followsLast});
  renderer_.finish();
}

Cost CloudStudy::draw(const CloudView& view) {
  drawFrame(view, false);
  return cloudCost_;
}

Cost CloudStudy::drawPlain(const CloudView& view) {
  drawFrame(view, true);
  return plainCost_;
}

CloudPicture CloudStudy::picture() {
  context_->makeCurrent();
  context_->api().MemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
  CloudPicture picture{radianceOf(renderer_.sceneColor()), {}};
  for (const glm::vec4& ray : texelsOf(clouds_->light())) picture.opacity.push_back(1 - ray.w);
  return picture;
}

std::vector<glm::vec3> CloudStudy::plainRadiance() { return radianceOf(plain_->light()); }

}  // namespace skydrop::bench
