// Villages in frames: those of the CPU, on the land that is drawn, the same whatever map they are drawn from.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "skydrop/core/hash.h"
#include "skydrop/render/places/places_pass.h"
#include "skydrop/render/vegetation/vegetation_pass.h"
#include "support/margin.h"
#include "support/row_steps.h"
#include "support/scene_gl_test.h"

namespace skydrop::app {
namespace {

constexpr Size kSize{192, 108};
constexpr double kDegree = std::numbers::pi / 180;

class PlacesGLTest : public test::SceneGLTest {
 protected:
  void begin(std::vector<std::string> set = {}) {
    beginScene(lineOf("village", {"effects.clouds=false", "effects.targets=false", "effects.hud=false"}, set),
               1);
    snapshot_ = simulation_->world().now();
    snapshot_.aircraft.present = false;
    sceneRenderer_->camera().setMode(render::CameraMode::free);
    places_ = std::make_unique<terrain::Places>(simulation_->ground(), run_->settings.villages);
  }
  // So high above the land at a place; yaw 0 looks along +x.
  void look(const glm::dvec2& at, double above, double yawDeg, double pitchDeg) {
    const double ground = std::max(simulation_->ground()->height(at), 0.0);
    sceneRenderer_->camera().setPose({at.x, ground + above, at.y}, yawDeg * kDegree, pitchDeg * kDegree, 0);
  }
  core::Image frame() {
    sceneRenderer_->draw(snapshot_, kSize, Streaming::settled);
    return sceneRenderer_->renderer().readBack();
  }
  const render::PlacesPass& pass() { return *sceneRenderer_->renderer().find<render::PlacesPass>(); }
  // That nearest to a place.
  std::shared_ptr<const terrain::Village> village(const glm::dvec2& at) const {
    return places_->nearest(at, 6);
  }

  static double meanDifference(const core::Image& a, const core::Image& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i)
      sum += std::abs(static_cast<int>(a.rgba[i]) - static_cast<int>(b.rgba[i]));
    return sum / static_cast<double>(a.rgba.size());
  }
  static double meanRed(const core::Image& a) {
    double sum = 0;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4) sum += static_cast<double>(a.rgba[i]);
    return sum / static_cast<double>(a.rgba.size() / 4);
  }

  game::Snapshot snapshot_;
  std::unique_ptr<terrain::Places> places_;
};

TEST_F(PlacesGLTest, H03_whatIsDrawnIsWhatIsFlownInto) {
  // Buildings of a frame from over a village are those of the CPU: within 5 cm in plan (a float beside the
  // eye) and, on the land as it is drawn, within 0.5 m in height. Near the origin and 1e7 m out. And no tree
  // of the frame stands in a field or on a way.
  begin();
  for (const glm::dvec2& near : {glm::dvec2(-3000, 2600), glm::dvec2(1e7, -1e7)}) {
    const auto of = village(near);
    ASSERT_TRUE(of);
    look(of->middle, 90, 30, -60);
    frame();
    const glm::dvec3 eye = sceneRenderer_->view(snapshot_, kSize).position;
    int seen = 0, apart = 0;
    double farthest = 0;
    for (const glm::vec4& foot : pass().feet()) {
      if (std::hypot(foot.x, foot.z) > 250) continue;
      const glm::dvec3 place = eye + glm::dvec3(foot);
      ++seen;
      const auto same = std::ranges::find_if(of->parts, [&](const terrain::HousePart& part) {
        return std::hypot(part.foot.x - place.x, part.foot.z - place.z) < 0.05;
      });
      apart += same == of->parts.end();
      if (same != of->parts.end()) farthest = std::max(farthest, std::abs(same->foot.y - place.y));
    }
    EXPECT_GT(seen, 8);
    EXPECT_EQ(apart, 0) << seen;
    EXPECT_TRUE(test::holds("H03", farthest, test::below(0.5), "m"));
    std::printf("[ places ] %d buildings, heights within %.3f m\n", seen, farthest);
    const terrain::PlacesAround around = places_->around(of->middle, 1200);
    int trees = 0, inFields = 0;
    for (int list = 0; list < 4; ++list) {
      for (const glm::vec4& foot : sceneRenderer_->renderer().find<render::VegetationPass>()->feet(list)) {
        ++trees;
        inFields +=
            around.isSettled({eye.x + static_cast<double>(foot.x), eye.z + static_cast<double>(foot.z)});
      }
    }
    EXPECT_LE(inFields, trees / 200) << trees;
  }
}

