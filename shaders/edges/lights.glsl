// The light of the listed pixels, four halves each, until all of it has been worked out.
layout(std430, binding = 2) buffer Lights { uvec2 lights[]; };

void keepLight(uint index, vec4 light) { lights[index] = uvec2(packHalf2x16(light.rg), packHalf2x16(light.ba)); }
vec4 keptLight(uint index) { return vec4(unpackHalf2x16(lights[index].x), unpackHalf2x16(lights[index].y)); }
