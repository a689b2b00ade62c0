// Aircraft, packages and the target's marker in whole frames.
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include "skydrop/core/assets.h"
#include "skydrop/core/error.h"
#include "skydrop/render/frame/tone_map_pass.h"
#include "skydrop/render/models/aircraft_pass.h"
#include "skydrop/render/models/marker_pass.h"
#include "skydrop/render/models/package_pass.h"
#include "skydrop/render/sky/sky_pass.h"
#include "support/frame_test.h"
#include "support/ground_pass.h"
#include "support/image_compare.h"
#include "support/light_probe.h"
#include "support/margin.h"

namespace skydrop::render {
namespace {

// Heading east: the body's forward -z becomes +x.
glm::dquat facingEast() { return glm::angleAxis(-glm::radians(90.0), glm::dvec3(0, 1, 0)); }

struct Box {
  int left = 1 << 20, right = -1, top = 1 << 20, bottom = -1;
  int width() const { return right - left + 1; }
  int height() const { return bottom - top + 1; }
};

// Of the pixels in which two pictures differ by more than `least` steps of 8 bits.
Box changedBox(const core::Image& a, const core::Image& b, int least = 8) {
  Box box;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      int difference = 0;
      for (int c = 0; c < 3; ++c)
        difference = std::max(difference, std::abs(a.pixel(x, y)[c] - b.pixel(x, y)[c]));
      if (difference <= least) continue;
      box.left = std::min(box.left, x), box.right = std::max(box.right, x);
      box.top = std::min(box.top, y), box.bottom = std::max(box.bottom, y);
    }
  }
  return box;
}

class ModelPassGLTest : public test::FrameTest {
 protected:
  void SetUp() override {
    FrameTest::SetUp();
    if (IsSkipped()) return;
    const auto model = std::make_shared<const Model>(
        context(), importModel(core::assetPath("models/airplane.glb")), "airplane");
    renderer().add(std::make_unique<SkyPass>(context()));
    renderer().add(std::make_unique<AircraftPass>(model));
    renderer().add(std::make_unique<PropellerPass>(model));
    renderer().add(std::make_unique<PackagePass>(std::make_shared<const PackageModels>(context())));
    renderer().add(std::make_unique<MarkerPass>(context()));
    renderer().add(std::make_unique<ToneMapPass>(context()));
    settings_.sun.elevationDegrees = 60;
    aircraft().present = true;
    aircraft().position = {0, 800, 0};
    aircraft().orientation = facingEast();
  }

  game::AircraftSnapshot& aircraft() { return snapshot_.aircraft; }
  void setTarget(const glm::dvec3& place) {
    aircraft().present = false;
    snapshot_.target.present = true;
    snapshot_.target.position = place;
    snapshot_.target.radius = 100;
  }
  void addGround(const glm::dvec3& middle) {
    renderer().add(std::make_unique<test::GroundPass>(context(), planeMesh(20000, 20000, 64, 64), middle));
  }
  // The same frame without what a test looks for.
  core::Image without(game::Snapshot other, const View& view) {
    std::swap(snapshot_, other);
    core::Image image = draw(view);
    std::swap(snapshot_, other);
    return image;
  }
  core::Image emptyFrame(const View& view) { return without({}, view); }
  // Why a pass did nothing in the last frame; "" if it drew.
  std::string skipped(const char* pass) {
    core::FrameStatistics statistics;
    renderer().fillStatistics(statistics);
    for (const auto& [name, statistic] : statistics.passes) {
      if (name == pass) return statistic.skipped;
    }
    return "not there";
  }
};

