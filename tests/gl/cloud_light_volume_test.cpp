// Clouds lit by a light volume: frames wait for it or do without, and it is the one of the layers that are
// drawn.
#include <algorithm>
#include <cmath>
#include <thread>
#include <tuple>

#include "render/clouds/light_volumes.h"
#include "support/cloud_layers.h"
#include "support/shared_noise.h"

namespace skydrop::render {
namespace {

using clouds::CloudLight;

class CloudLightVolumeGLTest : public test::CloudLayersGLTest {
 protected:
  std::vector<glm::vec4> lit(CloudLight light, const View& view) {
    clouds_.light = light;
    return cloudsFrom(view);
  }
  static double meanOf(const std::vector<glm::vec4>& rays) {
    double sum = 0;
    for (const glm::vec4& ray : rays) sum += static_cast<double>(ray.x + ray.y + ray.z);
    return sum / static_cast<double>(rays.size());
  }
  // RMS difference of light over the mean of b.
  static double apart(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
    double square = 0, sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double off = static_cast<double>(a[i].y - b[i].y);
      square += off * off;
      sum += static_cast<double>(b[i].y);
    }
    const auto count = static_cast<double>(a.size());
    return std::sqrt(square / count) / (sum / count);
  }
};

TEST_F(CloudLightVolumeGLTest, aFrameThatFollowsNoneWaitsForTheVolume) {
  // Its light is another than the octaves', through the same cloud; and each such frame has the same bits.
  addClouds(test::sharedNoise());
  const auto octaves = lit(CloudLight::octaves, below()), volume = lit(CloudLight::volume, below());
  EXPECT_GT(apart(volume, octaves), 0.05);
  for (std::size_t i = 0; i < volume.size(); ++i) {
    ASSERT_TRUE(std::isfinite(volume[i].x));
    ASSERT_EQ(volume[i].w, octaves[i].w);
  }
  EXPECT_EQ(lit(CloudLight::volume, below()), volume);
  EXPECT_EQ(lit(CloudLight::octaves, below()), octaves);
}

TEST_F(CloudLightVolumeGLTest, withOctavesNothingOfAVolumeIsThere) {
  addClouds(test::sharedNoise());
  const auto held = [&] {
    return std::tuple(context().resources().live(gl::ObjectKind::texture),
                      context().resources().live(gl::ObjectKind::buffer), context().resources().bytes());
  };
  lit(CloudLight::octaves, below());
  const auto without = held();
  lit(CloudLight::volume, below());
  EXPECT_GT(std::get<2>(held()), std::get<2>(without));
  lit(CloudLight::octaves, below());
  EXPECT_EQ(held(), without);
}

TEST_F(CloudLightVolumeGLTest, untilTheVolumeIsThereFlightHasTheOctaves) {
  // The first frame that follows another is that of the octaves, bit for bit; a later one is that of a frame
  // that waited.
  addClouds(test::sharedNoise());
  const auto octaves = lit(CloudLight::octaves, below());
  clouds_.light = CloudLight::volume;
  const auto following = [&] {
    system_->apply(clouds_, wind_);
    FrameInput frame = gameFrame(snapshot_, below(), features_);
    frame.followsLast = true;
    draw(frame);
    const gl::Texture& light = system_->light();
    std::vector<glm::vec4> texels(static_cast<std::size_t>(light.width() * light.height()));
    light.read(GL_RGBA, GL_FLOAT, std::as_writable_bytes(std::span(texels)));
    return texels;
  };
  EXPECT_EQ(following(), octaves);
  std::vector<glm::vec4> later = octaves;
  while (later == octaves) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    later = following();
  }
  EXPECT_EQ(later, lit(CloudLight::volume, below()));
}

TEST_F(CloudLightVolumeGLTest, aLayerOfTheWeatherIsLitAsThatOfTheSettings) {
  // The default layer as weather, at the middle of its range of cover: the volume adds at most .02 to what
  // the two differ by with octaves.
  addClouds(test::sharedNoise());
  clouds_.layers[0].coverage = 0.46875;
  const auto octaves = lit(CloudLight::octaves, below()), volume = lit(CloudLight::volume, below());
  auto cumulus = kCumulus;
  cumulus.cover = 0.46875;
  setWeather({cumulus});
  const double ofOctaves = apart(lit(CloudLight::octaves, below()), octaves),
               ofVolume = apart(lit(CloudLight::volume, below()), volume);
  RecordProperty("ofOctaves", std::to_string(ofOctaves));
  RecordProperty("ofVolume", std::to_string(ofVolume));
  EXPECT_LT(ofVolume, ofOctaves + 0.02) << ofOctaves;
}

TEST_F(CloudLightVolumeGLTest, layersShadeEachOthersVolumes) {
  // A cumulus below a nimbostratus is darker with the volume too than without anything above it.
  addClouds(test::sharedNoise());
  setWeather({kCumulus});
  const double alone = meanOf(lit(CloudLight::volume, inside()));
  setWeather({kCumulus, {weather::Genus::nimbostratus, 4200, 6500, 1, 1}});
  EXPECT_LT(meanOf(lit(CloudLight::volume, inside())), 0.7 * alone);
}

TEST_F(CloudLightVolumeGLTest, theExactMarchReadsItToo) {
  // It differs from the march of a ray a pixel by no more than .02 over what it does with octaves.
  addClouds(test::sharedNoise());
  const auto octaves = lit(CloudLight::octaves, below()), volume = lit(CloudLight::volume, below());
  clouds_.march = test::quickExactRows();
  clouds_.march.sunSamples = 24;
  const double ofOctaves = apart(lit(CloudLight::octaves, below()), octaves),
               ofVolume = apart(lit(CloudLight::volume, below()), volume);
  RecordProperty("ofOctaves", std::to_string(ofOctaves));
  RecordProperty("ofVolume", std::to_string(ofVolume));
  EXPECT_LT(ofVolume, ofOctaves + 0.02) << ofOctaves;
}

TEST_F(CloudLightVolumeGLTest, theSunIsRoundedToWhatItChanges) {
  // By a quarter of a degree of height at most; the horizon is below all that is lit.
  for (int i = 0; i < 90; ++i) {
    const double height = glm::radians(0.3 + i * 0.99), azimuth = glm::radians(i * 3.7);
    const glm::dvec3 toSun(std::cos(height) * std::cos(azimuth), std::sin(height),
                           std::cos(height) * std::sin(azimuth));
    EXPECT_LT(glm::distance(toRoundedSun(roundedSun(toSun)), toSun), glm::radians(0.6)) << i;
    EXPECT_GT(toRoundedSun(roundedSun(toSun)).y, 0);
  }
  EXPECT_EQ(roundedSun({1, 0, 0}), glm::ivec2(0));
  EXPECT_EQ(toRoundedSun({0, 0}).y, 0);
}

}  // namespace
}  // namespace skydrop::render
