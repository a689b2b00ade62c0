#include "models/light.glsl"

// At an edge the middle of the pixel may lie beside the triangle.
centroid in vec3 relative;
centroid in vec3 surfaceNormal;
centroid in vec2 surfaceUv;
out vec4 color;

void main() { color = vec4(modelLight(materialAt(surfaceUv), normalize(surfaceNormal), relative), 1.0); }