TEST_F(ModelPassGLTest, aircraftHasItsSizeAndFacesForward) {
  // From 30 m above with the picture's top to the north: 8.3 m from left to right, 10.8 m from top to bottom,
  // as the perspective at the height of wing and fuselage has it (2 pixels for edges), and its nose on the
  // right.
  settings_.smoothModels = false;
  const View view = pose({0, 830, 0}, -90, -90, 0, 640, 640);
  const Box box = changedBox(draw(view), emptyFrame(view));
  const double pixelsPerMetre = 640 / (2 * std::tan(view.fovYRad / 2) * (30 - 1.2));
  EXPECT_NEAR(box.width(), 8.3 * pixelsPerMetre * (30 - 1.2) / 30, 2);
  EXPECT_NEAR(box.height(), 10.8 * pixelsPerMetre, 2);
  EXPECT_LT(box.right - 320, 320 - box.left);  // the nose is 3.2 m, the tail 5.1 m from the middle
}

// A ball in the stage of models, before black.
class BallPass final : public Pass {
 public:
  explicit BallPass(gl::Context& context) : model_(context, modelOf(sphereMesh(1, 32, 16)), "ball") {}
  std::string_view name() const override { return "ball"; }
  RenderStage stage() const override { return RenderStage::models; }
  void draw(FrameContext& frame) override {
    frame.gl.api().Enable(GL_CULL_FACE);
    model_.draw(frame.shaders, "models/model.vert", "models/model.frag", {},
                bodyMatrix(frame.frame.view, {0, 0, 0}, glm::dquat(1, 0, 0, 0)), ModelPose(model_), {});
  }

 private:
  static ModelData modelOf(const MeshData& mesh) {
    ModelData data;
    data.nodes = {{"ball", -1, glm::mat4(1), {0}}};
    data.meshes = {{"ball", mesh, 0}};
    data.materials = {{"plain", {}, {}}};
    return data;
  }

  Model model_;
};

class ModelLayerGLTest : public test::FrameTest {};

TEST_F(ModelLayerGLTest, smallThingsDoNotShimmer) {
  // A ball 3.2 pixels wide, seen from the side that the sun shines on and moved by parts of a pixel: the
  // light it adds to the picture varies by at most 12 % with four samples a pixel, and by more than 25 % with
  // one.
  std::vector<glm::vec4> light;
  renderer().add(std::make_unique<BallPass>(context()));
  renderer().add(std::make_unique<test::LightProbe>(light));
  settings_.sun.elevationDegrees = 90;
  features_ = {};
  const double pixelM = 1 / 1.6, heightM = pixelM * 180 / (2 * std::tan(glm::radians(30.0)));
  const auto spread = [&](bool smooth) {
    settings_.smoothModels = smooth;
    double least = 1e300, most = 0;
    for (int i = 0; i < 16; ++i) {
      draw(pose({i * pixelM / 16, heightM, i * pixelM * 5 / 16}, 0, -90, 0));
      double sum = 0;
      for (const glm::vec4& pixel : light) sum += static_cast<double>(pixel.y);
      least = std::min(least, sum), most = std::max(most, sum);
    }
    return most / least - 1;
  };
  EXPECT_LT(spread(true), 0.12);
  EXPECT_GT(spread(false), 0.2);
}

TEST_F(ModelPassGLTest, T02_aircraftFarOutLooksLikeTheOneAtTheOrigin) {
  // 1e8 m away (a multiple of 2^8: the subtraction is exact) every bit of the picture is the same.
  test::noFaults("T02", "violations");
  const glm::dvec3 eye(-12, 804, 5);
  const core::Image here = draw(pose(eye, 20, -12, 5));
  const glm::dvec3 far(std::ldexp(390625.0, 8), 0, -std::ldexp(390625.0, 8));
  aircraft().position += far;
  EXPECT_TRUE(test::imagesMatch(draw(pose(eye + far, 20, -12, 5)), here, {0, 0}, "aircraft_far_out"));
}

TEST_F(ModelPassGLTest, smoothModelsAreBehindWhatIsNearer) {
  // A plain between eye and aircraft: nothing of the aircraft is seen, with or without samples.
  addGround({0, 820, 0});
  const View view = pose({0, 830, 0}, -90, -80, 0);
  for (const bool smooth : {true, false}) {
    settings_.smoothModels = smooth;
    EXPECT_LT(changedBox(draw(view), emptyFrame(view), 0).right, 0);
  }
}

