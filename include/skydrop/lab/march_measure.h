// How far the laboratory's ways to march end from the closed form, and what they cost: over the rays of a
// small picture.
#pragma once

#include "skydrop/lab/knobs.h"
#include "skydrop/lab/shared.h"

namespace skydrop::lab {

struct MarchError {
  double stepsPerRay = 0;   // of all rays: questions to the scene
  double meanError = 0;     // of rays that hit as they should, along the ray, units of the scene
  double largestError = 0;  // of the same
  double wrongShare = 0;    // of rays that miss what is there or hit what is not, [0, 1]
};

// `method`: core::shared::f64::kConstantStep and its neighbours. In double, and in float against the closed
// form in double.
MarchError marchError(const MarchKnobs& knobs, int method);
MarchError marchErrorInFloat(const MarchKnobs& knobs, int method);

}  // namespace skydrop::lab
