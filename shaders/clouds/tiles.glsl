// Lists of what is to be marched: tiles of 8 x 8 rays with the interval in which there may be cloud; and edges, single
// pixels of such tiles.
#include "shared/dialect.glsl"

struct Task {
  uint at;      // the tile's x and y in 16 bits each
  float begin;  // m from the eye
  float end;
  uint unused;
};

// An edge: its tile's place in the list, and the pixel in the tile (at most 32 x 32) in the lowest 10 bits.
uint packedEdge(uint tile, ivec2 pixelInTile) { return tile << 10u | uint(pixelInTile.y) << 5u | uint(pixelInTile.x); }
uint tileOfEdge(uint edge) { return edge >> 10u; }
ivec2 pixelOfEdge(uint edge) { return ivec2(edge & 31u, edge >> 5u & 31u); }

// Groups of an indirect dispatch: rows of 1024.
const uint kGroupsARow = 1024u;
const int kTileSide = 8;

ivec2 taskPlace(Task task) { return ivec2(task.at & 0xffffu, task.at >> 16u); }
uint packedPlace(ivec2 at) { return uint(at.x) | uint(at.y) << 16u; }

// The ray of an invocation of a tile: neighbours in blocks of 4 x 2, which a software renderer runs together.
ivec2 placeInTile(uint invocation) {
  return ivec2((invocation & 3u) | (invocation >> 1u & 4u), (invocation >> 2u & 1u) | (invocation >> 3u & 6u));
}
