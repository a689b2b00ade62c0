// Takes away steps at whose nearer side a stage's layer lies (render::StageLayer), whose edges are smooth already: a word of
// pixels around its box an invocation.
#include "edges/words.glsl"

layout(binding = 0) uniform sampler2D sceneDepth;
layout(binding = 2) uniform sampler2DMS layerColor;
layout(binding = 0, r32ui) uniform uimage2D words;

uniform ivec2 layerLow, layerHigh;  // corners of its box, pixels

bool isOfLayer(ivec2 pixel) {
  if (any(lessThan(pixel, layerLow)) || any(greaterThanEqual(pixel, layerHigh))) return false;
  float cover = 0.0;
  for (int i = 0; i < 4; ++i) cover += texelFetch(layerColor, pixel - layerLow, i).a;
  return cover > 0.0;
}

void clearWord(int index, ivec2 pixel, ivec2 toNext) {
  uint marks = imageLoad(words, texelOfWord(index)).x, kept = marks;
  for (uint left = marks; left != 0u; left &= left - 1u) {
    ivec2 at = pixel + ivec2(findLSB(left), 0);
    float here = texelFetch(sceneDepth, at, 0).r, next = texelFetch(sceneDepth, at + toNext, 0).r;
    if (isOfLayer(here > next ? at : at + toNext)) kept &= ~(left & -left);
  }
  imageStore(words, texelOfWord(index), uvec4(kept));
}

// The first words are those of the pixels below and to the left of the box: steps are of the pixel before them.
void clearLayer(ivec2 at) {
  ivec2 first = max(layerLow - 1, ivec2(0));
  ivec2 pixel = ivec2(((first.x >> 5) + at.x) << 5, first.y + at.y);
  if (pixel.x >= layerHigh.x || pixel.y >= layerHigh.y) return;
  clearWord(wordOfRow(pixel), pixel, ivec2(0, 1));
  clearWord(rightwardWords() + wordOfRow(pixel), pixel, ivec2(1, 0));
}
