// Whether something that falls is seen: not behind the scene, and not inside the aircraft's cabin (CABIN).
layout(binding = 0) uniform sampler2D sceneDepth;

#ifdef CABIN
uniform mat4 toCabin;  // a place relative to the eye to a cube of -1 to 1

float outsideCabin(float depth) {
  vec2 ndc = gl_FragCoord.xy * frame.viewport.zw * 2.0 - 1.0;
  vec3 place = (frame.ndcToRay * vec4(ndc, 1.0, 0.0)).xyz * viewZOfDepth(depth, frame.eye.y);
  vec3 inCube = abs((toCabin * vec4(place, 1.0)).xyz);
  return max(max(inCube.x, inCube.y), inCube.z) < 1.0 ? 0.0 : 1.0;
}
#else
float outsideCabin(float depth) { return 1.0; }
#endif

float shareSeen(float depth) {
  float scene = texelFetch(sceneDepth, ivec2(gl_FragCoord.xy), 0).r;
  return depth > scene ? outsideCabin(depth) : 0.0;
}
