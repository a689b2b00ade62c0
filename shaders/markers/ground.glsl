// The place, relative to the eye, of what the scene shows at this pixel. After models/scene_depth.glsl.
vec3 placeBehindPixel() {
  vec2 ndc = gl_FragCoord.xy * frame.viewport.zw * 2.0 - 1.0;
  float depth = texelFetch(sceneDepth, ivec2(gl_FragCoord.xy), 0).r;
  return (frame.ndcToRay * vec4(ndc, 1.0, 0.0)).xyz * viewZOfDepth(depth, frame.eye.y);
}
