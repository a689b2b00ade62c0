// The laboratory: its pages as pictures, and its interface without a window.
#include "app/window/laboratory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <set>

#include "skydrop/lab/shared.h"
#include "support/gl_test.h"

namespace skydrop::app {
namespace {

constexpr Size kSize{640, 360};

class LaboratoryGLTest : public test::GLTest {
 protected:
  core::Image pictureOf(const lab::Page& page, const lab::Knobs& knobs, int width = 160, int height = 90) {
    render::PagePicture picture(context(), page, knobs.table(), width, height);
    if (page.volume) picture.setVolume(page.volume(knobs));
    picture.draw(page.plot ? page.plot(knobs) : std::vector<lab::Curve>());
    return picture.read();
  }
};

int coloursIn(const core::Image& image) {
  std::set<std::uint32_t> colours;
  for (std::size_t i = 0; i + 3 < image.rgba.size(); i += 4)
    colours.insert(image.rgba[i] | image.rgba[i + 1] << 8 |
                   static_cast<std::uint32_t>(image.rgba[i + 2]) << 16);
  return static_cast<int>(colours.size());
}

TEST_F(LaboratoryGLTest, everyPageDrawsAndKnowsItsCost) {
  // A picture of many colours, the same each time, a sentence and a table; one program a page, gone with it.
  std::set<std::string_view> names;
  const auto live = context().resources().liveObjects();
  for (const lab::Page& page : lab::pages()) {
    EXPECT_TRUE(names.insert(page.name).second) << page.name;
    const auto knobs = page.makeKnobs();
    const core::Image picture = pictureOf(page, *knobs);
    EXPECT_GT(coloursIn(picture), 20) << page.name;
    EXPECT_EQ(picture.rgba, pictureOf(page, *knobs).rgba) << page.name;
    const lab::Figures figures = page.measure(*knobs);
    EXPECT_FALSE(figures.summary.empty()) << page.name;
    ASSERT_FALSE(figures.rows.empty()) << page.name;
    for (const auto& row : figures.rows)
      EXPECT_EQ(row.size() + (figures.labels.empty() ? 0 : 1), figures.columns.size()) << page.name;
    EXPECT_EQ(context().resources().liveObjects(), live) << page.name;
  }
  EXPECT_GE(names.size(), 20u);
}

TEST_F(LaboratoryGLTest, theEyeTurnsThePicture) {
  for (const lab::Page& page : lab::pages()) {
    const auto knobs = page.makeKnobs();
    const core::Field* azimuth = knobs->table().find("view.azimuthDegrees");
    if (!azimuth || page.name == "moods") continue;
    const core::Image before = pictureOf(page, *knobs);
    core::setField(*azimuth, azimuth->get() + 30);
    EXPECT_NE(pictureOf(page, *knobs).rgba, before.rgba) << page.name;
  }
}

TEST_F(LaboratoryGLTest, shadersDrawWhatTheProcessorComputes) {
  // Perlin noise of the page against the shared text in float, of the panel with the fade: within two steps
  // of 8 bits.
  const lab::Page& page = lab::pageNamed("perlin");
  const auto knobs = page.makeKnobs();
  const core::Image picture = pictureOf(page, *knobs, 600, 400);
  const std::uint32_t salt = core::shared::f32::octaveSalt(0, 0, 2);
  int compared = 0;
  for (int y = 10; y < 190; y += 7) {
    for (int x = 10; x < 190; x += 7) {
      const glm::vec2 place((static_cast<float>(x) + 0.5f) / 200, (static_cast<float>(y) + 0.5f) / 200);
      const float value = 0.5f + 0.5f * core::shared::f32::perlinPlane(place, 10, salt);
      // The panel is the lower right one, its first row the lowest.
      EXPECT_NEAR(picture.pixel(400 + x, 399 - y)[0], 255 * value, 2) << x << ' ' << y;
      ++compared;
    }
  }
  EXPECT_GT(compared, 500);
}

TEST_F(LaboratoryGLTest, knobsAtTheirEndsDrawWithoutErrors) {
  // Each knob at both ends of its slider and of its range, but for what only takes long: the fixture looks
  // for errors of the driver.
  for (const lab::Page& page : lab::pages()) {
    const auto knobs = page.makeKnobs();
    for (const core::Field& field : knobs->table().fields()) {
      const bool takesLong = field.path == "mostSteps" || field.path == "steps" ||
                             field.path == "lightSamples" || field.path == "count";
      for (const double value :
           {field.min, field.sliderMin, field.sliderMax, takesLong ? field.sliderMax : field.max}) {
        core::setField(field, field.kind == core::FieldKind::integer ? std::floor(value) : value);
        EXPECT_EQ(pictureOf(page, *knobs, 32, 18).width, 32);
      }
      field.reset();
    }
  }
}

TEST_F(LaboratoryGLTest, aPictureIsDrawnWhenSomethingHasChangedAlone) {
  const auto begin = std::chrono::steady_clock::now();
  Laboratory room(context(), kSize);
  room.draw(kSize, 0);
  // Opening takes under a second; a slow machine may take three.
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), 3);
  room.draw(kSize, 0);
  EXPECT_EQ(room.picturesDrawn(), 1);
  core::setField(room.knobs().table(), "stride=0.5");
  room.refresh();
  room.draw(kSize, 0);
  EXPECT_EQ(room.picturesDrawn(), 2);
  room.draw({800, 450}, 0);
  EXPECT_EQ(room.picturesDrawn(), 3);
  room.open(lab::pageNamed("moods"));
  room.draw({800, 450}, 0);
  EXPECT_EQ(room.picturesDrawn(), 4);
  EXPECT_EQ(room.page().name, "moods");
  EXPECT_TRUE(room.view().placeOf("perlin"));
}

}  // namespace
}  // namespace skydrop::app
