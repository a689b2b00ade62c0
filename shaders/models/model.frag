#include "frame.glsl"
#include "sky/sky.glsl"
#include "models/material.glsl"
#include "models/light.glsl"

in vec3 relative;
in vec3 surfaceNormal;
in vec2 surfaceUv;
out vec4 color;

void main() { color = vec4(modelLight(materialAt(surfaceUv), normalize(surfaceNormal), relative), 1.0); }
