// Marks where depth steps, 32 x 16 pixels an invocation.
#include "shared/edge_steps.glsl"
#include "edges/words.glsl"
#include "edges/words_written.glsl"

layout(binding = 0) uniform sampler2D sceneDepth;  // clamped to its edge
uniform float leastStep;  // share of the depth

const int kRows = 16;
const int kBelow = 2;         // rows that are read below a block, and above
const int kRead = kRows + 4;  // of a column

// Depths of two columns at once, four texels a look: a software renderer works the coordinates out once for them.
void readColumns(ivec2 low, vec2 perTexel, out float first[kRead], out float second[kRead]) {
  for (int i = 0; i < kRead; i += 2) {
    vec4 four = textureGather(sceneDepth, (vec2(low) + vec2(1.0, float(i - kBelow) + 1.0)) * perTexel);
    first[i] = four.w;
    first[i + 1] = four.x;
    second[i] = four.z;
    second[i + 1] = four.y;
  }
}

// Steps upward in one column: of each row's pixel to the next.
void markUpward(float column[kRead], uint bit, inout uint upward[kRows]) {
  float step = column[kBelow + 1] - column[kBelow];
  float bend = step - (column[kBelow] - column[kBelow - 1]);
  for (int i = 0; i < kRows; ++i) {
    float here = column[kBelow + i], upper = column[kBelow + i + 1];
    float nextStep = column[kBelow + i + 2] - upper;
    float nextBend = step - nextStep;
    if (isStepBetween(step, leastStep * max(here, upper), bend, nextBend)) upward[i] |= bit;
    step = nextStep;
    bend = nextBend;
  }
}

// Steps from one column to the next; step and bend are those to the first, and become those to the second.
void markRightward(float here[kRead], float next[kRead], float after[kRead], uint bit, inout float step[kRows],
                   inout float bend[kRows], inout uint rightward[kRows]) {
  for (int i = 0; i < kRows; ++i) {
    float nextStep = after[kBelow + i] - next[kBelow + i];
    float nextBend = step[i] - nextStep;
    if (isStepBetween(step[i], leastStep * max(here[kBelow + i], next[kBelow + i]), bend[i], nextBend)) rightward[i] |= bit;
    step[i] = nextStep;
    bend[i] = nextBend;
  }
}

void markBlock(ivec2 block) {
  ivec2 low = block * ivec2(32, kRows);
  ivec2 size = textureSize(sceneDepth, 0);
  vec2 perTexel = 1.0 / vec2(size);
  uint upward[kRows], rightward[kRows];
  float here[kRead], next[kRead], after[kRead], later[kRead], step[kRows], bend[kRows];
  readColumns(low - ivec2(2, 0), perTexel, after, later);
  readColumns(low, perTexel, here, next);
  for (int i = 0; i < kRows; ++i) {
    upward[i] = 0u;
    rightward[i] = 0u;
    step[i] = next[kBelow + i] - here[kBelow + i];
    bend[i] = step[i] - (here[kBelow + i] - later[kBelow + i]);
  }
  for (int x = 0; x < 32; x += 2) {
    uint bit = 1u << uint(x);
    readColumns(low + ivec2(x + 2, 0), perTexel, after, later);
    markUpward(here, bit, upward);
    markUpward(next, bit << 1u, upward);
    markRightward(here, next, after, bit, step, bend, rightward);
    markRightward(next, after, later, bit << 1u, step, bend, rightward);
    here = after;
    next = later;
  }
  int inside = clamp(size.x - low.x, 0, 32);
  uint mask = inside == 32 ? 0xffffffffu : (1u << uint(inside)) - 1u;
  for (int i = 0; i < kRows; ++i) {
    ivec2 pixel = low + ivec2(0, i);
    uint kept = pixel.y < size.y ? mask : 0u;
    writeWord(wordOfRow(pixel), upward[i] & kept);
    writeWord(rightwardWords() + wordOfRow(pixel), rightward[i] & kept);
  }
}