TEST_F(PlacesGLTest, aSmallPictureFromAnotherCellDoesNotTakeTheMapOfTheScene) {
  // Frames on one side of a border between cells with small pictures from the other side make two maps,
  // however many frames there are; the frames are those of a flight without small pictures, and the second
  // map is gone when no small picture has been drawn for long.
  begin();
  const double border =
      terrain::kPlaceCellM * std::floor(village({-3000, 2600})->middle.x / terrain::kPlaceCellM);
  const glm::dvec2 here(border + 30, 2600), there(border - 30, 2600);
  look(here, 60, 180, -10);
  const core::Image alone = frame();
  const render::PlaceMapPass& map = *sceneRenderer_->renderer().find<render::PlaceMapPass>();
  const std::size_t before = map.mapsMade();
  const std::int64_t bytes = static_cast<std::int64_t>(context().resources().bytes());
  const auto inset = [&] {
    look(there, 60, 0, -10);
    const render::View view = sceneRenderer_->view(snapshot_, {64, 36});
    EXPECT_TRUE(sceneRenderer_->drawInset(snapshot_, view));
    look(here, 60, 180, -10);
  };
  while (!sceneRenderer_->drawInset(snapshot_, sceneRenderer_->view(snapshot_, {64, 36}))) continue;
  for (int i = 0; i < 4; ++i) {
    inset();
    EXPECT_EQ(frame().rgba, alone.rgba);
  }
  EXPECT_EQ(map.mapsMade(), before + 1);
  EXPECT_GT(static_cast<std::int64_t>(context().resources().bytes()), bytes);
  for (int i = 0; i < 61; ++i) sceneRenderer_->draw(snapshot_, {16, 9}, Streaming::asItComes);
  sceneRenderer_->endInset();
  EXPECT_EQ(frame().rgba, alone.rgba);
  EXPECT_EQ(map.mapsMade(), before + 1);
  EXPECT_LE(static_cast<std::int64_t>(context().resources().bytes()), bytes);
}

TEST_F(PlacesGLTest, H05_mapsOfTwoBasesShowTheSame) {
  // An eye a centimetre to either side of the border at which the map changes sees the same land: at the
  // origin and 1e9 m out. 0.05 of 255 in the mean is what a centimetre does.
  begin();
  for (const glm::dvec2& near : {glm::dvec2(-3000, 2600), glm::dvec2(1e9, 1e9)}) {
    const auto of = village(near);
    ASSERT_TRUE(of);
    const double border = std::floor(of->middle.x / terrain::kPlaceCellM) * terrain::kPlaceCellM;
    look({border - 0.005, of->middle.y}, 160, 0, -9);
    const core::Image west = frame();
    const double height = sceneRenderer_->view(snapshot_, kSize).position.y;
    sceneRenderer_->camera().setPose({border + 0.005, height, of->middle.y}, 0, -9 * kDegree, 0);
    EXPECT_TRUE(test::holds("H05", meanDifference(west, frame()), test::below(0.25), "of 255"));
  }
}

TEST_F(PlacesGLTest, H06_whereNoneIsNothingIsDrawn) {
  // No density, no reach, an eye 9 km up: no draw, with the reason.
  begin();
  const auto of = village({-3000, 2600});
  look(of->middle, 80, 0, -30);
  const auto reason = [&] {
    frame();
    core::FrameStatistics statistics;
    sceneRenderer_->writeTo(statistics);
    for (const auto& [name, row] : statistics.passes)
      if (name == "places") return row.skipped;
    return std::string("none");
  };
  EXPECT_EQ(reason(), "");
  EXPECT_GT(pass().drawn()[0], 5u);
  set("villages.density=0");
  EXPECT_EQ(reason(), "no village is near");
  set("villages.density=0.8"), set("places.houseM=0"), set("places.hedgeM=0");
  EXPECT_EQ(reason(), "villages are painted alone");
  set("places.houseM=2500");
  sceneRenderer_->camera().setPose({of->middle.x, 9000, of->middle.y}, 0, -1, 0);
  EXPECT_EQ(reason(), "the view is too high for houses");
  test::noFaults("H06", "villages");
}

TEST_F(PlacesGLTest, windowsAreLitAtNightAlone) {
  // Light of windows is there after sunset and not at noon.
  begin();
  const auto of = village({-3000, 2600});
  look(of->middle + glm::dvec2(-90, 0), 14, 0, -6);
  const auto more = [&](const char* elevation) {
    set(std::string("render.sun.elevationDegrees=") + elevation);
    set("places.windows=0");
    const double dark = meanRed(frame());
    set("places.windows=1");
    return meanRed(frame()) - dark;
  };
  EXPECT_EQ(more("40"), 0);
  EXPECT_GT(more("-6"), 0.3);
}

TEST_F(PlacesGLTest, everyTenthOfEveryRowMakesADifference) {
  begin({"render.sun.elevationDegrees=-5"});
  const auto of = village({-3000, 2600});
  const int rows = test::expectNoIdleSteps(run_->table, {"places."}, [&] {
    sceneRenderer_->apply(SettingsChange::ofAll(run_->table));
    core::StateHasher h;
    look(of->middle + glm::dvec2(-140, 0), 20, 0, -12);
    for (const auto byte : frame().rgba) h.add(std::uint64_t{byte});
    // From so far that the village is at each of the distances once.
    for (const double before : {600.0, 1150.0, 1700.0, 2250.0}) {
      look(of->middle - glm::dvec2(before, 0), 120, 0, -4);
      frame();
      for (const std::uint32_t count : pass().drawn()) h.add(std::uint64_t{count});
    }
    return h.value();
  });
  EXPECT_EQ(rows, 4);
}

}  // namespace
}  // namespace skydrop::app
