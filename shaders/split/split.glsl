// What a divided picture shows: one picture left of the divider, another right of it, and the divider as a bright line
// with dark rims, which can be told from snow and from forest.
layout(binding = 0) uniform sampler2D leftPicture;
layout(binding = 1) uniform sampler2D rightPicture;
uniform float dividerX;  // pixels from the left, of its middle

const float kLineHalfWidth = 1.0, kRimHalfWidth = 2.0;  // pixels

// Encoded colour of a pixel, counted from the lower left corner. Both pictures have the target's size.
vec3 splitPicture(ivec2 pixel) {
  float right = float(pixel.x) + 0.5 - dividerX;
  vec3 picture = right < 0.0 ? texelFetch(leftPicture, pixel, 0).rgb : texelFetch(rightPicture, pixel, 0).rgb;
  vec3 line = abs(right) < kLineHalfWidth ? vec3(1.0) : vec3(0.0);
  return abs(right) < kRimHalfWidth ? line : picture;
}
