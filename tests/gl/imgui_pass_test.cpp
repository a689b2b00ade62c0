#include "skydrop/render/overlay/imgui_pass.h"

#include <gmock/gmock.h>
#include <imgui.h>

#include "skydrop/render/frame/renderer.h"
#include "skydrop/render/frame/tone_map_pass.h"
#include "skydrop/render/sky/sky_pass.h"
#include "support/frame_test.h"
#include "support/image_compare.h"

namespace skydrop::render {
namespace {

// An ImGui context without files, for one test.
class ImGuiScope {
 public:
  ImGuiScope() {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
  }
  ~ImGuiScope() { ImGui::DestroyContext(); }
  ImGuiScope(const ImGuiScope&) = delete;
  ImGuiScope& operator=(const ImGuiScope&) = delete;

  // A frame with text, shapes, a clipped child and a rectangle of one colour in the corner at the lower
  // right.
  static void build(float width, float height) {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {width, height};
    io.DeltaTime = 1.0f / 60;
    // A new window is laid out over two frames.
    for (int i = 0; i < 3; ++i) {
      ImGui::NewFrame();
      ImGui::SetNextWindowPos({10, 10});
      ImGui::SetNextWindowSize({180, 120});
      ImGui::Begin("Aircraft", nullptr, ImGuiWindowFlags_NoSavedSettings);
      ImGui::Text("Cruise %d m/s", 70);
      float value = 0.4f;
      ImGui::SliderFloat("roll", &value, 0, 1);
      ImGui::BeginChild("clipped", {100, 30});
      for (int line = 0; line < 10; ++line) ImGui::Text("line %d", line);
      ImGui::EndChild();
      ImGui::End();
      ImGui::GetForegroundDrawList()->AddRectFilled({width - 20, height - 10}, {width, height},
                                                    IM_COL32(255, 0, 0, 255));
      // A blue rectangle of which the clip leaves 30x4 pixels near the top.
      ImGui::GetForegroundDrawList()->PushClipRect({200, 5}, {230, 9});
      ImGui::GetForegroundDrawList()->AddRectFilled({0, 0}, {width, height}, IM_COL32(0, 0, 255, 255));
      ImGui::GetForegroundDrawList()->PopClipRect();
      ImGui::GetForegroundDrawList()->AddCircle({width - 60, height - 40}, 25, IM_COL32(255, 255, 0, 200), 0,
                                                3);
      ImGui::Render();
    }
  }
};

core::Image drawMenu(gl::Context& context) {
  context.makeCurrent();
  const ImGuiScope imgui;
  Renderer renderer(context, {}, false);
  renderer.add(std::make_unique<SkyPass>(context));
  renderer.add(std::make_unique<ToneMapPass>(context));
  renderer.add(std::make_unique<ImGuiPass>(context));
  ImGuiScope::build(320, 180);
  Camera camera;
  camera.setPose({0, 500, 0}, 1, 0.2, 0);
  renderer.draw({.view = camera.view({}, {}, 320, 180), .features = {.haze = true}});
  return renderer.readBack();
}

TEST(Backends, imguiIsTheSameInEveryBit) {
  // The menu over the sky, drawn on EGL and on OSMesa in one process.
  std::string why;
  const auto egl = test::openForTest(gl::Backend::egl, why);
  if (!egl) GTEST_SKIP() << why;
  const auto osmesa = test::openForTest(gl::Backend::osmesa, why);
  if (!osmesa) GTEST_SKIP() << why;
  const core::Image first = drawMenu(*egl), second = drawMenu(*osmesa);
  EXPECT_EQ(first.rgba, second.rgba);
  test::writeArtifact("imgui", first);
  for (const gl::Context* context : {egl.get(), osmesa.get()}) {
    EXPECT_EQ(context->debugErrors(), 0u);
    EXPECT_EQ(context->resources().liveObjects(), 0);
  }
}

using ImGuiGLTest = test::FrameTest;

TEST_F(ImGuiGLTest, menuIsDrawnWhereItWasPutAndClipped) {
  // A rectangle at the lower right of the screen is red there and nowhere else; a screen of blue shows
  // through its clip only: the target is upright.
  const core::Image image = drawMenu(context());
  const auto isColor = [&](int x, int y, int r, int g, int b) {
    const std::uint8_t* p = image.pixel(x, y);
    return p[0] == r && p[1] == g && p[2] == b;
  };
  int red = 0, blue = 0;
  for (int y = 0; y < 180; ++y) {
    for (int x = 0; x < 320; ++x) {
      red += isColor(x, y, 255, 0, 0);
      blue += isColor(x, y, 0, 0, 255);
    }
  }
  EXPECT_EQ(red, 200);
  EXPECT_TRUE(isColor(319, 179, 255, 0, 0));
  EXPECT_TRUE(isColor(300, 170, 255, 0, 0));
  EXPECT_EQ(blue, 120);
  EXPECT_TRUE(isColor(200, 5, 0, 0, 255));
  EXPECT_TRUE(isColor(229, 8, 0, 0, 255));
}

TEST_F(ImGuiGLTest, nothingShownIsIdle) {
  // Without anything to draw the pass says so and draws nothing.
  const ImGuiScope imgui;
  renderer().add(std::make_unique<ImGuiPass>(context()));
  ImGui::GetIO().DisplaySize = {320, 180};
  ImGui::NewFrame();
  ImGui::Render();
  draw(pose({0, 0, 0}, 0, 0, 0));
  core::FrameStatistics statistics;
  renderer().fillStatistics(statistics);
  EXPECT_EQ(statistics.passes[0].second.skipped, "nothing shown");
  EXPECT_EQ(statistics.passes[0].second.draws, 0);
}

}  // namespace
}  // namespace skydrop::render