TEST_F(ModelPassGLTest, layerIsMadeOnlyForModelsInViewThatFitIntoIt) {
  // Looking away: no layer. Sitting in the cabin at 1200 x 900: too many pixels, drawn without. From behind:
  // a layer.
  draw(pose({-30, 800, 0}, 180, 0, 0));
  EXPECT_EQ(skipped("modelLayer"), "no model in view");
  draw(pose({0, 800.7, 0}, 0, 0, 0, 1200, 900));
  EXPECT_EQ(skipped("modelLayer"), "the models cover too many pixels");
  settings_.smoothModels = false;
  draw(pose({-30, 800, 0}, 0, 0, 0));
  EXPECT_EQ(skipped("modelLayer"), "switched off");
  settings_.smoothModels = true;
  draw(pose({-30, 800, 0}, 0, 0, 0));
  EXPECT_EQ(skipped("modelLayer"), "");
}

TEST_F(ModelPassGLTest, detailChangesWithoutBeingSeen) {
  // A step before and a step behind the distance at which a pixel covers 2 cm (8.66 m at 500 pixels, 60
  // degrees): of the pixels at most 2 % differ by more than 24 steps of 8 bits: the aircraft has hardly
  // moved, or changed.
  const double limit = 0.02 * 500 / (2 * std::tan(glm::radians(30.0)));
  const core::Image fine = draw(pose({0, 800, limit - 0.005}, -90, 0, 0, 500, 500));
  const core::Image coarse = draw(pose({0, 800, limit + 0.005}, -90, 0, 0, 500, 500));
  int different = 0;
  for (int y = 0; y < 500; ++y) {
    for (int x = 0; x < 500; ++x) {
      int most = 0;
      for (int c = 0; c < 3; ++c)
        most = std::max(most, std::abs(fine.pixel(x, y)[c] - coarse.pixel(x, y)[c]));
      different += most > 24;
    }
  }
  EXPECT_LT(different, 500 * 500 / 50);
  EXPECT_GT(different, 0);
}

TEST_F(ModelPassGLTest, controlsMoveTheSurfacesThatTheyShould) {
  // Seen from behind: a roll to the right lifts the right aileron's edge and lowers the left one's; yaw
  // changes the fin's middle; pulling changes the tailplane's; nothing else changes.
  const View view = pose({-14, 801, 0}, 0, 0, 0, 640, 360);
  const core::Image still = draw(view);
  const double tailPixels = 360 / (2 * std::tan(view.fovYRad / 2) * 9.5);  // a metre at the tail
  aircraft().controls.roll = 1;
  const Box ailerons = changedBox(draw(view), still);
  EXPECT_NEAR(ailerons.width(), 2 * 4.95 * 360 / (2 * std::tan(view.fovYRad / 2) * 14.3),
              16);  // they taper away from the eye by up to 0.8 m
  aircraft().controls = {};
  aircraft().controls.pitch = 1;
  const Box elevator = changedBox(draw(view), still);
  EXPECT_NEAR(elevator.width(), 3.4 * tailPixels, 8);
  EXPECT_LT(elevator.height(), 0.8 * tailPixels);
  aircraft().controls = {};
  aircraft().controls.yaw = 1;
  const Box rudder = changedBox(draw(view), still);
  EXPECT_LT(rudder.width(), 0.8 * tailPixels);
  EXPECT_GT(rudder.height(), 1.2 * tailPixels);
  EXPECT_GT(rudder.left + rudder.width() / 2, 320);  // its edge goes to the right
}

