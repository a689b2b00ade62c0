// What water mirrors by a picture of its own from the mirrored eye: what the processor's rays meet, also out
// of the picture, undersides, nothing from below the sea, and nothing of it where nobody asks.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "skydrop/render/terrain/terrain_pass.h"
#include "support/lagoon_gl_test.h"
#include "support/margin.h"
#include "support/mirrored_rays.h"

namespace skydrop::app {
namespace {

using render::gl::ObjectKind;

constexpr glm::dvec2 kBeforeAMountain(171600, 4300);
constexpr const char* kPlane = "waterDetail.mirror=plane";

// Of what is held on the graphics side; programs are kept by the renderer's cache.
struct Held {
  std::int64_t textures = 0, frameBuffers = 0, buffers = 0;
  std::uint64_t bytes = 0;
  bool operator==(const Held&) const = default;
};

class WaterMirrorGLTest : public test::LagoonGLTest {
 protected:
  // One ray of a calm sea for each pixel.
  void beginCalm() {
    begin({"wind.speed=0", "waterDetail.reflection=full", "waterDetail.reflectionSteps=256",
           "waterDetail.reflectionRays=1", "waterDetail.foam=0", "effects.haze=false",
           "render.sun.elevationDegrees=50", "render.sun.azimuthDegrees=290", kPlane});
  }
  // The settings have a camera of their own.
  void set(const std::string& assignment) {
    SceneGLTest::set(assignment);
    sceneRenderer_->camera().setMode(render::CameraMode::free);
  }
  core::FrameStatistics statistics() {
    core::FrameStatistics statistics;
    sceneRenderer_->writeTo(statistics);
    return statistics;
  }
  core::PassStatistics passOf(std::string_view pass) {
    frame();
    for (const auto& [name, row] : statistics().passes)
      if (name == pass) return row;
    return {.skipped = "absent"};
  }
  Held held() {
    const auto& resources = context().resources();
    return {resources.live(ObjectKind::texture), resources.live(ObjectKind::frameBuffer),
            resources.live(ObjectKind::buffer), resources.bytes()};
  }
  // Of the calm sea as it is now, with what it mirrors by this setting.
  test::MirrorAgreement agreement(const std::string& mirror, int aside) {
    const render::View view = sceneRenderer_->view(snapshot_, kSize);
    set("waterDetail.reflection=off");
    const std::vector<float> without = light();
    set("waterDetail.reflection=full");
    set("waterDetail.mirror=" + mirror);
    const test::MirrorAgreement found =
        test::mirrorAgreement(view, *simulation_->ground(), light(), without, aside);
    std::printf("[ mirror ] %s: %d of %d agree; %d of %d that meet land\n", mirror.c_str(), found.agree,
                found.asked, found.found, found.meet);
    return found;
  }
  // How many pixels of the lower half an aircraft changes, by a hundredth of their light or more.
  int changedByAircraft(const glm::dvec3& place) {
    snapshot_.aircraft.present = false;
    const std::vector<float> without = light();
    snapshot_.aircraft.present = true;
    snapshot_.aircraft.position = place;
    snapshot_.aircraft.orientation = glm::dquat(1, 0, 0, 0);
    const std::vector<float> with = light();
    int changed = 0;
    for (std::size_t i = with.size() / 2; i < with.size(); i += 3)
      changed += std::abs(with[i] - without[i]) > 0.01f * without[i];
    return changed;
  }
  // The next water of the same land, deep for 150 m around, with land within 3 km along x.
  glm::dvec2 seaNear(glm::dvec2 at) {
    const auto ground = simulation_->ground();
    for (int i = 0; i < 8000; ++i, at.x += 400) {
      double highest = -1e9, ahead = -1e9;
      for (const double dx : {-150.0, 0.0, 150.0})
        for (const double dz : {-150.0, 0.0, 150.0})
          highest = std::max(highest, ground->height(at + glm::dvec2(dx, dz)));
      for (double x = 400; x < 3000; x += 100)
        ahead = std::max(ahead, ground->height(at + glm::dvec2(x, 0)) / x);
      if (highest < -8 && ahead > 0.12) return at;
    }
    ADD_FAILURE() << "no sea before hills";
    return at;
  }
};

TEST_F(WaterMirrorGLTest, O09_aPlaneMirrorsWhatRaysMeetOutOfThePicture) {
  // Where the picture shows hills, the plane agrees with the processor's rays no worse than the picture
  // itself; where it shows none, it still does, up to the picture's sides, and the picture has nothing.
  beginCalm();
  look(kOpenSea, 4, 20, -4);
  const test::MirrorAgreement byPicture = agreement("picture", 16), byPlane = agreement("plane", 16);
  EXPECT_LE(byPlane.missed(), byPicture.missed());
  EXPECT_GT(byPlane.meet, 20);
  EXPECT_GE(byPlane.found, 0.9 * byPlane.meet);
  EXPECT_TRUE(test::holds("O09", byPlane.missed(), test::below(0.12), "of the pixels"));
  // Hills ahead, above the upper edge of a narrow picture.
  set("render.camera.fovDegrees=20");
  look(seaNear(kOpenSea), 4, 0, -11.5);
  EXPECT_EQ(agreement("picture", 0).found, 0);
  const test::MirrorAgreement outside = agreement("plane", 0);
  EXPECT_GT(outside.meet, 20);
  EXPECT_GE(outside.found, 0.9 * outside.meet);
  EXPECT_TRUE(test::holds("O09", outside.missed(), test::below(0.12), "of the pixels"));
}

TEST_F(WaterMirrorGLTest, O10_theMirroredEyeStandsAtTheSeaAndFarOut) {
  // 5 cm above the sea, and 1e9 m from the origin, the plane agrees with the rays as it does elsewhere; at
  // the sea and below it nothing is mirrored, and the picture is finite.
  beginCalm();
  look(kOpenSea, 0.05, 20, -4);
  const test::MirrorAgreement low = agreement("plane", 0);
  EXPECT_GT(low.meet, 20);
  EXPECT_GE(low.found, 0.9 * low.meet);
  EXPECT_TRUE(test::holds("O10", low.missed(), test::below(0.12), "of the pixels"));
  for (const double above : {1e-7, 0.0, -1e-7}) {
    look(kOpenSea, above, 20, -4);
    EXPECT_EQ(passOf("waterMirror").skipped, above > 0 ? "" : "the view is below the sea") << above;
    for (const float value : light()) ASSERT_TRUE(std::isfinite(value)) << above;
  }
  look(seaNear({1e9, -1e9}), 4, 0, -4);
  const test::MirrorAgreement farOut = agreement("plane", 0);
  EXPECT_GT(farOut.meet, 20);
  EXPECT_GE(farOut.found, 0.9 * farOut.meet);
  EXPECT_TRUE(test::holds("O10", farOut.missed(), test::below(0.12), "of the pixels"));
}

TEST_F(WaterMirrorGLTest, anAircraftIsMirroredFromBelow) {
  // One that flies over what is seen, out of the picture: the plane shows its underside, the picture cannot.
  begin({"wind.speed=1", "waterDetail.foam=0", "waterDetail.reflectionRays=4"});
  look(kOpenSea, 6, 20, -40);
  const glm::dvec3 above(kOpenSea.x + 9, 14, kOpenSea.y + 3);
  EXPECT_EQ(changedByAircraft(above), 0);
  set(kPlane);
  EXPECT_GT(changedByAircraft(above), 30);
}

TEST_F(WaterMirrorGLTest, nothingBelowTheSeaIsMirrored) {
  // An aircraft that has sunk stands between the mirrored eye and the hills that water mirrors.
  begin({"wind.speed=1", "waterDetail.foam=0", kPlane});
  look(kBeforeAMountain, 6, -38, -6);
  const auto ahead = [](double height) {
    return glm::dvec3(kBeforeAMountain.x + 9.5, height, kBeforeAMountain.y - 7.4);
  };
  EXPECT_EQ(changedByAircraft(ahead(-4.5)), 0);
  EXPECT_GT(changedByAircraft(ahead(4.5)), 30);
}

TEST_F(WaterMirrorGLTest, nothingIsMadeWhereNobodyAsks) {
  // Without it there is neither program nor draw nor memory; after it, as much memory as before.
  begin();
  look(kShore, 8, 75, -4);
  sceneRenderer_->warmUp(snapshot_, kSize);
  const core::PassStatistics idle = passOf("waterMirror");
  EXPECT_EQ(idle.skipped, "water mirrors what the picture shows");
  EXPECT_EQ(idle.draws + idle.dispatches, 0);
  for (const render::gl::ShaderProgram* program : sceneRenderer_->renderer().shaders().programs()) {
    for (const std::string& define : program->defines())
      EXPECT_FALSE(define.starts_with("MIRRORED")) << define;
  }
  const core::Image before = frame();
  const Held without = held();
  set(kPlane);
  EXPECT_GT(passOf("waterMirror").draws, 0);
  EXPECT_GT(held().bytes, without.bytes);
  set("waterDetail.mirror=picture");
  EXPECT_EQ(frame().rgba, before.rgba);
  EXPECT_EQ(held(), without);
}

TEST_F(WaterMirrorGLTest, theEffectPaysForIt) {
  // Draws and memory are waterDetail's; land draws and holds what it did.
  begin();
  look(kShore, 8, 75, -4);
  const auto billOf = [&](const std::string& effect) {
    frame();
    const core::FrameStatistics all = statistics();
    return *std::ranges::find(all.bill, effect, &core::EffectStatistics::name);
  };
  const core::EffectStatistics land = billOf("terrain"), water = billOf("waterDetail");
  set(kPlane);
  const core::EffectStatistics landNow = billOf("terrain"), waterNow = billOf("waterDetail");
  EXPECT_EQ(landNow.draws, land.draws);
  EXPECT_EQ(landNow.gpuBytes, land.gpuBytes);
  EXPECT_GT(waterNow.draws, water.draws);
  // Two targets of half floats and depth, of half the picture's sides and a margin.
  EXPECT_GT(waterNow.gpuBytes - water.gpuBytes, 24 * kSize.width * kSize.height / 4);
}

TEST_F(WaterMirrorGLTest, frameIsAFunctionOfTheState) {
  // Whatever was seen before, and whatever small picture was drawn beside it.
  begin({kPlane});
  look(kShore, 8, 75, -4);
  const core::Image first = frame();
  look(kOpenSea, 30, 200, -20);
  frame();
  look(kShore, 8, 75, -4);
  EXPECT_EQ(frame().rgba, first.rgba);
  look(kOpenSea, 30, 200, -20);
  render::View inset = sceneRenderer_->view(snapshot_, {64, 48});
  look(kShore, 8, 75, -4);
  for (int i = 0; i < 40 && !sceneRenderer_->drawInset(snapshot_, inset); ++i) continue;
  EXPECT_TRUE(sceneRenderer_->drawInset(snapshot_, inset));
  EXPECT_EQ(frame().rgba, first.rgba);
}

TEST_F(WaterMirrorGLTest, nothingIsCompiledOnceAFlightIsWarm) {
  // Beginning so high that nothing is mirrored.
  begin({kPlane});
  snapshot_.aircraft.present = true;
  snapshot_.aircraft.position.y = 900;
  sceneRenderer_->warmUp(snapshot_, kSize);
  const auto programs = sceneRenderer_->renderer().shaders().madeSoFar();
  look(kShore, 8, 75, -4);
  EXPECT_EQ(passOf("waterMirror").skipped, "");
  EXPECT_EQ(sceneRenderer_->renderer().shaders().madeSoFar(), programs);
}

TEST_F(WaterMirrorGLTest, passSaysWhyItIsIdle) {
  begin({kPlane});
  const auto reason = [&](double above, double pitch) {
    look(kShore, above, 75, pitch);
    return passOf("waterMirror").skipped;
  };
  EXPECT_EQ(reason(8, -4), "");
  EXPECT_EQ(reason(8, 60), "the view shows no water");
  EXPECT_EQ(reason(9000, -20), "the view is too high for what water mirrors");
  set("waterDetail.reflection=off");
  EXPECT_EQ(reason(8, -4), "water mirrors what the picture shows");
}

}  // namespace
}  // namespace skydrop::app
