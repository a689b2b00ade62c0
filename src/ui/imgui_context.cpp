#include "skydrop/ui/imgui_context.h"

#include <imgui.h>

#include <algorithm>

#include "ui/font_atlas.h"

namespace skydrop::ui {
namespace {

constexpr int kLinesOfHeight = 40;  // lines of text that fit into the window's height
constexpr int kLinesOfWidth = 60;   // and into its width, so that narrow windows keep their rows
constexpr int kMinLinePixels = 10;  // below that an 8 and a 0 look the same
constexpr int kMaxLinePixels = 96;
constexpr int kFewestLinesOfHeight = 18, kFewestLinesOfWidth = 32;  // what HUD and menu need: 320 x 180 at 10
constexpr double kMinFrameSeconds = 1e-6, kMaxFrameSeconds = 0.25;

ImVec4 grey(float value, float alpha) { return {value, value, value, alpha}; }

// Dark, flat, square: it should sit over a landscape without competing with it. One accent.
void setStyle(ImGuiStyle& style, float line) {
  style = ImGuiStyle();
  const auto units = [line](float lines) {
    return std::max(1.0f, static_cast<float>(static_cast<int>(lines * line + 0.5f)));
  };
  style.WindowPadding = {units(0.5f), units(0.4f)};
  style.FramePadding = {units(0.35f), units(0.12f)};
  style.CellPadding = {units(0.2f), units(0.1f)};
  style.ItemSpacing = {units(0.4f), units(0.2f)};
  style.ItemInnerSpacing = {units(0.3f), units(0.2f)};
  style.IndentSpacing = units(0.6f);
  style.ScrollbarSize = units(0.6f);
  style.GrabMinSize = units(0.6f);
  style.WindowRounding = style.FrameRounding = style.GrabRounding = style.ScrollbarRounding = units(0.12f);
  style.PopupRounding = style.WindowRounding;
  style.WindowBorderSize = style.PopupBorderSize = 1;
  style.WindowMinSize = {units(8), units(4)};
  style.WindowTitleAlign = {0, 0.5f};
  style.WindowMenuButtonPosition = ImGuiDir_None;
  style.AntiAliasedLinesUseTex = false;  // the atlas holds glyphs only

  ImVec4* colors = style.Colors;
  const ImVec4 accent{0.95f, 0.62f, 0.20f, 1}, accentDim{0.95f, 0.62f, 0.20f, 0.55f};
  colors[ImGuiCol_Text] = grey(0.94f, 1);
  colors[ImGuiCol_TextDisabled] = grey(0.62f, 1);
  colors[ImGuiCol_WindowBg] = {0.05f, 0.07f, 0.09f, 0.88f};
  colors[ImGuiCol_PopupBg] = {0.04f, 0.05f, 0.07f, 0.96f};
  colors[ImGuiCol_Border] = grey(1, 0.16f);
  colors[ImGuiCol_TitleBg] = colors[ImGuiCol_TitleBgCollapsed] = {0.03f, 0.04f, 0.06f, 0.92f};
  colors[ImGuiCol_TitleBgActive] = {0.09f, 0.12f, 0.16f, 0.96f};
  colors[ImGuiCol_FrameBg] = grey(1, 0.09f);
  colors[ImGuiCol_FrameBgHovered] = grey(1, 0.15f);
  colors[ImGuiCol_FrameBgActive] = grey(1, 0.20f);
  colors[ImGuiCol_SliderGrab] = accentDim;
  colors[ImGuiCol_SliderGrabActive] = colors[ImGuiCol_CheckMark] = accent;
  colors[ImGuiCol_Button] = colors[ImGuiCol_Header] = grey(1, 0.10f);
  colors[ImGuiCol_ButtonHovered] = colors[ImGuiCol_HeaderHovered] = grey(1, 0.20f);
  colors[ImGuiCol_ButtonActive] = colors[ImGuiCol_HeaderActive] = accentDim;
  colors[ImGuiCol_Separator] = grey(1, 0.14f);
  colors[ImGuiCol_ScrollbarBg] = grey(0, 0.2f);
  colors[ImGuiCol_ScrollbarGrab] = grey(1, 0.2f);
  colors[ImGuiCol_ScrollbarGrabHovered] = colors[ImGuiCol_ScrollbarGrabActive] = accentDim;
  colors[ImGuiCol_ResizeGrip] = grey(1, 0.1f);
  colors[ImGuiCol_ResizeGripHovered] = colors[ImGuiCol_ResizeGripActive] = accentDim;
  colors[ImGuiCol_TableHeaderBg] = grey(1, 0.06f);
  colors[ImGuiCol_TableBorderLight] = colors[ImGuiCol_TableBorderStrong] = grey(1, 0.10f);
  colors[ImGuiCol_TextSelectedBg] = {0.95f, 0.62f, 0.20f, 0.35f};
}

}  // namespace

void Interface::ContextDeleter::operator()(ImGuiContext* context) const { ImGui::DestroyContext(context); }

Interface::Interface(int width, int height, const InterfaceScale& scale)
    : context_(ImGui::CreateContext()), width_(width), height_(height) {
  ImGui::SetCurrentContext(context_.get());
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = io.LogFilename = nullptr;
  io.BackendPlatformName = "skydrop";
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  io.ConfigInputTextCursorBlink = false;  // a frame does not depend on when it is drawn
  rebuildFonts(linePixels(width, height, scale));
}

Interface::~Interface() = default;

int Interface::linePixels(int width, int height, const InterfaceScale& scale) {
  const int usual = std::min(height / kLinesOfHeight, width / kLinesOfWidth);
  const double wanted = std::max(static_cast<double>(usual), kMinLinePixels * scale.density) * scale.factor;
  const int largest = std::min(height / kFewestLinesOfHeight, width / kFewestLinesOfWidth);
  const int line = static_cast<int>(std::min(wanted, static_cast<double>(kMaxLinePixels)));
  return std::max(std::min(line, largest), kMinLinePixels);
}

void Interface::rebuildFonts(int linePixels) {
  ImGuiIO& io = ImGui::GetIO();
  const InterfaceFonts fonts = buildFonts(*io.Fonts, linePixels);
  text_ = fonts.text;
  large_ = fonts.large;
  io.FontDefault = text_.face;
  setStyle(ImGui::GetStyle(), text_.pixels);
}

void Interface::makeCurrent() const { ImGui::SetCurrentContext(context_.get()); }

bool Interface::beginFrame(int width, int height, double seconds, const InterfaceScale& scale) {
  makeCurrent();
  width_ = std::max(width, 1);
  height_ = std::max(height, 1);
  const int line = linePixels(width_, height_, scale);
  const bool rebuild = static_cast<float>(line) != text_.pixels;
  if (rebuild) rebuildFonts(line);
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(width_), static_cast<float>(height_)};
  // Written so that NaN ends at the lower limit.
  io.DeltaTime =
      static_cast<float>(seconds > kMinFrameSeconds ? std::min(seconds, kMaxFrameSeconds) : kMinFrameSeconds);
  ImGui::NewFrame();
  return rebuild;
}

ImDrawData* Interface::endFrame() {
  ImGui::Render();
  return ImGui::GetDrawData();
}

}  // namespace skydrop::ui
