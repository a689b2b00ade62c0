// Runs the interface without a window: mouse and keys as the window's events, at any frame rate.
#pragma once

#include <functional>
#include <utility>

#include "app/input/event_feed.h"
#include "app/input/imgui_input.h"
#include "app/input/input_code.h"
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

  // Frames that are shown; events that were sent come before the first.
  void frames(int count) {
    for (int i = 0; i < count; ++i) {
      feed_.deliver({first_, [] { return true; }, [this] { build(0); }});
      build(secondsAFrame_);
      now_ += secondsAFrame_;
    }
  }
  void setFrameRate(double framesASecond) { secondsAFrame_ = 1 / framesASecond; }
  // Who gets events before the interface does: the flight, in the game.
  void setFirstReader(std::function<bool(const Event&)> first) { first_ = std::move(first); }

  // It happens at some time during the next frame.
  void send(Event event) {
    event.earliestSeconds = now_;
    event.latestSeconds = now_ + secondsAFrame_;
    feed_.add(event);
  }

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
    event.letter = render::gl::letterOfKey(code, nullptr);
    event.pressed = pressed;
    if (code == app::key::kLeftControl) control_ = pressed;
    event.modifiers = control_ ? 2 : 0;  // GLFW_MOD_CONTROL
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
  void build(double seconds) {
    fontsChanged_ = interface_.beginFrame(width_, height_, seconds);
    feed_.frameBuilt();
    draw_(interface_);
    data_ = interface_.endFrame();
  }

  ui::Interface interface_;
  app::ImGuiInput input_;
  app::EventFeed feed_{input_};
  std::function<bool(const Event&)> first_;
  double secondsAFrame_ = 1.0 / 60, now_ = 0;
  bool control_ = false;
  std::function<void(const ui::Interface&)> draw_;
  int width_, height_;
  ImDrawData* data_ = nullptr;
  bool fontsChanged_ = false;
};

}  // namespace skydrop::test
