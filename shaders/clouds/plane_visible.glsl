// What of a cloud plane's light reaches the eye past surfaces and volumetric clouds.
#include "cloud_transmittance.glsl"
#include "shared/depth.glsl"

layout(binding = 1) uniform sampler2D sceneDepth;

const float kSoftEdgeM = 90.0;  // so far before a surface that pierces it a sheet thins out

// All of it before a surface beyond the plane, none of it behind one.
float unhidden() {
  float surfaceZ = viewZOfDepth(texelFetch(sceneDepth, ivec2(gl_FragCoord.xy), 0).r, frame.eye.y);
  return clamp((surfaceZ - viewZOfDepth(gl_FragCoord.z, frame.eye.y)) / kSoftEdgeM, 0.0, 1.0);
}

vec4 visibleLight(vec4 light, vec3 relative) { return light * (unhidden() * throughClouds(length(relative))); }
