#include "skydrop/render/models/marker_pass.h"

#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "skydrop/core/hash.h"
#include "skydrop/core/shared.h"
#include "skydrop/render/frame/tone_map_pass.h"
#include "support/frame_test.h"
#include "support/light_probe.h"
#include "support/margin.h"
#include "support/plains_pass.h"

namespace skydrop::render {
namespace {

namespace shared = core::shared::f64;

const glm::vec3 kGround(0.25f, 0.5f, 0.125f);  // exact in half floats

class MarkerGLTest : public test::FrameTest {
 protected:
  void SetUp() override {
    FrameTest::SetUp();
    if (IsSkipped()) return;
    renderer().add(std::make_unique<test::PlainsPass>(context(), folder_, plains_));
    renderer().add(std::make_unique<MarkerPass>(context()));
    renderer().add(std::make_unique<test::LightProbe>(light_));
    renderer().add(std::make_unique<ToneMapPass>(context()));
    features_.haze = false;
    target({0, 0, 0});
  }

  void target(const glm::dvec3& position) {
    snapshot_.target.present = true;
    snapshot_.target.position = position;
    snapshot_.target.radius = 100;
  }

  // A view that looks from `eye` at `at`.
  View lookAt(const glm::dvec3& eye, const glm::dvec3& at, double roll = 0) const {
    const glm::dvec3 d = glm::normalize(at - eye);
    return pose(eye, glm::degrees(std::atan2(d.z, d.x)), glm::degrees(std::asin(d.y)), roll);
  }

  core::PassStatistics statistics() {
    core::FrameStatistics all;
    renderer().fillStatistics(all);
    for (const auto& [name, row] : all.passes) {
      if (name == "marker") return row;
    }
    ADD_FAILURE() << "no such pass";
    return {};
  }

  struct Difference {
    double largest = 0, sum = 0;
    int marked = 0;  // pixels that show something of the mark
    int pixels = 0;
  };
  // Draws; `shares_` is then how much of the mark's colour each pixel shows over what was there: 0 to 1,
  // within 2e-3 (half floats).
  void drawShares(const View& view) {
    snapshot_.target.present = false;
    draw(view);
    const std::vector<glm::vec4> behind = light_;
    snapshot_.target.present = true;
    draw(view);
    const SkyLight sky = skyLight(settings_, view.position.y);
    const glm::vec3 signal(signalRadiance(sky) * sky.exposure);
    shares_.resize(light_.size());
    for (std::size_t i = 0; i < light_.size(); ++i) {
      // In the channel in which the two differ most.
      const int c = std::abs(signal.x - behind[i].x) > std::abs(signal.y - behind[i].y) ? 0 : 1;
      shares_[i] = static_cast<double>((light_[i][c] - behind[i][c]) / (signal[c] - behind[i][c]));
    }
  }

  // Ring and beam of every pixel against the same functions in double, on a flat plain.
  void compareWithPlain(const View& view, Difference& ring, Difference& beam) {
    drawShares(view);
    const glm::dvec3 foot = snapshot_.target.position - view.position;
    const glm::dvec3 onAxis(foot.x, std::clamp(0.0, foot.y, foot.y + shared::kBeamHeight), foot.z);
    const double radius = shared::beamRadius(glm::length(onAxis), view.pixelAngleRad());
    const glm::dmat3 rays = rayMatrix(view);
    const auto rayThrough = [&](double x, double y) {
      return glm::normalize(rays * glm::dvec3(2 * x / view.width - 1, 2 * y / view.height - 1, 1));
    };
    const auto toGround = [&](const glm::dvec3& ray) {
      const double distance = (plains_[0].heightM - view.position.y) / ray.y;
      return distance > 0 ? distance : shared::kFarMarker;
    };
    const auto fromMiddle = [&](double x, double y) {
      const glm::dvec3 ray = rayThrough(x, y), place = ray * toGround(ray) - foot;
      return std::hypot(place.x, place.z);
    };
    const double fade = shared::ringFade(plains_[0].heightM - snapshot_.target.position.y, 100);
    for (int row = 0; row < view.height; ++row) {
      for (int column = 0; column < view.width; ++column) {
        const double x = column + 0.5, y = row + 0.5;
        const glm::dvec3 ray = rayThrough(x, y);
        const double ground = toGround(ray);
        const glm::dvec2 t = shared::beamInterval(ray, foot, radius);
        const double end = std::min(t.y, ground);
        const double opacity =
            end > t.x ? shared::beamOpacity(shared::beamOpticalDepth(ray, foot, radius, t.x, end)) : 0;
        const double distance = fromMiddle(x, y);
        double covered = 0;
        if (fade > 0 && distance < 250) {
          covered = fade * shared::ringCoverage(distance, 100,
                                                std::hypot(fromMiddle(x + 0.5, y) - fromMiddle(x - 0.5, y),
                                                           fromMiddle(x, y + 0.5) - fromMiddle(x, y - 0.5)));
        }
        const double expected = 1 - (1 - covered) * (1 - opacity);
        const double difference = std::abs(shareAt(column, row) - expected);
        ASSERT_TRUE(std::isfinite(difference));
        Difference& part = opacity > 0 ? beam : ring;
        part.largest = std::max(part.largest, difference);
        part.sum += difference;
        part.marked += expected > 0.1;
        ++part.pixels;
      }
    }
  }
  double shareAt(int x, int y) const { return shares_[static_cast<std::size_t>(y * 320 + x)]; }

