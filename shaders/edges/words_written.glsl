layout(binding = 0, r32ui) uniform writeonly uimage2D wordsWritten;

void writeWord(int index, uint word) { imageStore(wordsWritten, texelOfWord(index), uvec4(word)); }
