// Clouds lit by a light volume: frames wait for it or do without, and it is the one of the layers that are
// drawn.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>
#include <tuple>

#include "render/clouds/light_volumes.h"
#include "skydrop/core/wind.h"
#include "support/cloud_layers.h"
#include "support/margin.h"
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
  // As the next frame of a flight with these clouds.
  std::vector<glm::vec4> following() {
    system_->apply(clouds_, wind_);
    FrameInput frame = gameFrame(snapshot_, below(), features_);
    frame.followsLast = true;
    draw(frame);
    const gl::Texture& light = system_->light();
    std::vector<glm::vec4> texels(static_cast<std::size_t>(light.width() * light.height()));
    light.read(GL_RGBA, GL_FLOAT, std::as_writable_bytes(std::span(texels)));
    return texels;
  }
  // Those of the next frames that differ from the one before, up to one of which all is as in `end`.
  std::vector<std::vector<glm::vec4>> followedUntil(const std::vector<glm::vec4>& end) {
    std::vector<std::vector<glm::vec4>> seen = {following()};
    const auto begin = std::chrono::steady_clock::now();
    while (seen.back() != end && std::chrono::steady_clock::now() - begin < std::chrono::minutes(2)) {
      std::vector<glm::vec4> now = following();
      if (now == seen.back())
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
      else
        seen.push_back(std::move(now));
    }
    return seen;
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

TEST_F(CloudLightVolumeGLTest, aFlightBeginsInEvenLightAndHasItsSurroundingsFirst) {
  // Frames that follow others wait for nothing: the first has even light, the next that differs a sketch,
  // nearer to what a frame has that waited, and the last just that. No program is made on the way.
  addClouds(test::sharedNoise());
  const auto waited = lit(CloudLight::volume, below());
  lit(CloudLight::octaves, below());  // forgets it
  clouds_.light = CloudLight::volume;
  const std::uint64_t programs = renderer().shaders().madeSoFar();
  const std::vector<std::vector<glm::vec4>> seen = followedUntil(waited);
  EXPECT_EQ(renderer().shaders().madeSoFar(), programs);
  ASSERT_GT(seen.size(), 2u);
  EXPECT_EQ(seen.back(), waited);
  for (const glm::vec4& ray : seen[0]) ASSERT_TRUE(std::isfinite(ray.x) && ray.x >= 0);
  const double even = apart(seen[0], waited), surroundings = apart(seen[1], waited);
  RecordProperty("evenLight", std::to_string(even));
  RecordProperty("surroundings", std::to_string(surroundings));
  EXPECT_LT(surroundings, 0.6 * even);
}

TEST_F(CloudLightVolumeGLTest, itMayGoWhileLayersAreSolved) {
  // Ten times, at other moments: what is unsolved is not put together.
  addClouds(test::sharedNoise());
  setWeather({kCumulus, {weather::Genus::nimbostratus, 4200, 6500, 1, 1}});
  for (int i = 0; i < 10; ++i) {
    clouds_.light = CloudLight::volume;
    following();
    std::this_thread::sleep_for(std::chrono::milliseconds(10 * i));
    clouds_.light = CloudLight::octaves;
    following();
  }
}

TEST_F(CloudLightVolumeGLTest, aSunThatMovesTurnsTheLightByDegrees) {
  // Two degrees: in no frame by more than .3 of the whole way, and by it in the end.
  addClouds(test::sharedNoise());
  const auto towards = [&](double elevation) {
    settings_.sun.elevationDegrees = elevation;
    renderer().apply(settings_);
  };
  const double elevation = settings_.sun.elevationDegrees;
  towards(elevation + 2);
  const auto after = lit(CloudLight::volume, below());
  towards(elevation);
  lit(CloudLight::volume, below());
  towards(elevation + 2);  // the sun's own light is the new one, the volume the old
  const std::vector<std::vector<glm::vec4>> seen = followedUntil(after);
  ASSERT_GT(seen.size(), 8u);
  EXPECT_EQ(seen.back(), after);
  const double way = apart(seen[0], after);
  EXPECT_GT(way, 1e-3);
  double most = 0;
  for (std::size_t i = 1; i < seen.size(); ++i) most = std::max(most, apart(seen[i], seen[i - 1]));
  RecordProperty("mostOfTheWay", std::to_string(most / way));
  EXPECT_LT(most, 0.3 * way);
}

TEST_F(CloudLightVolumeGLTest, coarseCellsTakeAQuarterOfTheMemory) {
  // 1 MiB for a layer, 4 MiB of fine ones: four layers have the 16 MiB that are promised.
  using clouds::LightCells;
  addClouds(test::sharedNoise());
  const auto bytesWith = [&](CloudLight light, LightCells cells) {
    clouds_.march.lightCells = cells;
    lit(light, below());
    return context().resources().bytes();
  };
  const std::uint64_t without = bytesWith(CloudLight::octaves, LightCells::coarse);
  EXPECT_EQ(bytesWith(CloudLight::volume, LightCells::coarse) - without, 1u << 20);
  EXPECT_EQ(bytesWith(CloudLight::volume, LightCells::fine) - without, 4u << 20);
}

TEST_F(CloudLightVolumeGLTest, whatIsNearStandsForTheOther) {
  const clouds::LayerMedium layer = clouds::mediumOf(clouds_, 0);
  const glm::dvec3 toSun = toRoundedSun({60, 100});
  const LightVolumesKey key = lightVolumesKey(layer, toSun, clouds::LightCells::fine);
  EXPECT_TRUE(isNear(key, key));
  EXPECT_TRUE(isNear(key, lightVolumesKey(layer, toRoundedSun({66, 102}), clouds::LightCells::fine)));
  EXPECT_FALSE(isNear(key, lightVolumesKey(layer, toRoundedSun({60, 120}), clouds::LightCells::fine)));
  EXPECT_FALSE(isNear(key, lightVolumesKey(layer, toSun, clouds::LightCells::coarse)));
  clouds::LayerMedium other = layer;
  other.layer.coverage += 0.1;
  other.layer.extinction *= 1.1;
  EXPECT_TRUE(isNear(key, lightVolumesKey(other, toSun, clouds::LightCells::fine)));
  other.layer.coverage += 0.1;
  EXPECT_FALSE(isNear(key, lightVolumesKey(other, toSun, clouds::LightCells::fine)));
  other = layer;
  other.layer.scale *= 1.01;
  EXPECT_FALSE(isNear(key, lightVolumesKey(other, toSun, clouds::LightCells::fine)));
  EXPECT_FALSE(isNear(key, lightVolumesKey(layer, {1, -0.1, 0}, clouds::LightCells::fine)));
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

TEST_F(CloudLightVolumeGLTest, C89_lightGoesWithTheCloudsForThirtyDays) {
  // The same cloud 30 days of wind later and 1e9 m to the north, seen from where it has come to: no pixel by
  // more than 2 of 255. Without erosion, whose noise has another period.
  addClouds(test::sharedNoise());
  clouds_.layers[0].erosion = 0;
  wind_.speed = 10;
  wind_.direction = 270;
  clouds_.light = CloudLight::volume;
  const auto before = sceneFrom(below());
  snapshot_.simulatedSeconds = 30 * 86400.0;
  const glm::dvec2 drift = core::windDrift(wind_, snapshot_.simulatedSeconds);
  ASSERT_GT(glm::length(drift), 2e7);
  View later = below();
  later.position += glm::dvec3(drift.x, 0, drift.y);
  const double period = clouds::weatherPeriod(clouds::mediumOf(clouds_, 0));
  later.position.z -= std::round(1e9 / period) * period;
  EXPECT_TRUE(test::holds("C89", difference(sceneFrom(later), before), test::atMost(2), "of 255"));
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
