// What clouds leave of the sun at a place (include/skydrop/render/cloud_shade.h). After frame.glsl and
// shared/cloud_light.glsl.
layout(binding = 10) uniform sampler3D fineShade;    // one layer: optical depth of the clouds along a sun ray
layout(binding = 11) uniform sampler3D coarseShade;
uniform vec4 inFineShade[2];    // rows: a place relative to the eye, and 1, to the texture
uniform vec4 inCoarseShade[2];
uniform vec2 shadeLayer;        // base above the eye (m), 1 / thickness

vec2 placeInShade(vec4 rows[2], vec3 relative) {
  return vec2(dot(rows[0], vec4(relative, 1.0)), dot(rows[1], vec4(relative, 1.0)));
}

// 1 inside a map, 0 at its edge and beyond.
float insideShade(vec2 place) {
  float toEdge = 0.5 - max(abs(place.x - 0.5), abs(place.y - 0.5));
  return smoothstep(0.0, 0.06, toEdge);
}

float cloudShade(vec3 relative) {
  vec2 fine = placeInShade(inFineShade, relative);
  vec2 coarse = placeInShade(inCoarseShade, relative);
  float depth = mix(texture(coarseShade, vec3(coarse, 0.5)).x, texture(fineShade, vec3(fine, 0.5)).x, insideShade(fine));
  // Within the layer the clouds below a place do not shade it: taken as even from base to top.
  float above = 1.0 - saturate((relative.y - shadeLayer.x) * shadeLayer.y);
  return mix(1.0, sunBelowCloud(depth * above), insideShade(coarse));
}
