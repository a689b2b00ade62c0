// Several layers of the weather in one march: against integrals in doubles over their sum, in the right
// order, without a seam, and functions of the state alone.
#include "support/cloud_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "skydrop/clouds/raised_sun.h"
#include "skydrop/clouds/reference_march.h"
#include "skydrop/core/shared_clouds.h"
#include "support/margin.h"
#include "support/shared_noise.h"

namespace skydrop::render {
namespace {

namespace f64 = core::shared::f64;
using clouds::CloudTier;

class CloudLayersGLTest : public test::CloudLayersGLTest {
 protected:
  std::array<View, 4> views() const {
    return {small({0, 600, 0}, 40, 14), small({0, 3700, 0}, 40, 1), small({3000, 2400, -2000}, 200, 8),
            small({-4000, 7500, 1000}, 300, -14)};
  }

  // What a ray gathers of the layers, by steps of one length in doubles: the sum of their extinctions, the
  // sun through all of them, and the light of those whose shells hold the place.
  struct Gathered {
    double transmittance = 1, depth = 0;
    double sun = 0;  // per illuminance, of all layers alike
  };
  Gathered gather(const Layers& layers, const clouds::MarchRay& ray, int steps, int sunSamples) const {
    std::vector<clouds::CloudField> fields;
    for (const auto& layer : layers)
      fields.emplace_back(test::sharedNoise(), game::cloudLayerOf(stateOf(layer)));
    clouds::MarchMedium medium = clouds::mediumOf(fields[0]);
    medium.fadeDistanceM = clouds_.fadeDistance;
    for (const auto& field : fields) {
      medium.baseM = std::min(medium.baseM, field.layer().cloudHeight);
      medium.topM = std::max(medium.topM, field.layer().cloudHeight + field.layer().thickness);
    }
    medium.extinction = [&](const glm::dvec3& place) {
      double sum = 0;
      for (const auto& field : fields) sum += field.density(place) * field.layer().extinction;
      return sum;
    };
    const clouds::CloudLayerSettings plain;
    const clouds::MarchResult found =
        clouds::referenceMarch(medium, {directionToSun(settings_.sun), plain.anisotropy, plain.forwardShare},
                               ray, {steps, sunSamples});
    return {found.transmittance, -std::log(std::max(found.transmittance, 1e-30)), found.sun};
  }
};

TEST_F(CloudLayersGLTest, W24_overlappingLayersAreTheSumOfTheirDensities) {
  // From below, between, inside and above, at each of a grid of rays: transmittance of the tier reference
  // within 2e-3 of the integral in doubles over the sum of the flown fields' densities. So density at a point
  // is the same on both sides, order is right, and where the shells overlap nothing is lost or counted twice.
  // (Steps of 4 to 24 m and half floats take 1e-3 of one layer: CloudReferenceGLTest.)
  clouds_.fadeDistance = 24000;
  addClouds(test::sharedNoise());
  clouds_.march = test::rowsOf(CloudTier::reference);
  const Layers layers = {kCumulus, kAltocumulus, {weather::Genus::stratocumulus, 2600, 3800, 0.5, 1}};
  setWeather(layers);
  int clouded = 0;
  double worst = 0;
  for (const View& view : views()) {
    const std::vector<glm::vec4> found = cloudsFrom(view);
    for (int y = 3; y < view.height; y += 8) {
      for (int x = 4; x < view.width; x += 14) {
        const clouds::MarchRay ray{view.position, rayDirection(view, {x + 0.5, y + 0.5})};
        const double exact = gather(layers, ray, 8192, 1).transmittance;
        const double through = static_cast<double>(found[static_cast<std::size_t>(y * view.width + x)].w);
        worst = std::max(worst, std::abs(through - exact));
        EXPECT_TRUE(test::holds("W24", test::apart(through, exact), test::atMost(2e-3), "transmittance"))
            << "pixel " << x << ' ' << y;
        clouded += exact < 0.99;
      }
    }
  }
  EXPECT_GE(clouded, 40) << "proves little";
  RecordProperty("worstTransmittance", std::to_string(worst));
}

TEST_F(CloudLayersGLTest, oneLayerShadesTheOther) {
  // Cumulus from above below an even deck: the sun's light that reaches the eye is that of the march in
  // doubles with both between the cumulus and the sun, and less than half of that without the deck.
  clouds_.fadeDistance = 24000;
  addClouds(test::sharedNoise());
  clouds_.march = test::rowsOf(CloudTier::reference);
  const weather::WeatherLayerSettings deck{weather::Genus::altostratus, 5200, 6200, 1, 2};
  const View view = small({-4000, 4200, 1000}, 300, -20);
  setWeather({kCumulus});
  const std::vector<glm::vec4> alone = cloudsFrom(view);
  setWeather({kCumulus, deck});
  const std::vector<glm::vec4> below = cloudsFrom(view);
  int judged = 0;
  for (int y = 2; y < view.height; y += 5) {
    for (int x = 3; x < view.width; x += 9) {
      const auto at = static_cast<std::size_t>(y * view.width + x);
      if (alone[at].w > 0.5f) continue;
      const clouds::MarchRay ray{view.position, rayDirection(view, {x + 0.5, y + 0.5})};
      const double shaded = gather({kCumulus, deck}, ray, 1024, 64).sun,
                   lit = gather({kCumulus}, ray, 1024, 64).sun;
      // Light of sky and ground is in both pictures: bounded by it.
      const double ofSun = (static_cast<double>(alone[at].x) - static_cast<double>(below[at].x)) /
                           static_cast<double>(alone[at].x);
      EXPECT_GT(ofSun, 0.5 * (1 - shaded / lit)) << x << ' ' << y;
      EXPECT_LT(ofSun, 1) << x << ' ' << y;
      ++judged;
    }
  }
  EXPECT_GE(judged, 10) << "proves little";
}

TEST_F(CloudLayersGLTest, tiersAreNearTheReferenceWithSeveralLayers) {
  // As of one layer (CloudMarchGLTest): relative error and bias of radiance of three layers that overlap.
  clouds_.fadeDistance = 24000;
  addClouds(test::sharedNoise());
  setWeather({kCumulus, kAltocumulus, {weather::Genus::altostratus, 4500, 6000, 0.6, 1}});
  struct Limit {
    CloudTier tier;
    double error, bias;
  };
  for (const View& small : views()) {
    View view = small;
    view.width = 120;
    view.height = 68;
    clouds_.march = test::rowsOf(CloudTier::reference);
    const std::vector<glm::vec4> reference = cloudsFrom(view);
    for (const Limit& limit : {Limit{CloudTier::low, 0.25, 0.04}, Limit{CloudTier::high, 0.08, 0.02},
                               Limit{CloudTier::ultra, 0.03, 0.01}}) {
      clouds_.march = test::rowsOf(limit.tier);
      clouds_.march.farStartM = 60000;
      const std::vector<glm::vec4> rays = cloudsFrom(view);
      double error = 0, whole = 0, sum = 0, expected = 0;
      for (std::size_t i = 0; i < rays.size(); ++i) {
        if (reference[i].w > 0.99f) continue;
        const glm::dvec3 a(rays[i]), b(reference[i]);
        error += glm::dot(a - b, a - b);
        whole += glm::dot(b, b);
        sum += a.x + a.y + a.z;
        expected += b.x + b.y + b.z;
      }
      const double relative = std::sqrt(error / whole), bias = sum / expected - 1;
      EXPECT_LT(relative, limit.error) << "tier " << static_cast<int>(limit.tier);
      EXPECT_LT(std::abs(bias), limit.bias) << "tier " << static_cast<int>(limit.tier);
    }
  }
}

TEST_F(CloudLayersGLTest, bothFormsOfTheLoopsGiveTheSamePictureOfLayers) {
  // Every bit, of one to four layers.
  addClouds(test::sharedNoise());
  const Layers all = {kCumulus, kAltocumulus, kNimbostratus, kTower};
  for (std::size_t count = 1; count <= all.size(); ++count) {
    setWeather(Layers(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)));
    for (const CloudTier tier : {CloudTier::low, CloudTier::high}) {
      clouds_.march = test::rowsOf(tier);
      for (const View& view : views()) {
        system_->setFlatLoops(true);
        const std::vector<glm::vec4> flat = cloudsFrom(view);
        EXPECT_TRUE(areFinite(flat));
        system_->setFlatLoops(false);
        EXPECT_EQ(cloudsFrom(view), flat) << count << " layers, tier " << static_cast<int>(tier);
      }
    }
  }
}

TEST_F(CloudLayersGLTest, W20_layersWithoutCoverAreNotThere) {
  // None of both, under ice that is not drawn as a volume: no dispatch, and a reason. One of two: the picture
  // of the other alone.
  addClouds(test::sharedNoise());
  weather::WeatherLayerSettings none = kCumulus, faint = kAltocumulus;
  none.cover = 0;
  setWeather({none, none, {weather::Genus::cirrus, 9000, 10000, 0.5, 1}});
  sceneFrom(below());
  EXPECT_EQ(skipReasonOf(below()), "no cloud anywhere");
  setWeather({kCumulus});
  const std::vector<glm::vec4> alone = cloudsFrom(below());
  setWeather({none, kCumulus});
  EXPECT_EQ(difference(cloudsFrom(below()), alone), 0);
  faint.cover = 1e-9;
  setWeather({kCumulus, faint});
  const std::vector<glm::vec4> withFaint = cloudsFrom(below());
  EXPECT_TRUE(areFinite(withFaint));
  EXPECT_TRUE(test::holds("W20", difference(withFaint, alone), test::below(1), "of 255"));
}

TEST_F(CloudLayersGLTest, W21_twoIdenticalLayersAreOneOfTwiceTheDensity) {
  // Transmittance within a half float's digits, light within 2 % of the brightest (what clouds leave of the
  // ground's light is not quite the same).
  addClouds(test::sharedNoise());
  clouds_.march = test::rowsOf(CloudTier::reference);
  for (const View& view : {below(), above()}) {
    weather::WeatherLayerSettings twice = kCumulus;
    twice.density = 2;
    setWeather({twice});
    const std::vector<glm::vec4> one = cloudsFrom(view);
    setWeather({kCumulus, kCumulus});
    const std::vector<glm::vec4> two = cloudsFrom(view);
    float brightest = 0;
    for (const glm::vec4& ray : one) brightest = std::max(brightest, ray.y);
    for (std::size_t i = 0; i < one.size(); ++i) {
      ASSERT_TRUE(test::holds("W21", test::apart(two[i].w, one[i].w), test::atMost(2e-3), "transmittance"))
          << i;
      ASSERT_TRUE(
          test::holds("W21", test::apart(two[i].y, one[i].y), test::atMost(0.02f * brightest), "light"))
          << i;
    }
  }
}

TEST_F(CloudLayersGLTest, W22_landWithinALayerHidesWhatIsBeyond) {
  // Land at 4450 m, within the upper of two layers, seen from above: the lower layer is not there.
  addClouds(test::sharedNoise());
  plains_ = {{4450, glm::vec3(0.3f)}};
  addPlains();
  weather::WeatherLayerSettings none = kCumulus;
  none.cover = 0;
  const View down = small({0, 6000, 0}, 40, -50);
  setWeather({none, kAltocumulus});
  const std::vector<glm::vec4> upper = cloudsFrom(down);
  setWeather({kCumulus, kAltocumulus});
  const std::vector<glm::vec4> both = cloudsFrom(down);
  for (std::size_t i = 0; i < both.size(); ++i)
    ASSERT_TRUE(test::holds("W22", test::apart(both[i].w, upper[i].w), test::atMost(1e-3), "transmittance"))
        << i;
}

TEST_F(CloudLayersGLTest, W23_theEyeOnABoundaryOfAnyLayerSeesWhatIsBesideIt) {
  // On bases and tops, and a hair beside them: finite, and pictures differ by less than 3 of 255.
  addClouds(test::sharedNoise());
  clouds_.march = test::rowsOf(CloudTier::high);
  setWeather({kCumulus, {weather::Genus::stratocumulus, 3000, 3800, 0.6, 1}, kAltocumulus});
  for (const double height : {1555.0, 3355.0, 3000.0, 3800.0, 4200.0, 4700.0}) {
    for (const double pitch : {-8.0, 0.0, 8.0}) {
      const std::vector<glm::vec4> on = cloudsFrom(small({0, height, 0}, 40, pitch));
      EXPECT_TRUE(areFinite(on));
      for (const double beside : {-1e-3, 1e-3}) {
        EXPECT_TRUE(test::holds("W23",
                                meanDifference(cloudsFrom(small({0, height + beside, 0}, 40, pitch)), on),
                                test::below(0.2), "of 255"))
            << height << ' ' << pitch;
      }
    }
  }
}

TEST_F(CloudLayersGLTest, W25_theRangeOfAnOccupancyIsNotSeen) {
  // Cover and base on both sides of where the next occupancy begins: pictures differ by less than .5 of 255
  // in the mean, as far inside a range they do for as small a change.
  addClouds(test::sharedNoise());
  clouds_.march = test::rowsOf(CloudTier::high);
  const auto with = [&](double cover, double base) {
    setWeather({{weather::Genus::cumulus, base, base + 1800, cover, 1}, kAltocumulus});
    return sceneFrom(below());
  };
  EXPECT_TRUE(test::holds("W25", meanDifference(with(0.5 - 1e-6, 1555), with(0.5 + 1e-6, 1555)),
                          test::below(0.5), "of 255"));
  EXPECT_TRUE(test::holds("W25", meanDifference(with(0.45, 1574.999), with(0.45, 1575.001)), test::below(0.5),
                          "of 255"));
}

TEST_F(CloudLayersGLTest, W26_layersAFullTurnAwayAreTheSame) {
  // 1e9 m out: finite, and a frame again is the same bits.
  test::noFaults("W26", "differences");
  addClouds(test::sharedNoise());
  clouds_.march = test::rowsOf(CloudTier::high);
  setWeather({kCumulus, kAltocumulus, kTower});
  const View far = small({1e9, 600, -1e9}, 40, 14);
  const std::vector<glm::vec4> first = cloudsFrom(far);
  EXPECT_TRUE(areFinite(first));
  EXPECT_GT(meanOpacity(first), 0.05);
  for (int i = 0; i < 20; ++i) ASSERT_EQ(cloudsFrom(far), first) << "frame " << i;
}

TEST_F(CloudLayersGLTest, W27_aFrameIsAFunctionOfItsState) {
  // However the weather came to it: straight away, or through minutes of change with work made ahead.
  test::noFaults("W27", "differences");
  addClouds(test::sharedNoise());
  clouds_.march = test::rowsOf(CloudTier::low);
  weather::WeatherSettings settings;
  settings.secondSite = true;
  settings.approachSeconds = 600;
  settings.sites[0].layers[0] = kCumulus;
  settings.sites[1].layers[0] = {weather::Genus::cumulus, 1255, 2855, 0.9, 1};
  settings.sites[1].layers[1] = kAltocumulus;
  const View view = below();
  setWeather(settings);
  snapshot_.weather.seconds = 300;
  const std::vector<glm::vec4> straight = sceneFrom(view);
  for (int i = 0; i <= 30; ++i) {
    snapshot_.weather.seconds = 10 * i;
    FrameInput frame = gameFrame(snapshot_, view, features_);
    frame.followsLast = true;
    draw(frame);
  }
  EXPECT_EQ(sceneFrom(view), straight);
}

}  // namespace
}  // namespace skydrop::render
