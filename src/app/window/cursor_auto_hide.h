// Hides the mouse pointer while it rests in the picture: a pilot looks at the land, not at an arrow.
#pragma once

namespace skydrop::app {

// Long enough to reach for the mouse and click.
inline constexpr double kCursorIdleSeconds = 2;

class CursorAutoHide {
 public:
  // Once a frame: `seconds` since the last; whether the pointer moved, and whether something that is clicked
  // (menu) is open. True: it is shown.
  bool isShown(double seconds, bool moved, bool needed) {
    rested_ = moved || needed ? 0 : rested_ + seconds;
    return rested_ < kCursorIdleSeconds;
  }

 private:
  double rested_ = 0;
};

}  // namespace skydrop::app