  test::TemporaryFolder folder_;
  std::vector<glm::vec4> light_;
  std::vector<double> shares_;
  std::vector<test::Plain> plains_ = {{0, kGround}};
};

TEST_F(MarkerGLTest, ringAndBeamStandWhereTheTargetDoes) {
  // Every pixel against the ray, the plain and the shapes in double, from above, aside, rolled, from within
  // the ring and with the target off the middle. The GPU takes the ring's footprints over 2 x 2 pixels, which
  // moves a pixel of its edge by up to 0.024 of the mark's light: within 0.05, and 2e-4 on average. The
  // beam's pixels are within that of the ring behind them, and on average within a half float's step (5e-4).
  target({1000, 0, -500});
  for (const View& view :
       {lookAt({1150, 400, -500}, {1000, 0, -500}), lookAt({800, 90, -500}, {1030, 40, -480}, 50),
        lookAt({1000, 40, -470}, {1020, 20, -540}), lookAt({400, 500, -900}, {1100, 200, -560}, 180),
        pose({1030, 250, -520}, 20, -90, 0)}) {
    Difference ring, beam;
    compareWithPlain(view, ring, beam);
    EXPECT_GT(ring.marked, 100);
    EXPECT_GT(beam.marked, 20);
    EXPECT_LT(ring.largest, 0.05);
    EXPECT_LT(ring.sum / ring.pixels, 2e-4);
    EXPECT_LT(beam.largest, 0.05);
    EXPECT_LT(beam.sum / beam.pixels, 5e-4);
  }
}

TEST_F(MarkerGLTest, beamIsRightFromHardPlaces) {
  // From inside, on the axis straight above looking down, below the foot looking up, right on the foot and at
  // the top: each pixel within 2e-3 (half floats) of the same functions in double, and nothing is infinite.
  plains_[0].heightM = -500;  // no ring
  for (const View& view :
       {pose({2, 100, 1}, 30, 10, 0), pose({0, 900, 0}, 0, -90, 0), pose({0, -60, 0}, 0, 90, 0),
        pose({0, 0, 0}, 0, 80, 0), pose({0, 600, 0}, 0, -80, 90), pose({4.9999, 200, 0}, 180, 0, 0)}) {
    Difference ring, beam;
    compareWithPlain(view, ring, beam);
    EXPECT_EQ(statistics().skipped, "");
    EXPECT_GT(beam.marked, 3) << view.position.y;
    EXPECT_LT(beam.largest, 2e-3) << view.position.y;
    EXPECT_EQ(ring.marked, 0);
    EXPECT_LT(ring.largest, 2e-3) << view.position.y;
  }
}

TEST_F(MarkerGLTest, nothingInViewIsLeftOut) {
  // From 60 random places in and around the mark, in every attitude: ring and beam are seen wherever they
  // must be seen, all of them. (Within 0.1: where an eye near the ground grazes it, footprints are steep.)
  core::RandomStream random{21, 0};
  int seen = 0;
  for (int i = 0; i < 60; ++i) {
    const glm::dvec3 eye(random.nextUnit() * 300 - 150, 3 + random.nextUnit() * random.nextUnit() * 700,
                         random.nextUnit() * 300 - 150);
    Difference ring, beam;
    compareWithPlain(
        pose(eye, random.nextUnit() * 360, random.nextUnit() * 180 - 90, random.nextUnit() * 360), ring,
        beam);
    EXPECT_LT(ring.largest, 0.1) << i;
    EXPECT_LT(beam.largest, 0.1) << i;
    seen += ring.marked + beam.marked > 0;
  }
  EXPECT_GT(seen, 20);
}

TEST_F(MarkerGLTest, beamIsSeenFromSixKilometres) {
  // At 320 x 180, in the row through its densest place, at least two pixels show half of its colour or more,
  // and no more than four: a thin line. The ring, a tenth of a pixel across by then, is gone.
  const double third = shared::kBeamHeight / 3;
  Difference ring, beam;
  compareWithPlain(lookAt({-6000, third, 0}, {0, third, 0}), ring, beam);
  int lit = 0;
  for (int x = 0; x < 320; ++x) lit += shareAt(x, 90) > shared::kBeamOpacity / 2;
  EXPECT_GE(lit, 2);
  EXPECT_LE(lit, 4);
  EXPECT_EQ(ring.marked, 0);
}

TEST_F(MarkerGLTest, nearerLandHidesTheMark) {
  // A plain at 200 m between the eye and a target on the ground: what is below it changes no pixel, what
  // stands out of it does; a plain above all of the beam hides all.
  plains_[0].heightM = 200;
  Difference ring, beam;
  compareWithPlain(lookAt({-700, 350, 0}, {0, 150, 0}), ring, beam);
  EXPECT_GT(beam.marked, 20);
  EXPECT_LT(beam.largest, 4e-3);
  EXPECT_EQ(ring.marked, 0);
  plains_[0].heightM = shared::kBeamHeight + 1;
  draw(lookAt({-700, 800, 0}, {0, 0, 0}));
  EXPECT_EQ(statistics().draws, 2);
  for (const glm::vec4& light : light_) ASSERT_EQ(glm::vec3(light), kGround);
}

TEST_F(MarkerGLTest, itIsIdleWithoutATargetInView) {
  // No target, one behind the camera, beside it, or too far to be as tall as a pixel: the reason is named and
  // nothing is drawn.
  const View view = pose({0, 50, 0}, 0, 0, 0);
  const auto reason = [&](bool present, const glm::dvec3& position) {
    target(position);
    snapshot_.target.present = present;
    draw(view);
    EXPECT_EQ(statistics().draws, 0);
    return statistics().skipped;
  };
  EXPECT_EQ(reason(false, {500, 0, 0}), "no target");
  EXPECT_EQ(reason(true, {-500, 0, 0}), "target out of view");
  EXPECT_EQ(reason(true, {500, 0, 1500}), "target out of view");
  EXPECT_EQ(reason(true, {1e9, 0, 0}), "target too far away");
  target({500, 0, 0});
  draw(view);
  EXPECT_EQ(statistics().skipped, "");
  EXPECT_EQ(statistics().draws, 2);
}

TEST_F(MarkerGLTest, T02_itIsTheSameFarFromTheOrigin) {
  // The same view of the same target at 1e9 m: equal in every bit, because positions are subtracted in double
  // and these are exact in it.
  test::noFaults("T02", "differences");
  features_.haze = true;
  const glm::dvec3 offset(1e9, 0, -1e9);
  target({0, 0, 0});
  draw(lookAt({-400, 200, 64}, {0, 50, 0}));
  const std::vector<glm::vec4> atOrigin = light_;
  target(offset);
  draw(lookAt(glm::dvec3(-400, 200, 64) + offset, glm::dvec3(0, 50, 0) + offset));
  EXPECT_EQ(light_, atOrigin);
  snapshot_.target.present = false;
  draw(lookAt({-400, 200, 64}, {0, 50, 0}));
  EXPECT_NE(light_, atOrigin);
}

TEST_F(MarkerGLTest, hazeVeilsTheBeamByHalfTheWay) {
  // From 6 km in 10 km of visibility, before a black sky: each pixel of the beam shows, by its opacity, the
  // mark's colour as air and haze on half the way leave it. Half floats hold 1e-3; within 1 % where the beam
  // covers a tenth of a pixel or more.
  settings_.atmosphere.visibilityM = 10000;
  const double third = shared::kBeamHeight / 3;
  const View view = lookAt({-6000, third, 0}, {0, third, 0});
  drawShares(view);
  features_.haze = true;
  draw(view);
  const SkyLight sky = skyLight(settings_, third);
  const glm::dvec3 kept = glm::exp(-shared::opticalDepthBetween(sky.air, third, third, 3000));
  const glm::dvec3 veiled =
      (signalRadiance(sky) * kept + skyRadiance(sky, view.forward()) * (1.0 - kept)) * sky.exposure;
  int judged = 0;
  for (int x = 0; x < 320; ++x) {
    if (shareAt(x, 90) < 0.1) continue;
    const glm::dvec3 light(light_[static_cast<std::size_t>(90 * 320 + x)]);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(light[c] / (veiled[c] * shareAt(x, 90)), 1, 0.01);
    ++judged;
  }
  EXPECT_GE(judged, 2);
}

TEST_F(MarkerGLTest, itReadsByDayAtDuskAndAtNight) {
  // The mark's light after exposure stays within what the tone map shows as orange: neither bleached (above
  // 1.6) nor lost (below 0.15), from noon to the darkest night; two stops more make it four times brighter.
  for (double elevation = -30; elevation <= 90; elevation += 2) {
    settings_.sun.elevationDegrees = elevation;
    const SkyLight light = skyLight(settings_, 500);
    const double red = signalRadiance(light).x * light.exposure;
    EXPECT_GT(red, 0.15) << elevation;
    EXPECT_LT(red, 1.6) << elevation;
  }
  const SkyLight before = skyLight(settings_, 500);
  settings_.exposureStops = 2;
  const SkyLight after = skyLight(settings_, 500);
  EXPECT_NEAR(signalRadiance(after).x * after.exposure, 4 * signalRadiance(before).x * before.exposure, 1e-9);
}

}  // namespace
}  // namespace skydrop::render