TEST_F(ModelPassGLTest, bladesAreAVeilWhileTurningAndSolidAfterACrash) {
  // Before the sky the veil changes pixels by some steps only and turns with the angle; stopped blades are
  // dark.
  const View view = pose({9, 800, 0}, 180, 0, 0);
  const core::Image turning = draw(view);
  EXPECT_EQ(skipped("propeller"), "");
  aircraft().propellerAngleRad = 0.5;
  const Box moved = changedBox(draw(view), turning, 3);
  EXPECT_GT(moved.width(), 40);
  aircraft().crashed = true;
  const Box stopped = changedBox(draw(view), turning, 60);
  EXPECT_GT(stopped.width(), 30);
  EXPECT_EQ(skipped("propeller"), "the engine has stopped");
}

TEST_F(ModelPassGLTest, aCrashLeavesABrokenAircraft) {
  // From behind: the wing is askew over its span, and so it is with less detail from far away.
  for (const double behind : {30.0, 120.0}) {
    const View view = pose({-behind, 800, 0}, 0, 0, 0);
    aircraft().crashed = false;
    const core::Image whole = draw(view);
    aircraft().crashed = true;
    const double pixelsPerMetre = view.width / (2 * behind * std::tan(view.fovYRad / 2) * view.aspect());
    const Box broken = changedBox(draw(view), whole, 20);
    EXPECT_GT(broken.width(), 4 * pixelsPerMetre) << behind;
    EXPECT_GT(broken.height(), 1 * pixelsPerMetre) << behind;
  }
}

TEST_F(ModelPassGLTest, panelIsSeenFromInsideTheCabinOnly) {
  // The eye at the pilot's place sees a dark panel in the lower middle and open sky above; from outside,
  // turning on the spot where the panel stands shows the same aircraft whatever the panel holds.
  const glm::dvec3 eye = aircraft().position + facingEast() * glm::dvec3(0, 0.72, -0.35);
  const View view = pose(eye, 0, 0, 0);
  const core::Image inside = draw(view), sky = emptyFrame(view);
  EXPECT_LT(inside.pixel(160, 165)[1], 60);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(inside.pixel(160, 30)[c], sky.pixel(160, 30)[c], 3);
}

TEST_F(ModelPassGLTest, aircraftOutOfViewIsNotDrawn) {
  // Behind the eye, beside the picture, 500 km away, absent: no draw, and the reason is reported.
  for (const View& view :
       {pose({30, 800, 0}, 0, 0, 0), pose({0, 800, 30}, 0, 0, 0), pose({-500000, 800, 0}, 0, 0, 0)}) {
    draw(view);
    EXPECT_EQ(skipped("aircraft"), "the aircraft is out of view");
  }
  aircraft().present = false;
  draw(pose({-30, 800, 0}, 0, 0, 0));
  EXPECT_EQ(skipped("aircraft"), "no aircraft");
  EXPECT_EQ(skipped("packages"), "no package has been dropped");
  EXPECT_EQ(skipped("marker"), "no target");
}

TEST_F(ModelPassGLTest, parachuteOpensAboveThePackage) {
  // Falling closed: a box of 0.8 m. Open: 5.4 m wide (10 % for the gores' bulge) and above the box. Landed:
  // flat.
  aircraft().present = false;
  const View view = pose({-20, 802, 0}, 0, 0, 0, 480, 480);
  const core::Image sky = emptyFrame(view);
  const double metre = 480 / (2 * std::tan(view.fovYRad / 2) * 20);
  game::PackageSnapshot package;
  package.position = {0, 800, 0};
  package.velocity = {0, -8, 0};
  snapshot_.packages = {package};
  const Box closed = changedBox(draw(view), sky);
  EXPECT_NEAR(closed.width(), 0.85 * metre, 3);
  snapshot_.packages[0].parachuteOpen = 1;
  const Box open = changedBox(draw(view), sky);
  EXPECT_NEAR(open.width(), 5.3 * metre, 0.3 * metre);
  EXPECT_NEAR(open.height(), (0.4 + 0.58 + 6.1) * metre, 0.35 * metre);
  EXPECT_LE(std::abs(open.bottom - closed.bottom), 1);
  snapshot_.packages[0].landed = true;
  const Box landed = changedBox(draw(view), sky);
  EXPECT_LT(landed.height(), 1.6 * metre);
}

