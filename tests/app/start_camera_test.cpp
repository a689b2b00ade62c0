#include "app/session/start_camera.h"

#include <gtest/gtest.h>

#include "skydrop/game/contact.h"
#include "skydrop/terrain/noise_height_source.h"

namespace skydrop::app {
namespace {

const terrain::HeightSource& land() {
  static const auto source = terrain::makeNoiseHeightSource({}, 1);
  return *source;
}

// A place on land or at sea.
glm::dvec2 somewhere(bool water) {
  for (double x = 0;; x += 500) {
    if (game::surfaceAt(land(), {x, 0}).water == water) return {x, 0};
  }
}

TEST(StartCamera, heightAboveGroundIsCountedFromLandAndFromSea) {
  for (const bool water : {false, true}) {
    const glm::dvec2 at = somewhere(water);
    render::Camera camera;
    placeCamera(camera, {{at.x, 25, at.y}, 0, 0, 0, true}, land());
    EXPECT_EQ(camera.mode(), render::CameraMode::free);
    EXPECT_EQ(camera.position().y, game::surfaceAt(land(), at).height + 25);
    placeCamera(camera, {{at.x, 25, at.y}, 0, 0, 0}, land());
    EXPECT_EQ(camera.position().y, 25);
  }
}

TEST(StartCamera, aCameraUnderTheSurfaceIsReported) {
  // In one line that names land or sea, how deep, and where the surface is; nothing above it.
  for (const bool water : {false, true}) {
    const glm::dvec2 at = somewhere(water);
    render::Camera camera;
    placeCamera(camera, {{at.x, -40, at.y}, 0, 0, 0, true}, land());
    const auto line = underSurface(camera, land());
    ASSERT_TRUE(line);
    EXPECT_NE(line->find("40.0 m under the " + std::string(water ? "sea" : "land")), std::string::npos)
        << *line;
    EXPECT_EQ(line->find('\n'), std::string::npos);
    placeCamera(camera, {{at.x, 0.1, at.y}, 0, 0, 0, true}, land());
    EXPECT_FALSE(underSurface(camera, land()));
  }
}

TEST(StartCamera, noCameraInTheWorldStandsAboveTheHighestPlace) {
  // Neither by a height above ground nor by flying there.
  render::Camera camera;
  placeCamera(camera, {{0, render::kHighestCameraM, 0}, 0, 90, 0, true}, land());
  EXPECT_LE(camera.position().y, render::kHighestCameraM);
  for (int i = 0; i < 100; ++i) camera.move({0, 100, 100});
  EXPECT_LE(camera.position().y, render::kHighestCameraM);
}

}  // namespace
}  // namespace skydrop::app
