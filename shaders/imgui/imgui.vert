layout(location = 0) in vec2 position;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 tint;
uniform vec4 pixelsToNdc;  // scale, offset
uniform float brightness;
out vec2 fragmentUv;
out vec4 fragmentTint;

void main() {
  fragmentUv = uv;
  fragmentTint = vec4(tint.rgb * brightness, tint.a);
  gl_Position = vec4(position * pixelsToNdc.xy + pixelsToNdc.zw, 0.0, 1.0);
}