TEST_F(ModelPassGLTest, parachuteTrailsBehindFlightAndFacesAnyWay) {
  // Right after opening at 60 m/s to the left of the picture the canopy streams to the right; falling at any
  // attitude, straight up included, everything stays finite and drawn.
  aircraft().present = false;
  const View view = pose({-25, 800, 0}, 0, 0, 0, 320, 180);
  const core::Image sky = emptyFrame(view);
  game::PackageSnapshot package;
  package.position = {0, 800, 0};
  package.velocity = {0, 0, -60};
  package.parachuteOpen = 0.4;
  snapshot_.packages = {package};
  const Box trailing = changedBox(draw(view), sky);
  EXPECT_GT(trailing.right - 160, 2 * (160 - trailing.left));
  for (const glm::dvec3& velocity : {glm::dvec3(0, 60, 0), {0, -60, 0}, {0, 0, 0}, {1e-300, 0, 0}}) {
    snapshot_.packages[0].velocity = velocity;
    EXPECT_GT(changedBox(draw(view), sky).height(), 10);
  }
}

TEST_F(ModelPassGLTest, markerIsSeenFromSixKilometresAndHidesBehindLand) {
  // From 6 km, 300 m up, a column of the picture stands out by more than 15 steps over at least 20 rows,
  // within 2 pixels of the target's place; with a hill before it, nothing is left.
  setTarget({6000, 0, 0});
  addGround({0, 0, 0});
  const View view = pose({0, 300, 0}, 4, 0, 0, 640, 360);
  game::Snapshot none = snapshot_;
  none.target.present = false;
  const Box beam = changedBox(draw(view), without(none, view), 15);
  ASSERT_GT(beam.right, 0);
  const glm::vec4 clip = viewProjection(view) * glm::vec4(relativeToEye(view, {6000, 100, 0}), 1);
  const double column = (clip.x / clip.w * 0.5 + 0.5) * 640;
  EXPECT_NEAR((beam.left + beam.right + 1) / 2.0, column, 2);
  EXPECT_GE(beam.height(), 20);
  EXPECT_LE(beam.width(), 30);
  MeshData wall = planeMesh(4000, 4000, 1, 1);
  for (MeshVertex& v : wall.vertices) v.position = {0, v.position.x, v.position.z};
  renderer().add(std::make_unique<test::GroundPass>(context(), wall, glm::dvec3(3000, 0, 0)));
  EXPECT_EQ(changedBox(draw(view), without(none, view), 0).right, -1);
}

TEST_F(ModelPassGLTest, markersRingLiesOnTheGroundAtItsRadius) {
  // From straight above, 600 m up: the ring's outline is 200 m across, and the ground 60 m and 140 m from the
  // middle is not orange.
  setTarget({0, 50, 0});
  addGround({0, 50, 0});
  const View view = pose({0, 650, 0}, -90, -89.99, 0, 480, 480);
  game::Snapshot none = snapshot_;
  none.target.present = false;
  const core::Image image = draw(view), plain = without(none, view);
  const Box ring = changedBox(image, plain, 30);
  const double metre = 480 / (2 * std::tan(view.fovYRad / 2) * 600);
  EXPECT_NEAR(ring.width(), 204 * metre, 4);
  EXPECT_NEAR(ring.height(), 204 * metre, 4);
  const auto redAt = [&](double metres) {
    const int x = static_cast<int>(240 + metres * metre);
    return image.pixel(x, 240)[0] - plain.pixel(x, 240)[0];
  };
  EXPECT_GT(redAt(100), 50);
  EXPECT_LT(redAt(60), 40);
  EXPECT_LE(std::abs(redAt(140)),
            1);  // a step of 8 bits: not every card blends with nothing to the same bits
}

