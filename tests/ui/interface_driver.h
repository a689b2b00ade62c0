// Runs the interface without a window: mouse and keys as the window's events, one call a frame.
#pragma once

#include <functional>
#include <utility>

#include "app/imgui_input.h"
#include "skydrop/ui/imgui_context.h"

namespace skydrop::test {

class InterfaceDriver {
 public:
  using Event = render::gl::WindowEvent;

  InterfaceDriver(int width, int height, std::function<void(const ui::Interface&)> draw)
      : interface_(width, height), draw_(std::move(draw)), width_(width), height_(height) {
    frames(2);  // windows find their size
  }

  const ui::Interface& context() const { return interface_; }
  ImDrawData* drawData() { return data_; }
  bool fontsChanged() const { return fontsChanged_; }

  void resize(int width, int height) {
    width_ = width;
    height_ = height;
  }

  void frames(int count) {
    for (int i = 0; i < count; ++i) {
      input_.beginFrame();
      fontsChanged_ = interface_.beginFrame(width_, height_, 1.0 / 60);
      draw_(interface_);
      data_ = interface_.endFrame();
    }
  }

  void send(const Event& event) { input_.handle(event); }

  void move(float x, float y) {
    Event event{Event::Kind::mouseMove};
    event.x = x;
    event.y = y;
    send(event);
    frames(1);
  }

  void button(float x, float y, bool pressed) {
    Event event{Event::Kind::mouseButton};
    event.pressed = pressed;
    event.x = x;
    event.y = y;
    send(event);
    frames(1);
  }

  // A click within one frame, as slow frames see it.
  void click(const ui::ScreenRect& rect) {
    Event event{Event::Kind::mouseButton};
    event.x = (rect.left + rect.right) / 2;
    event.y = (rect.top + rect.bottom) / 2;
    event.pressed = true;
    send(event);
    event.pressed = false;
    send(event);
    frames(3);
  }

  void key(int code, bool pressed) {
    Event event{Event::Kind::key};
    event.code = code;
    event.pressed = pressed;
    send(event);
  }

  void tap(int code) {
    key(code, true);
    key(code, false);
    frames(3);
  }

  void type(const char* text) {
    for (; *text; ++text) {
      Event event{Event::Kind::character};
      event.character = static_cast<unsigned char>(*text);
      send(event);
    }
    frames(1);
  }

 private:
  ui::Interface interface_;
  app::ImGuiInput input_;
  std::function<void(const ui::Interface&)> draw_;
  int width_, height_;
  ImDrawData* data_ = nullptr;
  bool fontsChanged_ = false;
};

}  // namespace skydrop::test
