// Flying at night, in frames of the scene `night-approach`: the aircraft's lights, the landing light on the
// land, the light in the cockpit, the interface, and eyes that adapt.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "app/settings/settings.h"
#include "skydrop/core/hash.h"
#include "skydrop/render/models/landing_light_pass.h"
#include "skydrop/render/models/model_lamps.h"
#include "skydrop/terrain/woods.h"
#include "support/light_probe.h"
#include "support/row_steps.h"
#include "support/scene_gl_test.h"

namespace skydrop::app {
namespace {

using core::StateHasher;
using Light = std::vector<glm::vec4>;

constexpr Size kSize{160, 90};

double sum(const glm::vec4& texel) { return static_cast<double>(texel.x + texel.y + texel.z); }

class NightFlightGLTest : public test::SceneGLTest {
 protected:
  void begin(const std::vector<std::string>& set = {}, bool framesFollow = false) {
    beginScene(lineOf("night-approach",
                      {"render.land.detail=plain", "streaming.viewDistanceM=8000", "stars.twinkle=0"}, set),
               2, framesFollow);
    sceneRenderer_->renderer().add(std::make_unique<test::LightProbe>(light_));
    snapshot_ = simulation_->world().now();
  }

  // Light of the scene, before the tone map.
  const Light& frame(render::CameraMode mode = render::CameraMode::chase) {
    sceneRenderer_->camera().setMode(mode);
    sceneRenderer_->draw(snapshot_, kSize, Streaming::settled);
    return light_;
  }
  // Half a second before a flash of any kind, and in one of the beacon.
  void atRest() { snapshot_.simulatedSeconds = 0; }
  void atBeacon() { snapshot_.simulatedSeconds = 0.5 * 60 / run_->settings.aircraftLights.flashesPerMinute; }

