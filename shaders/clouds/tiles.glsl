// Lists of what is to be marched: tiles of pixels with the interval in which there may be cloud, and single rays. TILE_SIDE:
// pixels.
#include "listed.glsl"
#include "shared/dialect.glsl"

struct Task {
  uint at;      // the tile's x and y in 16 bits each
  float begin;  // m from the eye
  float end;
  uint unused;
};

// Parts of a tile's interval, nearest first, with clear air between them: their number in the first place, then begin and
// end of each.
#ifdef LAYERS
const int kPlacesOfSpans = 16 * LAYERS;
#else
const int kPlacesOfSpans = 16;
#endif
const int kMostSpans = kPlacesOfSpans - 1;

// Set in a listed ray's place: it is filled well enough, should the last frame know nothing better.
const uint kMayBeLeft = 0x80000000u;
ivec2 taskPlace(Task task) { return unpackedPlace(task.at); }

// The place of an invocation in a square of `side` (a multiple of 4): neighbours in blocks of 4 x 2, which a software
// renderer runs together.
ivec2 placeInSquare(uint invocation, uint side) {
  uint block = invocation >> 3u;
  uint across = side >> 2u;
  return ivec2((block % across) << 2u | (invocation & 3u), (block / across) << 1u | (invocation >> 2u & 1u));
}
