// The numbers of the chunks and patches of land that both the CPU and the shaders need;
// include/skydrop/terrain/chunk_key.h, chunk_data.h and lod.h describe what they mean and publish them to C++.
#ifndef __cplusplus
#include "shared/dialect.glsl"
#endif

CONST int kChunkCells = 240;      // along a side of a chunk, at every level; one sample more
CONST Real kCellMetres = Real(4.0);  // distance of the samples at level 0; doubles with each level
CONST Real kChunkMetres = kCellMetres * Real(kChunkCells);  // side of a chunk of level 0
CONST int kMaxChunkLevel = 6;     // the coarsest
CONST int kPatchCells = 15;       // along a side of a patch
CONST int kTopPatchLevel = kMaxChunkLevel + 4;  // patches take every 16th sample at most
CONST int kNormalSide = 256;      // of the square in which the normals of a chunk are stored
CONST int kNormalMargin = 8;      // rows and columns in it before the first sample
CONST Real kNormalReachM = Real(24.0);  // how far normals continue beyond a chunk's border
CONST int kChunkTableSide = 32;   // of the table of resident chunks, in entries a level