  game::Snapshot snapshot_;
  Light light_;
};

TEST_F(NightFlightGLTest, everyTenthOfEveryRowMakesADifference) {
  // Of a frame between flashes and one in the middle of them, from behind; of one from the cockpit.
  begin();
  int rows = 0;
  for (const core::Field& field : run_->table.fields()) {
    if (!field.path.starts_with("aircraftLights.") && !field.path.starts_with("landingLight.")) continue;
    ++rows;
    const Settings kept = run_->settings;
    const auto look = [&] {
      sceneRenderer_->apply(SettingsChange::ofAll(run_->table));
      StateHasher h;
      for (const double seconds : {0.1, 0.62, 3.3, 5.03, 7.7, 11.9, 17.0, 41.3}) {
        snapshot_.simulatedSeconds = seconds;
        for (const auto mode : {render::CameraMode::chase, render::CameraMode::cockpit})
          for (const glm::vec4& texel : frame(mode))
            for (int c = 0; c < 3; ++c) h.add(static_cast<double>(texel[c]));
      }
      return h.value();
    };
    for (const std::string& line : test::idleSteps(field, {}, look)) ADD_FAILURE() << line;
    run_->settings = kept;
  }
  EXPECT_EQ(rows, 8);
}

TEST_F(NightFlightGLTest, redIsLeftAndGreenIsRight) {
  // From behind, of what the lights add to the frame: the reddest pixel lies left of the greenest, and both
  // lie where the wing tips are, within two pixels.
  begin({"landingLight.on=false", "aircraftLights.strobes=false"});
  atRest();
  const Light lit = frame();
  set("aircraftLights.brightness=0");
  const Light dark = frame();
  const auto brightest = [&](int channel) {
    std::size_t best = 0;
    double most = 0;
    for (std::size_t i = 0; i < lit.size(); ++i) {
      const glm::vec4 added = lit[i] - dark[i];
      const double pure = static_cast<double>(added[channel] - added[1 - channel]);
      if (pure > most) most = pure, best = i;
    }
    EXPECT_GT(most, 0.02) << channel;
    return static_cast<double>(best % static_cast<std::size_t>(kSize.width));
  };
  const double red = brightest(0), green = brightest(1);
  EXPECT_LT(red, 0.5 * kSize.width);
  EXPECT_GT(green, 0.5 * kSize.width);
  EXPECT_NEAR(red + green, kSize.width, 8) << "as far from the middle as each other";
}

TEST_F(NightFlightGLTest, byDayTheAircraftIsDrawnWithoutThem) {
  // Lamps on the aircraft are a variant of its program, made at night alone.
  const auto isMade = [&] {
    frame();
    return std::ranges::any_of(
        sceneRenderer_->renderer().shaders().programs(), [](const render::gl::ShaderProgram* program) {
          return program->files().front().name == "models/model.vert" &&
                 std::ranges::find(program->defines(), std::string(render::ModelLamps::kDefine)) !=
                     program->defines().end();
        });
  };
  begin({"sky.utc=2026-06-21T11:00Z"});
  EXPECT_FALSE(isMade());
  set("sky.utc=2026-06-21T23:00Z");
  EXPECT_TRUE(isMade());
}

TEST_F(NightFlightGLTest, byDayTheLightsAreAlmostNothing) {
  // With the sun at noon they add less than a hundredth to the frame's light; at night more than that.
  const auto share = [&] {
    atBeacon();
    const Light lit = frame();
    set("aircraftLights.brightness=0");
    const Light dark = frame();
    set("aircraftLights.brightness=1");
    double added = 0, all = 0;
    for (std::size_t i = 0; i < lit.size(); ++i) added += sum(lit[i] - dark[i]), all += sum(dark[i]);
    return added / all;
  };
  begin({"landingLight.on=false"});
  EXPECT_GT(share(), 0.01);
  set("sky.utc=2026-06-21T11:00Z");
  EXPECT_LT(share(), 0.002);
}

TEST_F(NightFlightGLTest, theLandingLightLightsTheLandAheadAndNothingElse) {
  // It takes no light away; pixels outside of the beam (four half angles from its axis, which leaves 2e-5 of
  // it) keep their bits; and twice the intensity adds twice the light,
  // times what shownShareOf() leaves of it, within 2 %.
  begin({"aircraftLights.brightness=0"});
  atRest();
  set("landingLight.intensity=100000");
  const Light one = frame(render::CameraMode::cockpit);
  set("landingLight.intensity=200000");
  const Light two = frame(render::CameraMode::cockpit);
  set("landingLight.on=false");
  const Light none = frame(render::CameraMode::cockpit);
  const render::View view = sceneRenderer_->view(snapshot_, kSize);
  render::LandingLightSettings lamp = run_->settings.landingLight;
  const render::SpotLight spot = render::landingSpot(snapshot_.aircraft, lamp);
  double addedByOne = 0, addedByTwo = 0;
  int lit = 0, outside = 0;
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      const auto i = static_cast<std::size_t>(y * kSize.width + x);
      EXPECT_GE(sum(one[i]) - sum(none[i]), -1e-3);
      const glm::dvec3 ray = render::rayDirection(view, {x + 0.5, y + 0.5});
      const double angle = std::acos(std::clamp(glm::dot(ray, spot.axis), -1.0, 1.0));
      if (angle > 4.5 * spot.halfAngleRad) {
        EXPECT_LT(std::abs(sum(one[i]) - sum(none[i])), 1e-3) << x << ' ' << y;
        ++outside;
      }
      if (sum(one[i]) - sum(none[i]) < 0.02) continue;
      addedByOne += sum(one[i]) - sum(none[i]);
      addedByTwo += sum(two[i]) - sum(none[i]);
      ++lit;
    }
  }
  EXPECT_GT(lit, 30);
  EXPECT_GT(outside, 1000);
  const auto leftAt = [&](double cd) {
    lamp.intensity = cd;
    const double exposure = render::skyLight(run_->settings.render, view.position.y).exposure;
    return render::shownShareOf(render::landingSpot(snapshot_.aircraft, lamp),
                                snapshot_.aircraft.heightAboveGround, exposure);
  };
  EXPECT_NEAR(addedByTwo / addedByOne / (2 * leftAt(200000) / leftAt(100000)), 1, 0.02);
}

