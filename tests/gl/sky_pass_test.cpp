#include "skydrop/render/sky/sky_pass.h"

#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "skydrop/render/frame/tone_map_pass.h"
#include "support/frame_test.h"
#include "support/image_compare.h"
#include "support/light_probe.h"
#include "support/margin.h"
#include "support/temporary_folder.h"

namespace skydrop::render {
namespace {

using test::LightProbe;

class SkyGLTest : public test::FrameTest {
 protected:
  void SetUp() override {
    FrameTest::SetUp();
    if (IsSkipped()) return;
    renderer().add(std::make_unique<ToneMapPass>(context()));
    renderer().add(std::make_unique<SkyPass>(context()));
    renderer().add(std::make_unique<LightProbe>(light_));
    settings_.sun.azimuthDegrees = 90;  // east, where yaw 0 looks
  }

  // Light at a pixel, rows from the bottom.
  glm::vec3 lightAt(int x, int y) const { return glm::vec3(light_[static_cast<std::size_t>(y * 320 + x)]); }

  std::vector<glm::vec4> light_;
};

float luminance(const glm::vec3& light) { return glm::dot(light, glm::vec3(0.2126f, 0.7152f, 0.0722f)); }

TEST_F(SkyGLTest, noonIsBlueAboveAndPaleAtTheHorizon) {
  // Away from the sun: overhead blue at least twice red; at the horizon brighter and paler.
  settings_.sun.elevationDegrees = 60;
  draw(pose({0, 500, 0}, 180, 45, 0));
  const glm::vec3 high = lightAt(160, 170);
  draw(pose({0, 500, 0}, 180, 0, 0));
  const glm::vec3 low = lightAt(160, 91);
  EXPECT_GT(high.z, 2 * high.x);
  EXPECT_GT(luminance(low), 1.5f * luminance(high));
  EXPECT_LT(low.z / low.x, 0.7f * (high.z / high.x));
}

TEST_F(SkyGLTest, sunStandsWhereTheSettingsSay) {
  // The brightest pixel is the one that the direction to the sun projects to, for suns all over the sky.
  for (const auto& [elevation, azimuth] : {std::pair{50.0, 90.0}, {30.0, 200.0}, {10.0, 340.0}}) {
    settings_.sun.elevationDegrees = elevation;
    settings_.sun.azimuthDegrees = azimuth;
    const View view = pose({0, 500, 0}, azimuth - 90 + 7, elevation - 5, 20);
    draw(view);
    std::size_t brightest = 0;
    for (std::size_t i = 0; i < light_.size(); ++i) {
      if (luminance(glm::vec3(light_[i])) > luminance(glm::vec3(light_[brightest]))) brightest = i;
    }
    const glm::vec4 clip = viewProjection(view) * glm::vec4(glm::vec3(directionToSun(settings_.sun)), 0);
    const glm::vec2 pixel = (glm::vec2(clip) / clip.w * 0.5f + 0.5f) * glm::vec2(320, 180);
    EXPECT_NEAR(static_cast<float>(brightest % 320) + 0.5f, pixel.x, 1.5f);
    EXPECT_NEAR(static_cast<float>(brightest / 320) + 0.5f, pixel.y, 1.5f);
  }
}

TEST_F(SkyGLTest, eveningIsRedTowardsTheSunAndBlueOverhead) {
  // Sun on the horizon: red over blue beneath it. Sun below it: blue over red overhead.
  settings_.sun.elevationDegrees = 0.5;
  draw(pose({0, 500, 0}, 25, 2, 0));
  EXPECT_GT(lightAt(160, 91).x, 2 * lightAt(160, 91).z);
  settings_.sun.elevationDegrees = -4;
  draw(pose({0, 500, 0}, 0, 90, 0));
  EXPECT_GT(lightAt(160, 90).z, 1.2f * lightAt(160, 90).x);
}

TEST_F(SkyGLTest, nightIsDarkBlueAndNotBlack) {
  // Long after sunset the sky is dim, blue, and the same everywhere within 20 %.
  settings_.sun.elevationDegrees = -25;
  const core::Image image = draw(pose({0, 500, 0}, 0, 30, 0));
  const std::uint8_t* pixel = image.pixel(160, 20);
  EXPECT_GT(pixel[2], 20);
  EXPECT_LT(pixel[2], 110);
  EXPECT_GT(pixel[2], pixel[0]);
  EXPECT_NEAR(luminance(lightAt(10, 100)) / luminance(lightAt(300, 170)), 1, 0.2);
}

TEST_F(SkyGLTest, C21_everySunAndEveryAttitudeIsFinite) {
  // Sun at the zenith, setting, below; looking straight up, down, level, rolled; from below the sea to 20 km:
  // finite light, never negative, and no direct light once the sun is under the horizon.
  test::noFaults("C21", "values that are not finite");
  for (const double elevation : {90.0, 45.0, 0.0, -0.2, -3.0, -30.0}) {
    settings_.sun.elevationDegrees = elevation;
    for (const double pitch : {90.0, 0.0, -90.0}) {
      for (const double height : {-5.0, 0.0, 1000.0, 20000.0}) {
        draw(pose({0, height, 0}, 0, pitch, 180));
        for (const glm::vec4& light : light_) {
          for (int c = 0; c < 3; ++c) {
            ASSERT_TRUE(std::isfinite(light[c])) << elevation << " " << pitch << " " << height;
            ASSERT_GE(light[c], 0.0f);
          }
        }
      }
    }
    const double direct = skyLight(settings_, 0).sun.y;
    EXPECT_TRUE(elevation < -0.3 ? direct == 0 : direct > 0) << elevation;
  }
}

TEST_F(SkyGLTest, C22_horizonIsContinuous) {
  // From the row above the horizon to the row below it light changes by less than twice what it changes
  // between the rows beside them, plus 2 %: horizontal rays are no special case. Clear and thick haze, low
  // and high.
  for (const double visibility : {5e3, 8e4, 2e5}) {
    for (const double height : {2.0, 300.0, 3000.0}) {
      settings_.atmosphere.visibilityM = visibility;
      settings_.sun.elevationDegrees = 35;
      View view = pose({0, height, 0}, 120, 0, 0);
      view.fovYRad = 2e-4;  // rows of 1e-6 rad: from 2 m the row below the horizon is 2000 km away
      draw(view);
      const auto row = [&](int y) { return luminance(lightAt(160, y)); };
      const float beside = std::max(std::abs(row(92) - row(91)), std::abs(row(88) - row(87)));
      EXPECT_TRUE(
          test::holds("C22", std::abs(row(90) - row(89)), test::below(2 * beside + 0.02f * row(90)), "light"))
          << visibility << " " << height;
    }
  }
}

TEST_F(SkyGLTest, sunFitsAHalfFloat) {
  // The disc is a million times brighter than the sky; exposure is applied before it is stored, and what is
  // left above the format's range is clipped. Six stops of overexposure change nothing about that.
  settings_.sun.elevationDegrees = 50;
  settings_.exposureStops = 6;
  draw(pose({0, 500, 0}, 0, 50, 0));
  float brightest = 0;
  for (const glm::vec4& light : light_) brightest = std::max(brightest, luminance(glm::vec3(light)));
  EXPECT_GT(brightest, 10000.0f);
  EXPECT_LE(brightest, 60001.0f);  // the stated clip, and half-float rounding above it
}

TEST_F(SkyGLTest, S12_farFromTheOriginTheSkyIsTheSame) {
  // 1e9 m away, where a float of a position is 64 m off: the sky asks for the height and for directions
  // alone.
  test::noFaults("S12", "differences");
  settings_.sun.elevationDegrees = -2;
  draw(pose({0, 500, 0}, 20, 3, 10));
  const std::vector<glm::vec4> here = light_;
  draw(pose({1e9, 500, -1e9}, 20, 3, 10));
  EXPECT_EQ(here, light_);
}

TEST_F(SkyGLTest, S13_nextToTheSunNoHalfFloatOverflows) {
  // In a picture of 2 degrees about the disc, in haze that scatters forward and six stops over: finite,
  // within the format, and bright.
  test::noFaults("S13", "violations");
  settings_.atmosphere.hazeAnisotropy = 0.95;
  settings_.exposureStops = 6;
  for (const sky::SkyModel model : {sky::SkyModel::closedForm, sky::SkyModel::shell}) {
    settings_.sky.model = model;
    for (const double elevation : {50.0, 0.2}) {
      settings_.sun.elevationDegrees = elevation;
      View view = pose({0, 500, 0}, 0, elevation, 0);
      view.fovYRad = glm::radians(2.0);
      draw(view);
      for (const glm::vec4& light : light_) {
        for (int c = 0; c < 3; ++c) ASSERT_TRUE(light[c] >= 0 && light[c] <= 60001.0f) << elevation;
      }
      EXPECT_GT(luminance(lightAt(160, 90)), 100.0f) << elevation;
    }
  }
}

TEST_F(SkyGLTest, shadersReadTheTablesAsTheProgramDoes) {
  // Pixel for pixel against the same tables in double: in the light, at the horizon and below it, by day and
  // in twilight. Half floats hold 1e-3.
  for (const double elevation : {25.0, -1.0}) {
    for (const double height : {10.0, 9000.0}) {
      settings_.sun.elevationDegrees = elevation;
      const View view = pose({0, height, 0}, 200, 0, 0);
      draw(view);
      const SkyLight light = skyLight(settings_, height);
      ASSERT_TRUE(light.isShell());
      const glm::dmat3 toRay = rayMatrix(view);
      for (int y = 5; y < 180; y += 13) {
        for (int x = 3; x < 320; x += 29) {
          const glm::dvec3 direction =
              glm::normalize(toRay * glm::dvec3((x + 0.5) / 160 - 1, (y + 0.5) / 90 - 1, 1));
          if (direction.y < light.view->horizon) continue;  // the plain adds to it
          const glm::dvec3 expected = sky::skyRadiance(light, direction) * light.exposure;
          for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(static_cast<double>(lightAt(x, y)[c]) / expected[c], 1, 2e-3) << x << ' ' << y;
        }
      }
    }
  }
}

// A black surface seen through haze from every pixel, straight ahead and level.
class HazePass final : public Pass {
 public:
  HazePass(gl::Context& context, const test::TemporaryFolder& folder, double distance)
      : triangle_(context),
        fragment_(
            folder.write("haze.frag",
                         "#include \"frame.glsl\"\nin vec2 ndc;\nuniform vec3 place;\nout vec4 color;\n"
                         "void main() { color = vec4(applyAerialPerspective(vec3(0.0), place), 1.0); }\n")),
        distance_(distance) {}
  std::string_view name() const override { return "haze"; }
  RenderStage stage() const override { return RenderStage::weatherEffects; }
  void draw(FrameContext& context) override {
    context.gl.api().Disable(GL_DEPTH_TEST);
    gl::Shader& shader = context.shaders.shader("fullscreen.vert", fragment_, context.defines);
    shader.setVec3("place", glm::vec3(context.frame.view.forward() * distance_));
    shader.use();
    triangle_.draw();
  }

