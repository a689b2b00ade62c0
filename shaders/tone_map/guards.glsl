// Compiled in with GUARD_MARKS alone: a frame that shows no guards has nothing of this.
#ifdef GUARD_MARKS
#include "shared/guard_marks.glsl"

vec3 withGuardMarks(vec3 encoded, vec3 light) { return guardMarked(encoded, guardOfLight(light)); }
#else
vec3 withGuardMarks(vec3 encoded, vec3 light) { return encoded; }
#endif
