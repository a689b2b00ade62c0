#define GLFW_INCLUDE_NONE
#include "skydrop/render/platform/window_context.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <utility>

#include "skydrop/core/error.h"

namespace skydrop::render::gl {
namespace {

std::string lastGlfwError() {
  const char* description = nullptr;
  glfwGetError(&description);
  return description ? description : "no reason given";
}

// GLFW is initialised by the first window and ended by the last. Main thread.
int windowCount = 0;

}  // namespace

struct WindowContext::Impl {
  GLFWwindow* window = nullptr;
  std::vector<WindowEvent> events;
  double polled = 0;                  // seconds, when events were last asked for
  double pointerX = 0, pointerY = 0;  // window coordinates, of the last move
  int restoreX = 0, restoreY = 0, restoreWidth = 0, restoreHeight = 0;

  explicit Impl(const WindowSettings& settings) {
    if (windowCount == 0 && !glfwInit()) {
      throw core::GraphicsUnavailable("no display for a window (" + lastGlfwError() +
                                      "); `skydrop render` draws without one");
    }
    ++windowCount;
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, GLFW_LOSE_CONTEXT_ON_RESET);  // where the driver can tell
    glfwWindowHint(GLFW_SRGB_CAPABLE, GLFW_FALSE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_VISIBLE, settings.visible ? GLFW_TRUE : GLFW_FALSE);
    window = glfwCreateWindow(settings.width, settings.height, settings.title.c_str(), nullptr, nullptr);
    if (!window) {
      const std::string reason = lastGlfwError();
      release();
      throw core::GraphicsUnavailable("window: OpenGL 4.5 core is needed (" + reason + ")");
    }
    glfwSetWindowUserPointer(window, this);
    setCallbacks();
  }

  ~Impl() { release(); }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void release() {
    if (window) glfwDestroyWindow(std::exchange(window, nullptr));
    if (--windowCount == 0) glfwTerminate();
  }

  static Impl& of(GLFWwindow* window) { return *static_cast<Impl*>(glfwGetWindowUserPointer(window)); }

  void take(WindowEvent::Kind kind, double x, double y) {
    WindowEvent event{kind};
    event.x = x;
    event.y = y;
    events.push_back(event);
  }

  void setCallbacks() {
    using Kind = WindowEvent::Kind;
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scanCode, int action, int modifiers) {
      WindowEvent event{Kind::key};
      event.code = key;
      event.scanCode = scanCode;
      event.letter = letterOfKey(key, glfwGetKeyName(key, scanCode));
      event.pressed = action != GLFW_RELEASE;
      event.repeated = action == GLFW_REPEAT;
      event.modifiers = modifiers;
      of(w).events.push_back(event);
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int modifiers) {
      WindowEvent event{Kind::mouseButton};
      event.code = button;
      event.pressed = action == GLFW_PRESS;
      event.modifiers = modifiers;
      // Where the pointer was then: glfwGetCursorPos would tell where it is by now.
      event.x = of(w).pointerX;
      event.y = of(w).pointerY;
      of(w).events.push_back(event);
    });
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
      of(w).pointerX = x;
      of(w).pointerY = y;
      of(w).take(Kind::mouseMove, x, y);
    });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) { of(w).take(Kind::scroll, x, y); });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned character) {
      WindowEvent event{Kind::character};
      event.character = character;
      of(w).events.push_back(event);
    });
    glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int gained) {
      WindowEvent event{Kind::focus};
      event.pressed = gained == GLFW_TRUE;
      of(w).events.push_back(event);
    });
    glfwSetFramebufferSizeCallback(
        window, [](GLFWwindow* w, int width, int height) { of(w).take(Kind::resize, width, height); });
  }

  // The monitor that holds the window's centre, or the primary one.
  GLFWmonitor* monitor() const {
    int x = 0, y = 0, width = 0, height = 0, count = 0;
    glfwGetWindowPos(window, &x, &y);
    glfwGetWindowSize(window, &width, &height);
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    for (int i = 0; i < count; ++i) {
      int left = 0, top = 0;
      glfwGetMonitorPos(monitors[i], &left, &top);
      const GLFWvidmode* mode = glfwGetVideoMode(monitors[i]);
      const int centreX = x + width / 2, centreY = y + height / 2;
      if (mode && centreX >= left && centreX < left + mode->width && centreY >= top &&
          centreY < top + mode->height) {
        return monitors[i];
      }
    }
    return glfwGetPrimaryMonitor();
  }
};

char letterOfKey(int code, const char* name) {
  const auto isLetter = [](int c) { return c >= 'A' && c <= 'Z'; };
  if (name && name[0] > 0 && name[1] == '\0') {  // ASCII
    const int capital = name[0] >= 'a' && name[0] <= 'z' ? name[0] - 'a' + 'A' : name[0];
    return isLetter(capital) ? static_cast<char>(capital) : '\0';
  }
  return isLetter(code) ? static_cast<char>(code) : '\0';
}

WindowContext::WindowContext(const WindowSettings& settings)
    : Context(Backend::window), impl_(std::make_unique<Impl>(settings)) {
  try {
    initialise();
  } catch (...) {
    shutDown();
    throw;
  }
  if (settings.fullScreen) setFullScreen(true);
}

