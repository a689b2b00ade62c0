#include "edges/words.glsl"

layout(binding = 1) uniform usampler2D wordsRead;

uint wordAt(int index) { return texelFetch(wordsRead, texelOfWord(index), 0).x; }
uint wordAt(int index, bool isInside) { return isInside ? wordAt(isInside ? index : 0) : 0u; }
