// Bounds of the march through clouds (shaders/clouds/march.glsl), from which C++ works out whether one dispatch is
// enough.
#ifndef __cplusplus
#include "shared/dialect.glsl"
#endif

// Steps that share one place where light is worked out, at most.
CONST int kMaxStepsPerSegment = 4;

// All loops of a ray together run at most about so many times in one dispatch: longer ones are cut short by some
// drivers.
CONST int kMostIterations = 30000;
