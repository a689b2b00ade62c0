// How rain, snow and hail are drawn; what falls is the weather's. A value; any thread.
#pragma once

#include "skydrop/core/settings.h"

namespace skydrop::render {

struct PrecipitationSettings {
  double drops = 5000;        // around the eye, at most, [0, 12000]: each stands for those that are left out
  double rangeM = 20;         // how far away single ones are drawn, m, [4, 60]
  double shutterS = 0.033;    // how long a streak is exposed, s, [0.001, 0.1]
  double splashes = 600;      // on water near the eye, at most, [0, 4000]
  double veilColumns = 80;    // of the grid by which rain far away is worked out, whole, [8, 320]
  double veilSteps = 48;      // of a ray through it, whole, [4, 384]
  double veilRangeM = 40000;  // how far rain is seen, m, [2000, 60000]
  bool wetGround = true;      // land is darker in rain, white in snow

  bool operator==(const PrecipitationSettings&) const = default;
};

void describe(core::SettingsVisitor& visitor, PrecipitationSettings& settings);

}  // namespace skydrop::render
