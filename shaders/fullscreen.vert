// One triangle over the whole target, drawn without a vertex buffer: at infinity (reversed depth 0), where nobody sets a
// depth.
uniform float triangleDepth;
out vec2 ndc;

void main() {
  ndc = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(ndc, triangleDepth, 1.0);
}
