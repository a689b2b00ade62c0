// The depth of what is solid, for passes that draw over the scene's colour alone.
layout(binding = 8) uniform sampler2D sceneDepth;

// Depth is reversed: nearer is larger.
void discardIfHidden() {
  if (texelFetch(sceneDepth, ivec2(gl_FragCoord.xy), 0).r > gl_FragCoord.z) discard;
}
