// The shares, [0, 1/2], that the four sides of each pixel have of it, a byte each; 0 but for listed pixels.
layout(binding = 1, r32ui) uniform uimage2D shares;

const int kUp = 0, kDown = 1, kRight = 2, kLeft = 3;

uint packedShare(float share, int side) { return uint(share * 510.0 + 0.5) << uint(8 * side); }

vec4 unpackedShares(uint packedShares) {
  return vec4(packedShares & 255u, packedShares >> 8u & 255u, packedShares >> 16u & 255u, packedShares >> 24u) / 510.0;
}
