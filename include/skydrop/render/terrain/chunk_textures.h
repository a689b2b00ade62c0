// Chunks of land on the GPU: a fixed pool of texture-array layers, one a layer, terrain::kSampleBytes each.
#pragma once

#include "skydrop/render/gl/texture.h"
#include "skydrop/terrain/terrain_frame.h"

namespace skydrop::render {

// Which chunk lies in which layer is EndlessTerrain's business (its uploads keep to a budget); this holds the
// texels and the table by which shaders find the chunk at a place.
class ChunkTextures {
 public:
  // Chunks of each level that a view can want lie within 32 x 32 of each other (lod.cpp,
  // kLargestSplitChunks): the table wraps them around.
  static constexpr int kTableSide = core::shared::f64::kChunkTableSide;

  ChunkTextures() = default;  // no layers; may be assigned to and asked for layers(), nothing else
  // Allocates all layers at once: 1 to 65534 (asserted).
  ChunkTextures(gl::Context& context, int layers);

  int layers() const { return layers_; }

  // Writes heights and normals of a chunk into its layer, below layers() (asserted). The data is not needed
  // afterwards.
  void upload(const terrain::ChunkUpload& upload);
  // Makes these the chunks that shaders find, and no others.
  void setResident(std::span<const terrain::ResidentChunk> chunks);

  // R16UI height codes (241 x 241 a layer), RG8 normals (256 x 256: chunk_data.h), R16UI table (32 x 32 a
  // level, one above the other).
  void bind(GLuint heightsUnit, GLuint normalsUnit, GLuint tableUnit) const;

 private:
  int layers_ = 0;
  gl::Texture heights_, normals_, table_;
  std::vector<std::uint16_t> entries_;
};

}  // namespace skydrop::render
