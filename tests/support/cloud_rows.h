// Fixture of the hard cases of the clouds' pass (tests/stability/cases.json): small frames, and how pictures
// are judged.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "skydrop/core/shared.h"
#include "skydrop/render/sky/sky_pass.h"
#include "support/cloud_frame_test.h"
#include "support/plains_pass.h"
#include "support/temporary_folder.h"

namespace skydrop::test {

inline constexpr int kCloudRowsWidth = 64, kCloudRowsHeight = 36;

class CloudRowsGLTest : public CloudFrameTest {
 protected:
  void SetUp() override {
    CloudFrameTest::SetUp();
    clouds_.march = quickRows();
  }
  render::View small(const glm::dvec3& position, double yaw, double pitch) const {
    return pose(position, yaw, pitch, 0, kCloudRowsWidth, kCloudRowsHeight);
  }
  render::View below() const { return small({0, 600, 0}, 40, 14); }
  render::View inside() const { return small({3000, 2400, -2000}, 200, 2); }
  render::View above() const { return small({-4000, 4500, 1000}, 300, -12); }

  void addSky() { renderer().add(std::make_unique<render::SkyPass>(context())); }
  void addPlains() { renderer().add(std::make_unique<PlainsPass>(context(), folder_, plains_)); }
  std::vector<glm::vec4> withoutClouds(const render::View& view) {
    const clouds::CloudSettings kept = std::exchange(clouds_, switchedOff());
    const std::vector<glm::vec4> scene = sceneFrom(view);
    clouds_ = kept;
    return scene;
  }

  static clouds::CloudSettings switchedOff() {
    clouds::CloudSettings off;
    off.tier = clouds::CloudTier::off;
    return off;
  }

  // As the tone map shows it, encoded: 1 is the whole range.
  static glm::vec3 shown(const glm::vec4& light) {
    return core::shared::f32::srgbEncode(core::shared::f32::toneMap(glm::vec3(light)));
  }
  // Largest difference of two scenes' pictures in 255ths of the range; not a number counts as all of it.
  static double difference(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
    double worst = a.size() == b.size() ? 0 : 255;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
      const glm::vec3 apart = glm::abs(shown(a[i]) - shown(b[i])) * 255.0f;
      for (int c = 0; c < 3; ++c) worst = std::max(worst, std::isfinite(apart[c]) ? apart[c] : 255.0);
    }
    return worst;
  }
  // Mean difference, likewise.
  static double meanDifference(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
    if (a.size() != b.size()) return 255;
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const glm::vec3 apart = glm::abs(shown(a[i]) - shown(b[i])) * 255.0f;
      for (int c = 0; c < 3; ++c) sum += std::isfinite(apart[c]) ? apart[c] : 255.0;
    }
    return sum / (3 * static_cast<double>(a.size()));
  }
  static double meanOpacity(const std::vector<glm::vec4>& rays) {
    double sum = 0;
    for (const glm::vec4& ray : rays) sum += 1 - ray.w;
    return sum / static_cast<double>(rays.size());
  }
  static bool areFinite(const std::vector<glm::vec4>& rays) {
    return std::ranges::all_of(rays, [](const glm::vec4& ray) {
      return std::isfinite(ray.x) && std::isfinite(ray.y) && std::isfinite(ray.z) && std::isfinite(ray.w);
    });
  }

  TemporaryFolder folder_;
  std::vector<Plain> plains_;
};

}  // namespace skydrop::test
