// Marks where depth steps, 32 x 16 pixels an invocation.
#include "shared/edge_steps.glsl"
#include "edges/words.glsl"
#include "edges/words_written.glsl"

layout(binding = 0) uniform sampler2D sceneDepth;
uniform float leastStep;  // share of the depth

const int kRows = 16;

float depthAt(ivec2 pixel) {
  return texelFetch(sceneDepth, clamp(pixel, ivec2(0), textureSize(sceneDepth, 0) - 1), 0).r;
}

// Steps upward in one column: of each row's pixel to the next.
void markColumn(float here[kRows], ivec2 pixel, uint bit, inout uint upward[kRows]) {
  float above = depthAt(pixel + ivec2(0, kRows)), second = depthAt(pixel + ivec2(0, kRows + 1));
  float step = here[1] - here[0];
  float bend = step - (here[0] - depthAt(pixel - ivec2(0, 1)));
  for (int i = 0; i < kRows; ++i) {
    float upper = i + 1 < kRows ? here[min(i + 1, kRows - 1)] : above;
    float beyond = i + 2 < kRows ? here[min(i + 2, kRows - 1)] : i + 2 == kRows ? above : second;
    float nextStep = beyond - upper;
    float nextBend = step - nextStep;
    if (isStepBetween(step, leastStep * max(here[i], upper), bend, nextBend)) upward[i] |= bit;
    step = nextStep;
    bend = nextBend;
  }
}

void markBlock(ivec2 block) {
  ivec2 low = block * ivec2(32, kRows);
  ivec2 size = textureSize(sceneDepth, 0);
  uint upward[kRows], rightward[kRows];
  float here[kRows], next[kRows], step[kRows], bend[kRows];
  for (int i = 0; i < kRows; ++i) {
    upward[i] = 0u;
    rightward[i] = 0u;
    here[i] = depthAt(low + ivec2(0, i));
    next[i] = depthAt(low + ivec2(1, i));
    step[i] = next[i] - here[i];
    bend[i] = step[i] - (here[i] - depthAt(low + ivec2(-1, i)));
  }
  for (int x = 0; x < 32; ++x) {
    ivec2 pixel = low + ivec2(x, 0);
    uint bit = 1u << uint(x);
    markColumn(here, pixel, bit, upward);
    for (int i = 0; i < kRows; ++i) {
      float after = depthAt(pixel + ivec2(2, i));
      float nextStep = after - next[i];
      float nextBend = step[i] - nextStep;
      if (isStepBetween(step[i], leastStep * max(here[i], next[i]), bend[i], nextBend)) rightward[i] |= bit;
      here[i] = next[i];
      next[i] = after;
      step[i] = nextStep;
      bend[i] = nextBend;
    }
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