TEST_F(ModelPassGLTest, severalTexturesOfAKindMultiply) {
  // Two diffuse textures of half brightness equal one of a quarter (sRGB: 2 steps of 8 bits for the coding).
  // Five are refused in one line.
  ModelData data;
  data.nodes = {{"part", -1, glm::mat4(1), {0}}};
  data.meshes = {{"part", planeMesh(100, 100, 1, 1), 0}};
  const auto plain = [](std::uint8_t value) {
    core::Image image(1, 1);
    image.rgba = {value, value, value, 255};
    return image;
  };
  data.images = {plain(188), plain(137)};  // linear .502 and .251
  data.materials = {{"two", {0, 0}, {}}};
  const Model two(context(), data, "two");
  data.materials = {{"one", {1}, {}}};
  const Model one(context(), data, "one");
  class Drawing final : public Pass {
   public:
    explicit Drawing(const Model*& model) : model_(model) {}
    std::string_view name() const override { return "drawing"; }
    RenderStage stage() const override { return RenderStage::models; }
    void draw(FrameContext& frame) override {
      model_->draw(frame.shaders, "models/model.vert", "models/model.frag", {},
                   bodyMatrix(frame.frame.view, {0, 0, 0}, glm::dquat(1, 0, 0, 0)), ModelPose(*model_), {});
    }

   private:
    const Model*& model_;
  };
  const Model* shown = &two;
  renderer().add(std::make_unique<Drawing>(shown));
  snapshot_ = {};
  const View view = pose({0, 50, 0}, 0, -80, 0);
  const core::Image multiplied = draw(view);
  shown = &one;
  EXPECT_TRUE(test::imagesMatch(multiplied, draw(view), {2, 1}, "two_textures"));
  data.materials = {{"five", {0, 0, 0, 0, 0}, {}}};
  EXPECT_THROW(Model(context(), data, "five"), core::DataError);
}

TEST_F(ModelPassGLTest, lightIsTheSumOfTheSharesOfSunAndSky) {
  // Half the sun and a quarter of the sky give half the light of the sun alone and a quarter of that of the
  // sky alone, within what half floats keep (2^-11).
  ModelData data;
  data.nodes = {{"part", -1, glm::mat4(1), {0}}};
  data.meshes = {{"part", planeMesh(100, 100, 1, 1), 0}};
  data.materials = {{"plain", {}, {}}};
  const Model model(context(), data, "plain");
  LightShares shares;
  class Drawing final : public Pass {
   public:
    Drawing(const Model& model, const LightShares& shares) : model_(model), shares_(shares) {}
    std::string_view name() const override { return "drawing"; }
    RenderStage stage() const override { return RenderStage::models; }
    void draw(FrameContext& frame) override {
      model_.draw(frame.shaders, "models/model.vert", "models/model.frag", {},
                  bodyMatrix(frame.frame.view, {0, 0, 0}, glm::dquat(1, 0, 0, 0)), ModelPose(model_),
                  shares_);
    }

   private:
    const Model& model_;
    const LightShares& shares_;
  };
  std::vector<glm::vec4> light;
  renderer().add(std::make_unique<Drawing>(model, shares));
  renderer().add(std::make_unique<test::LightProbe>(light));
  snapshot_ = {};
  const auto lightOf = [&](double sun, double sky) {
    shares = {sun, sky};
    draw(pose({0, 50, 0}, 0, -90, 0));
    return glm::vec3(light[light.size() / 2 + 10]);
  };
  const glm::vec3 sun = lightOf(1, 0), sky = lightOf(0, 1), both = lightOf(0.5, 0.25);
  for (int c = 0; c < 3; ++c) {
    EXPECT_GT(sun[c], 0.01f);
    EXPECT_GT(sky[c], 0.001f);
    EXPECT_NEAR(both[c], 0.5f * sun[c] + 0.25f * sky[c], 1e-3f * both[c]);
  }
}

}  // namespace
}  // namespace skydrop::render
