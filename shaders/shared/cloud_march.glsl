// Bounds of the marches through clouds (shaders/clouds/exact_march.glsl, march.glsl); from those of the first C++ works
// out whether one dispatch is enough.
#ifndef __cplusplus
#include "shared/dialect.glsl"
#endif

// Steps that share one place where light is worked out, at most.
CONST int kMaxStepsPerSegment = 4;

// All loops of a ray together run at most about so many times in one dispatch: longer ones are cut short by some
// drivers.
CONST int kMostIterations = 22000;

// Of the march of the tiers to play with: samples of a turn of its loops; segments that a ray's light is worked out for at
// most, and how many of them may be as thin as lightOpacity says.
CONST int kSamplesATurn = 2;
CONST int kSunSamplesATurn = 2;
CONST int kMostSegments = 32;
CONST int kThinSegments = 24;
