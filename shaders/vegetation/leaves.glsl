// The look of foliage and bark at a place of a unit tree: clumps of leaves by noise in space.
#include "shared/lattice_noise.glsl"

const vec3 kBarkHue = vec3(2.3, 1.25, 2.6);  // of bark against leaves

const float kBakedLight = 0.62;  // scale of the share of light that the atlas keeps, so that bright leaves fit

struct Leaves {
  float shade;   // factor on the light
  vec3 slope;    // to be added to the normal
  float opaque;  // below 0 there is a gap
};

// kind: as in shared/woods.glsl; rim: how much the surface turns away from the eye, [0, 1].
Leaves leavesAt(vec3 unitPlace, float kind, float bark, float rim) {
  float cells = kind < 0.5 ? 7.0 : 6.0;
  vec4 noise = simplexNoise(uvec3(7u, 11u, uint(kind)), unitPlace * vec3(cells, cells * (kind < 0.5 ? 3.2 : 1.9), cells));
  vec4 fine = simplexNoise(uvec3(31u, 5u, uint(kind)), unitPlace * vec3(2.7 * cells, cells * (kind < 0.5 ? 8.0 : 5.0), 2.7 * cells));
  float both = 0.55 * noise.w + 0.65 * fine.w;
  Leaves leaves;
  leaves.shade = mix(1.0 + 0.55 * both, 1.0 + 0.3 * fine.w, bark);
  leaves.slope = (noise.xyz * 0.30 + fine.xyz * 0.16) * (1.0 - bark);
  leaves.opaque = mix(0.50 + 1.1 * both - 0.95 * rim, 1.0, bark);
  return leaves;
}