TEST_F(NightFlightGLTest, theLandingLightLightsTheTreesInItsBeamAndNoOthers) {
  // Looked at from beside the lamp, a tree in the middle of the beam sends back what its illuminance makes of
  // foliage: albedos from .036 to .09, two thirds of them as a ball's mean over the side that is seen, .3 to
  // 1 of that by how crowns stand open. One outside of the beam keeps its light, as the land above.
  begin({"effects.vegetation=true", "aircraftLights.brightness=0"});
  atRest();
  snapshot_.aircraft.orientation *= glm::angleAxis(glm::radians(-4.0), glm::dvec3(1, 0, 0));
  const render::SpotLight spot = render::landingSpot(snapshot_.aircraft, run_->settings.landingLight);
  const terrain::Woods woods(simulation_->ground(), run_->settings.woods.density, false);
  const glm::dvec3 eye = spot.position + 4.0 * spot.axis + glm::dvec3(0, 1, 0);
  const auto middleOf = [](const terrain::StandingTree& tree) {
    return tree.foot + glm::dvec3(0, 0.5 * tree.shape.heightM, 0);
  };
  // The nearest tree between two angles from the beam's axis.
  const auto treeBetween = [&](double least, double most) {
    std::optional<glm::dvec3> nearest;
    for (const terrain::StandingTree& tree : woods.around({eye.x, eye.z}, 250)) {
      const glm::dvec3 to = middleOf(tree) - spot.position;
      const double angle = std::acos(glm::dot(glm::normalize(to), spot.axis));
      if (glm::length(to) < 30 || angle < least || angle > most) continue;
      if (!nearest || glm::length(to) < glm::distance(*nearest, spot.position)) nearest = middleOf(tree);
    }
    return nearest;
  };
  // What the lamp adds in the middle of a picture of a place.
  const auto addedTo = [&](const glm::dvec3& place) {
    const glm::dvec3 way = glm::normalize(place - eye);
    sceneRenderer_->camera().setPose(eye, std::atan2(way.z, way.x), std::asin(way.y), 0);
    set("landingLight.on=true");
    const Light with = frame(render::CameraMode::free);
    set("landingLight.on=false");
    const Light without = frame(render::CameraMode::free);
    glm::dvec3 added(0);
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) {
        const auto i = static_cast<std::size_t>((kSize.height / 2 + y) * kSize.width + kSize.width / 2 + x);
        added += glm::dvec3(with[i] - without[i]) / 9.0;
      }
    }
    return added.y;
  };
  const auto inBeam = treeBetween(0, 0.7 * spot.halfAngleRad);
  const auto outside = treeBetween(5 * spot.halfAngleRad, 1.2);
  ASSERT_TRUE(inBeam && outside);
  const double exposure = render::skyLight(run_->settings.render, eye.y).exposure;
  const glm::dvec3 to = *inBeam - spot.position;
  const double angle = std::acos(glm::dot(glm::normalize(to), spot.axis));
  const double illuminance = spot.intensity.y * exposure *
                             render::shownShareOf(spot, snapshot_.aircraft.heightAboveGround, exposure) *
                             std::exp(-std::log(2.0) * std::pow(angle / spot.halfAngleRad, 2)) /
                             glm::dot(to, to);
  const double white = illuminance / std::numbers::pi * 2 / 3, added = addedTo(*inBeam);
  std::printf("[ lamp ] a tree at %.0f m: %.4f, %.3f of a white ball's\n", glm::length(to), added,
              added / white);
  EXPECT_GT(added, 0.3 * 0.036 * white);
  EXPECT_LT(added, 0.09 * white);
  EXPECT_LT(std::abs(addedTo(*outside)), 1e-3);
}

TEST_F(NightFlightGLTest, theLandingLightIsIdleByDayAndOff) {
  begin();
  const auto* pass = sceneRenderer_->renderer().find<render::LandingLightPass>();
  const auto reason = [&] {
    render::FrameInput input = render::gameFrame(snapshot_, sceneRenderer_->view(snapshot_, kSize), {});
    input.sunSine = std::sin(glm::radians(run_->settings.render.sun.elevationDegrees));
    return pass->skipReason(input).value_or("");
  };
  set("render.sun.elevationDegrees=-10");
  EXPECT_EQ(reason(), "");
  set("render.sun.elevationDegrees=20");
  EXPECT_EQ(reason(), "the sun outshines it");
  set("render.sun.elevationDegrees=-10");
  snapshot_.aircraft.crashed = true;
  EXPECT_EQ(reason(), "the aircraft is a wreck");
  set("landingLight.on=false");
  EXPECT_EQ(reason(), "switched off");
}

TEST_F(NightFlightGLTest, switchingTheLandingLightCompilesNothing) {
  // The warm-up of a flight has drawn land, and placed what stands on it, with it and without.
  begin({"landingLight.on=false", "effects.vegetation=true", "effects.groundCover=true",
         "effects.places=true"});
  sceneRenderer_->warmUp(snapshot_, kSize);
  frame();
  const auto programs = sceneRenderer_->renderer().shaders().programs().size();
  set("landingLight.on=true");
  frame();
  EXPECT_EQ(sceneRenderer_->renderer().shaders().programs().size(), programs);
}

