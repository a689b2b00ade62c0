flat in vec3 relative;
out vec4 color;
void main() { color = vec4(relative, 1.0); }