 private:
  FullscreenTriangle triangle_;
  std::string fragment_;
  double distance_;
};

TEST_F(SkyGLTest, hazeIsThatOfTheAirBetween) {
  // Against the same functions in double: what a black surface shows is the horizon's light times what the
  // path takes away. Low and high, near and far; half floats hold 1e-3.
  const test::TemporaryFolder folder;
  settings_.sun.elevationDegrees = 30;
  for (const double height : {0.0, 4000.0}) {
    for (const double distance : {500.0, 20000.0}) {
      Renderer renderer(context(), settings_, false);
      renderer.add(std::make_unique<HazePass>(context(), folder, distance));
      renderer.add(std::make_unique<LightProbe>(light_));
      const View view = pose({0, height, 0}, 60, 0, 0);
      renderer.draw({.view = view, .features = {.haze = true}});
      const SkyLight light = skyLight(settings_, height);
      const glm::dvec3 expected =
          sky::applyAerialPerspective(light, glm::dvec3(0), height, view.forward() * distance) *
          light.exposure;
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(static_cast<double>(light_[0][c]) / expected[c], 1, 1e-3) << height;
    }
  }
}

TEST_F(SkyGLTest, hazeIsAVariantAndNotABranch) {
  // With the feature another program runs; what haze does is seen below the horizon, where it veils the land.
  settings_.sun.elevationDegrees = 40;
  const core::Image hazy = draw(pose({0, 3000, 0}, 120, -10, 0));
  const std::size_t programs = renderer().shaders().size();
  features_.haze = false;
  const core::Image clear = draw(pose({0, 3000, 0}, 120, -10, 0));
  EXPECT_EQ(renderer().shaders().size(), programs + 1);
  EXPECT_GT(test::compareImages(hazy, clear).largest, 20);
  for (int x = 0; x < 320; x += 40) {
    for (int c = 0; c < 3; ++c) EXPECT_EQ(hazy.pixel(x, 2)[c], clear.pixel(x, 2)[c]);  // above the horizon
  }
}

}  // namespace
}  // namespace skydrop::render
