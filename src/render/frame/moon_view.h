// The moon as it is drawn: where it appears, how it lies and how it is lit.
#pragma once

#include <glm/vec3.hpp>

#include "skydrop/render/frame/render_settings.h"

namespace skydrop::render {

struct MoonView {
  glm::dvec3 direction{0, 1, 0};  // unit, world: as it appears, raised by refraction
  glm::dvec3 north{0, 0, -1};     // unit, across it: towards its north pole, within 2 degrees
  glm::dvec3 toSun{0, 1, 0};      // unit, from the moon
  double radiusRad = 0;
  double distanceKm = 0;
  double phaseAngleDegrees = 0;  // between the directions to sun and eye, from the moon: 0 full, 180 new
};

MoonView moonView(const SunSettings& clock, double simulatedSeconds);

// moonView() of a frame, worked out when somebody asks for it and kept for all others. A renderer has one
// (FrameInput::moon). Main thread.
class MoonOfFrame {
 public:
  // Valid until the next call.
  const MoonView& at(const SunSettings& clock, double simulatedSeconds);
  // How often it was worked out.
  int made() const { return made_; }

 private:
  SunSettings clock_;
  double seconds_ = 0;
  MoonView view_;
  int made_ = 0;
};

// Of a frame that may have none.
MoonView moonOf(MoonOfFrame* frame, const SunSettings& clock, double simulatedSeconds);

}  // namespace skydrop::render
