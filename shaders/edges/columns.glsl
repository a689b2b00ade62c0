// Lists the words that hold steps and lays the steps to the right out by columns, a tile of 32 x 32 pixels a group and a row,
// then a column of it an invocation.
#include "edges/words_read.glsl"
#include "edges/words_written.glsl"
#include "edges/lists.glsl"

shared uint rowsOfTile[32];

uint columnOfTile(uint column) {
  uint bits = 0u;
  for (int i = 0; i < 32; ++i) bits |= (rowsOfTile[i] >> column & 1u) << uint(i);
  return bits;
}

void turnTile(ivec2 tile, uint invocation) {
  ivec2 pixel = tile * 32 + ivec2(0, int(invocation));
  uint rightward = wordAt(rightwardWords() + wordOfRow(pixel));
  if (wordAt(wordOfRow(pixel)) != 0u) listWord(pixel, 0u);
  if (rightward != 0u) listWord(pixel, kIsRightward);
  rowsOfTile[invocation] = rightward;
  barrier();
  writeWord(columnWords() + wordOfColumn(tile * 32 + ivec2(int(invocation), 0)), columnOfTile(invocation));
}
