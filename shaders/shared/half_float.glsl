// Values that the half-float targets of a frame keep (their largest is 65504).
#ifndef __cplusplus
#include "shared/dialect.glsl"
#endif

// The largest radiance that is written, times exposure: blending may add to it before it becomes infinite.
CONST Real kBrightest = Real(60000.0);

// Stands for a distance beyond everything, in metres; distances are cut off there.
CONST Real kFarDistance = Real(65000.0);
