#include "app/window/screen_fit.h"

#include <algorithm>
#include <cstdint>

namespace skydrop::app {
namespace {

using render::gl::WindowFrame;
using render::gl::WindowRect;

std::int64_t sharedLength(std::int64_t a, std::int64_t aLength, std::int64_t b, std::int64_t bLength) {
  return std::max<std::int64_t>(std::min(a + aLength, b + bLength) - std::max(a, b), 0);
}

std::int64_t sharedArea(const WindowRect& a, const WindowRect& b) {
  return sharedLength(a.left, a.width, b.left, b.width) * sharedLength(a.top, a.height, b.top, b.height);
}

}  // namespace

WindowRect heldToScreen(const WindowRect& wanted, const WindowFrame& frame,
                        std::span<const WindowRect> screens) {
  if (screens.empty()) return wanted;
  const WindowRect& screen = *std::ranges::max_element(
      screens, {}, [&](const WindowRect& candidate) { return sharedArea(candidate, wanted); });
  WindowRect held;
  held.width = std::max(std::min(wanted.width, screen.width - frame.left - frame.right), 1);
  held.height = std::max(std::min(wanted.height, screen.height - frame.top - frame.bottom), 1);
  const auto place = [](int at, int length, int low, int high) {
    return std::max(std::min(at, high - length), low);
  };
  held.left =
      place(wanted.left, held.width, screen.left + frame.left, screen.left + screen.width - frame.right);
  held.top =
      place(wanted.top, held.height, screen.top + frame.top, screen.top + screen.height - frame.bottom);
  return held;
}

}  // namespace skydrop::app
