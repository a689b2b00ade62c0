layout(binding = 0) uniform sampler2D atlas;
in vec2 fragmentUv;
in vec4 fragmentTint;
out vec4 color;

void main() { color = fragmentTint * texture(atlas, fragmentUv); }
