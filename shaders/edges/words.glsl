// Steps of depth as bits of words, so that a run is measured by counting bits (render::EdgeSmoothingPass). Three parts:
// steps from a pixel to the one above it, 32 pixels of a row a word; steps to the one at its right, laid out the same;
// and the second again with 32 pixels of a column a word. Rows are padded to whole tiles of 32 x 32. A texture, 1024 words
// a row: a software renderer reads it faster than a buffer.
uniform ivec2 tiles;  // of 32 x 32 pixels

int wordOfRow(ivec2 pixel) { return pixel.y * tiles.x + (pixel.x >> 5); }
int wordOfColumn(ivec2 pixel) { return pixel.x * tiles.y + (pixel.y >> 5); }
int rightwardWords() { return tiles.y * 32 * tiles.x; }
int columnWords() { return 2 * rightwardWords(); }

ivec2 texelOfWord(int index) { return ivec2(index & 1023, index >> 10); }
