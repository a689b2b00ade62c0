// The laboratory's pages at their defaults against the pictures that were looked at, which docs/laboratory.md
// shows: docs/images/lab/NAME.png (SKYDROP_UPDATE_GOLDENS=1 replaces them).
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "skydrop/lab/page.h"
#include "skydrop/render/lab/page_picture.h"
#include "support/gl_test.h"
#include "support/image_compare.h"
#include "support/paths.h"

namespace skydrop::test {
namespace {

// As of the game's frames (golden_test.cpp).
constexpr ImageLimits kSoftwareRounding{48, 0.02};
// Numbers made by sines are others on other processors, which is what these pages are about.
constexpr ImageLimits kOfSines{255, 45};

class GoldenLaboratory : public GLTest, public testing::WithParamInterface<std::string> {};

TEST_P(GoldenLaboratory, page) {
  const lab::Page& page = lab::pageNamed(GetParam());
  const auto knobs = page.makeKnobs();
  render::PagePicture picture(context(), page, knobs->table(), 320, 180);
  if (page.volume) picture.setVolume(page.volume(*knobs));
  picture.draw(page.plot ? page.plot(*knobs) : std::vector<lab::Curve>());
  const bool isOfSines = page.name == "sine-plot" || page.name == "random";
  EXPECT_TRUE(matchesReference(picture.read(),
                               std::filesystem::path(sourceDir()) / "docs/images/lab" / (GetParam() + ".png"),
                               isOfSines ? kOfSines : kSoftwareRounding));
}

std::vector<std::string> pageNames() {
  std::vector<std::string> names;
  for (const lab::Page& page : lab::pages()) names.emplace_back(page.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Pages, GoldenLaboratory, testing::ValuesIn(pageNames()), [](const auto& given) {
  std::string name = given.param;
  std::ranges::replace(name, '-', '_');
  return name;
});

}  // namespace
}  // namespace skydrop::test
