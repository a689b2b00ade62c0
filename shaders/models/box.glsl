// The corner that the vertex of a strip around a box stands on: a bit for each vertex and axis says low or high.
vec3 boxCorner(int vertex, vec3 low, vec3 high) {
  ivec3 bits = (ivec3(0x287a, 0x02af, 0x31e3) >> vertex) & 1;
  return mix(low, high, vec3(bits));
}
