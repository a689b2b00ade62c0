// Fixture of tests that draw clouds: frames without haze, whose clouds can be read before they are laid over
// the scene.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "app/settings/cloud_tier.h"
#include "app/settings/settings.h"
#include "skydrop/clouds/sky_cover.h"
#include "skydrop/render/clouds/cloud_system.h"
#include "support/frame_test.h"
#include "support/light_probe.h"

namespace skydrop::test {

// The rows of a tier, as assets/clouds/NAME.json says them.
inline clouds::MarchSettings rowsOf(clouds::CloudTier tier) {
  app::Settings settings;
  app::applyCloudTier(core::SettingsTable(settings), app::readCloudTier(app::cloudTierPath(tier)));
  return settings.clouds.march;
}

// A ray for each pixel, and quick.
inline clouds::MarchSettings quickRows() {
  clouds::MarchSettings march;
  march.resolution = clouds::MarchResolution::full;
  march.stepM = 8;
  march.stepGrowth = 0.002;
  march.transmittanceCutoff = 0.0005;
  return march;
}

// The same by the exact march: 8 samples to the sun.
inline clouds::MarchSettings quickExactRows() {
  clouds::MarchSettings march = quickRows();
  march.exact = true;
  march.maxSegmentOpticalDepth = 0.2;
  march.sunSamples = 8;
  return march;
}

// Noise of one value everywhere, of all cloud there can be: with plainSettings() the density is the profile
// of a cumulus alone.
inline std::shared_ptr<const clouds::PackedCloudNoise> plainNoise() {
  clouds::PackedCloudNoise noise;
  noise.shapeSide = noise.detailSide = 32;
  noise.weatherSide = 64;
  noise.base.assign(32 * 32 * 32, 1.0f);
  noise.detail.assign(32 * 32 * 32, 0.5f);
  noise.weather.assign(64 * 64, glm::vec3(1));
  return std::make_shared<const clouds::PackedCloudNoise>(std::move(noise));
}

inline clouds::CloudSettings plainSettings() {
  clouds::CloudSettings settings;
  settings.layers[0].coverage = 1;
  settings.layers[0].erosion = 0;
  settings.layers[0].extinction = 0.001;
  settings.light = clouds::CloudLight::octaves;
  settings.march = quickRows();
  return settings;
}

class CloudFrameTest : public FrameTest {
 protected:
  void SetUp() override {
    FrameTest::SetUp();
    features_.haze = false;
    clouds_.light = clouds::CloudLight::octaves;  // what the march alone says; a volume is asked for
    if (!IsSkipped()) renderer().add(std::make_unique<LightProbe>(scene_));
  }

  void addClouds(std::shared_ptr<const clouds::PackedCloudNoise> noise) {
    noise_ = noise;
    auto pass = std::make_unique<render::CloudSystem>(context(), std::move(noise), clouds_, wind_);
    system_ = pass.get();
    renderer().add(std::move(pass));
  }

  // Of the ground's light, what the layer leaves for the ground to send back.
  double groundShare() {
    if (!groundShare_ || !clouds::isSameField(shared_, clouds_, 0)) {
      groundShare_ = clouds::SkyCover(noise_, clouds_).meanShare();
      shared_ = clouds_;
    }
    return *groundShare_;
  }

  // The scene's light, bottom row first. The frame's clouds are those of clouds_.
  std::vector<glm::vec4> sceneFrom(const render::View& view) {
    system_->apply(clouds_, wind_);
    draw(view);
    return scene_;
  }
  // A ray a texel, bottom row first: radiance, and what comes through. The frame must have clouds in view.
  std::vector<glm::vec4> cloudsFrom(const render::View& view) {
    sceneFrom(view);
    EXPECT_FALSE(system_->skipReason(render::gameFrame(snapshot_, view, features_)));
    const render::gl::Texture& light = system_->light();
    std::vector<glm::vec4> texels(static_cast<std::size_t>(light.width() * light.height()));
    light.read(GL_RGBA, GL_FLOAT, std::as_writable_bytes(std::span(texels)));
    return texels;
  }

  clouds::CloudSettings clouds_;
  core::WindSettings wind_;
  render::CloudSystem* system_ = nullptr;

 private:
  std::vector<glm::vec4> scene_;
  std::shared_ptr<const clouds::PackedCloudNoise> noise_;
  std::optional<double> groundShare_;
  clouds::CloudSettings shared_;  // that it is of
};

}  // namespace skydrop::test