TEST_F(NightFlightGLTest, instrumentsCanBeReadAtNight) {
  // The lower middle of the picture from the cockpit: the lamp over them at least doubles its light, and
  // leaves it below white.
  begin({"landingLight.on=false", "sky.utc=2026-09-10T22:00Z"});  // without a moon
  atRest();
  const auto panel = [&] {
    double all = 0, most = 0;
    const Light& light = frame(render::CameraMode::cockpit);
    for (int y = 0; y < kSize.height / 5; ++y) {
      for (int x = kSize.width / 4; x < 3 * kSize.width / 4; ++x) {
        const double here = sum(light[static_cast<std::size_t>(y * kSize.width + x)]);
        all += here, most = std::max(most, here);
      }
    }
    return std::pair(all, most);
  };
  const auto lit = panel();
  set("aircraftLights.cabinBrightness=0");
  const auto dark = panel();
  EXPECT_GT(lit.first, 2 * dark.first);
  EXPECT_LT(lit.second, 3);
}

TEST_F(NightFlightGLTest, theInterfaceIsDimmedAtNightAlone) {
  // 1 by day and with the sun on the horizon, the setting's share by moonlight and starlight, in between
  // steadily; bounded for exposures that are no numbers.
  const auto at = [](const std::vector<std::string>& rows) {
    Settings settings;
    const core::SettingsTable table(settings);
    for (const std::string& row : rows) core::setField(table, row);
    return render::interfaceBrightness(render::skyLight(settings.render, 300).adaptation, 0.5);
  };
  EXPECT_EQ(at({"render.sun.elevationDegrees=40"}), 1);
  EXPECT_GT(at({"render.sun.elevationDegrees=0"}), 0.98);
  EXPECT_LT(at({"render.sun.elevationDegrees=-25"}), 0.51);
  EXPECT_LT(at({"sky.sun=clock", "sky.utc=2026-09-26T21:00Z"}), 0.52);
  double before = 1;
  for (double elevation = 5; elevation > -20; elevation -= 0.5) {
    const double now = at({"render.sun.elevationDegrees=" + std::to_string(elevation)});
    EXPECT_LE(now, before + 1e-9) << elevation;
    EXPECT_GT(now, before - 0.12) << elevation;
    before = now;
  }
  for (const double adaptation : {0.0, -1.0, std::nan(""), HUGE_VAL})
    EXPECT_EQ(render::interfaceBrightness(adaptation, 0.5), 1) << adaptation;
}

TEST_F(NightFlightGLTest, eyesAdaptInFramesThatFollowEachOtherAndNowhereElse) {
  // A sun that is switched off: the next frame is as dark as it is for an eye that is used to the day, and
  // after some seconds it is what a settled eye sees. Without following frames, and with the setting off,
  // every frame is a function of its state.
  const auto mean = [&](double seconds) {
    snapshot_.simulatedSeconds = seconds;
    double all = 0;
    for (const glm::vec4& texel : frame()) all += sum(texel);
    return all / static_cast<double>(light_.size());
  };
  const std::vector<std::string> rows = {"sky.sun=manual", "effects.aircraftLights=false",
                                         "effects.landingLight=false"};
  begin(rows);
  set("render.sun.elevationDegrees=30");
  mean(0);
  set("render.sun.elevationDegrees=-8");
  const double settled = mean(0.1);
  EXPECT_EQ(mean(5), mean(5));
  for (const bool adapts : {true, false}) {
    sceneRenderer_.reset();
    begin(rows, true);
    set("render.sun.elevationDegrees=30");
    set(std::string("view.eyeAdaptation=") + (adapts ? "true" : "false"));
    mean(0);
    set("render.sun.elevationDegrees=-8");
    const double first = mean(0.1);
    double last = first;
    for (double seconds = 0.2; seconds < 20; seconds += 0.4) last = mean(seconds);
    EXPECT_NEAR(last / settled, 1, adapts ? 0.6 : 0.05);
    if (adapts) {
      EXPECT_LT(first, settled / 10);
      sceneRenderer_->camera().setMode(render::CameraMode::cockpit);
      sceneRenderer_->draw(snapshot_, kSize, Streaming::settled);
      EXPECT_GT(mean(20.1), settled / 2) << "a cut is settled at once";
    } else {
      EXPECT_NEAR(first / settled, 1, 0.05);
    }
  }
}

}  // namespace
}  // namespace skydrop::app
