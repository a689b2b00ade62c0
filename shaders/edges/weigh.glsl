// What the pixels at both sides of each step have of each other, a word of steps an invocation.
#include "shared/edge_steps.glsl"
#include "edges/words_read.glsl"
#include "edges/lists.glsl"
#include "edges/shares.glsl"

// Three words of a line of bits, with the one of the pixel in the middle. `at`: of the pixel in it.
struct Line {
  uint before, here, after;
  uint at;
};

Line lineThrough(ivec2 pixel, bool isRightward) {
  int first = isRightward ? columnWords() + wordOfColumn(pixel) : wordOfRow(pixel);
  int along = isRightward ? pixel.y : pixel.x, words = isRightward ? tiles.y : tiles.x;
  return Line(wordAt(first - 1, along >= 32), wordAt(first), wordAt(first + 1, (along >> 5) + 1 < words),
              uint(along & 31));
}

// Set bits in a row after and before the line's pixel: all up to 32, at most 63.
int onesAfter(Line line) {
  uint zeros = ~line.here >> line.at;
  int here = zeros == 0u ? 32 - int(line.at) : findLSB(zeros);
  int more = ~line.after == 0u ? 32 : findLSB(~line.after);
  return (zeros == 0u ? here + more : here) - 1;
}

int onesBefore(Line line) {
  uint zeros = ~line.here << (31u - line.at);
  int here = zeros == 0u ? int(line.at) + 1 : 31 - findMSB(zeros);
  int more = ~line.before == 0u ? 32 : 31 - findMSB(~line.before);
  return (zeros == 0u ? here + more : here) - 1;
}

// -1, 0 or 1: steps across the end of a run, at the second side less at the first.
float crossing(int words, ivec2 pixel, ivec2 toSecond) {
  bool isInside = all(greaterThanEqual(pixel, ivec2(0)));
  ivec2 first = max(pixel, ivec2(0)), second = min(first + toSecond, tiles * 32 - 1);
  uint atFirst = wordAt(words + wordOfRow(first)) >> uint(first.x & 31) & 1u;
  uint atSecond = wordAt(words + wordOfRow(second)) >> uint(second.x & 31) & 1u;
  return isInside ? float(int(atSecond) - int(atFirst)) : 0.0;
}

// stepShares() of a step.
vec2 sharesOfStep(ivec2 pixel, bool isRightward) {
  Line line = lineThrough(pixel, isRightward);
  int before = onesBefore(line), after = onesAfter(line);
  ivec2 along = isRightward ? ivec2(0, 1) : ivec2(1, 0), across = ivec2(1) - along;
  int words = isRightward ? 0 : rightwardWords();
  float begin = crossing(words, pixel - along * (before + 1), across);
  float end = crossing(words, pixel + along * after, across);
  return stepShares(float(before), float(before + after + 1), begin, end);
}

void addShare(ivec2 pixel, float share, int side) {
  uint bits = packedShare(share, side);
  if (bits == 0u) return;
  if (imageAtomicOr(shares, pixel, bits) == 0u) listPixel(pixel);
}

void weighSteps(ivec2 pixel, bool isRightward) {
  uint word = wordAt((isRightward ? rightwardWords() : 0) + wordOfRow(pixel));
  ivec2 across = isRightward ? ivec2(1, 0) : ivec2(0, 1);
  for (uint left = word; left != 0u; left &= left - 1u) {
    ivec2 first = pixel + ivec2(findLSB(left), 0);
    vec2 share = sharesOfStep(first, isRightward);
    addShare(first, share.x, isRightward ? kRight : kUp);
    addShare(first + across, share.y, isRightward ? kLeft : kDown);
  }
}

void weighListed(uint index) {
  if (index >= listedWords.groups.w) return;
  uint at = listedWords.at[index];
  weighSteps(unpackedPlace(at & ~kIsRightward) * ivec2(32, 1), (at & kIsRightward) != 0u);
}
