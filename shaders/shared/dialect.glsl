// The GLSL side of the words that the shared files are written in; include/skydrop/core/shared.h has the C++
// side. A shared file is compiled three times: as GLSL, as C++ in float and as C++ in double. So: literals are
// Real(0.5), no swizzles, no array constructors, no int mixed into Real expressions, no uniforms, no gl_ names,
// make_x() instead of struct constructors, and none of the names near, far, min, max, sample, filter, input, output.
#define Real float
#define Vec2 vec2
#define Vec3 vec3
#define Vec4 vec4
#define Uint uint
#define Uvec2 uvec2
#define Uvec3 uvec3
#define FN
#define CONST const
#define OUT(T) out T