WindowContext::~WindowContext() { shutDown(); }

int WindowContext::width() const {
  int width = 0, height = 0;
  glfwGetFramebufferSize(impl_->window, &width, &height);
  return std::max(width, 1);
}

int WindowContext::height() const {
  int width = 0, height = 0;
  glfwGetFramebufferSize(impl_->window, &width, &height);
  return std::max(height, 1);
}

double WindowContext::pixelsPerUnit() const {
  int width = 0, height = 0;
  glfwGetWindowSize(impl_->window, &width, &height);
  return width > 0 ? static_cast<double>(this->width()) / width : 1;  // 0 while it is minimised
}

bool WindowContext::shouldClose() const { return glfwWindowShouldClose(impl_->window); }

void WindowContext::setShouldClose(bool close) { glfwSetWindowShouldClose(impl_->window, close); }

void WindowContext::swap() { glfwSwapBuffers(impl_->window); }

void WindowContext::setVsync(bool on) {
  makeCurrent();
  glfwSwapInterval(on ? 1 : 0);
}

bool WindowContext::isFullScreen() const { return glfwGetWindowMonitor(impl_->window) != nullptr; }

void WindowContext::setFullScreen(bool on) {
  if (on == isFullScreen()) return;
  Impl& self = *impl_;
  if (!on) {
    glfwSetWindowMonitor(self.window, nullptr, self.restoreX, self.restoreY, self.restoreWidth,
                         self.restoreHeight, GLFW_DONT_CARE);
    return;
  }
  GLFWmonitor* monitor = self.monitor();
  const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
  if (!mode) return;  // no monitor to fill
  glfwGetWindowPos(self.window, &self.restoreX, &self.restoreY);
  glfwGetWindowSize(self.window, &self.restoreWidth, &self.restoreHeight);
  glfwSetWindowMonitor(self.window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void WindowContext::setPointerVisible(bool visible) {
  glfwSetInputMode(impl_->window, GLFW_CURSOR, visible ? GLFW_CURSOR_NORMAL : GLFW_CURSOR_HIDDEN);
}

std::string WindowContext::clipboardText() const {
  const char* text = glfwGetClipboardString(impl_->window);
  return text ? text : "";
}

void WindowContext::setClipboardText(const std::string& text) {
  glfwSetClipboardString(impl_->window, text.c_str());
}

void WindowContext::show() { glfwShowWindow(impl_->window); }

bool WindowContext::isHidden() const {
  return glfwGetWindowAttrib(impl_->window, GLFW_ICONIFIED) == GLFW_TRUE ||
         glfwGetWindowAttrib(impl_->window, GLFW_VISIBLE) == GLFW_FALSE;
}

WindowRect WindowContext::rect() const {
  const Impl& self = *impl_;
  if (isFullScreen()) return {self.restoreX, self.restoreY, self.restoreWidth, self.restoreHeight};
  WindowRect rect;
  glfwGetWindowPos(self.window, &rect.left, &rect.top);
  glfwGetWindowSize(self.window, &rect.width, &rect.height);
  return rect;
}

void WindowContext::setSize(int width, int height) { glfwSetWindowSize(impl_->window, width, height); }

void WindowContext::setPosition(int left, int top) { glfwSetWindowPos(impl_->window, left, top); }

WindowFrame WindowContext::frame() const {
  WindowFrame frame;
  glfwGetWindowFrameSize(impl_->window, &frame.left, &frame.top, &frame.right, &frame.bottom);
  return frame;
}

std::vector<WindowRect> WindowContext::screens() const {
  int count = 0;
  GLFWmonitor** monitors = glfwGetMonitors(&count);
  std::vector<WindowRect> screens(static_cast<std::size_t>(std::max(count, 0)));
  for (std::size_t i = 0; i < screens.size(); ++i) {
    WindowRect& screen = screens[i];
    glfwGetMonitorWorkarea(monitors[i], &screen.left, &screen.top, &screen.width, &screen.height);
  }
  std::erase_if(screens, [](const WindowRect& screen) { return screen.width <= 0 || screen.height <= 0; });
  return screens;
}

double WindowContext::contentScale() const {
  float x = 1, y = 1;
  glfwGetWindowContentScale(impl_->window, &x, &y);
  return std::max(static_cast<double>(std::max(x, y)), 1.0);
}

void WindowContext::waitEvents(double seconds) { glfwWaitEventsTimeout(seconds); }

std::vector<WindowEvent> WindowContext::pollEvents() {
  glfwPollEvents();
  const double now = glfwGetTime();
  for (WindowEvent& event : impl_->events) {
    event.earliestSeconds = impl_->polled;
    event.latestSeconds = now;
  }
  impl_->polled = now;
  return std::exchange(impl_->events, {});
}

Context::Procedure WindowContext::procAddress(const char* name) { return glfwGetProcAddress(name); }

bool WindowContext::bindToThread() {
  glfwMakeContextCurrent(impl_->window);
  return glfwGetCurrentContext() == impl_->window;
}

void WindowContext::releaseFromThread() { glfwMakeContextCurrent(nullptr); }

}  // namespace skydrop::render::gl
