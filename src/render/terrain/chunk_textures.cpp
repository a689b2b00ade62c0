#include "skydrop/render/terrain/chunk_textures.h"

#include <cassert>

namespace skydrop::render {
namespace {

constexpr std::uint16_t kNoChunk = 0xffff;
constexpr int kLevels = terrain::kMaxChunkLevel + 1;

}  // namespace

ChunkTextures::ChunkTextures(gl::Context& context, int layers)
    : layers_(layers),
      heights_(gl::Texture::make2DArray(context, GL_R16UI, terrain::kChunkSamples, terrain::kChunkSamples,
                                        layers, "chunk heights")),
      normals_(gl::Texture::make2DArray(context, GL_RG8, terrain::kNormalSide, terrain::kNormalSide, layers,
                                        "chunk normals")),
      table_(gl::Texture::make2D(context, GL_R16UI, kTableSide, kTableSide * kLevels, "chunk table")) {
  assert(layers > 0 && layers < kNoChunk);
}

void ChunkTextures::upload(const terrain::ChunkUpload& upload) {
  assert(upload.layer >= 0 && upload.layer < layers_);
  heights_.uploadLayer(upload.layer, GL_RED_INTEGER, GL_UNSIGNED_SHORT,
                       std::as_bytes(std::span(upload.data->heights)));
  normals_.uploadLayer(upload.layer, GL_RG, GL_UNSIGNED_BYTE, std::as_bytes(std::span(upload.data->normals)));
}

void ChunkTextures::setResident(std::span<const terrain::ResidentChunk> chunks) {
  std::vector<std::uint16_t> entries(static_cast<std::size_t>(kTableSide * kTableSide * kLevels), kNoChunk);
  for (const terrain::ResidentChunk& chunk : chunks) {
    const auto column = static_cast<int>(chunk.key.x & (kTableSide - 1));
    const auto row = static_cast<int>(chunk.key.z & (kTableSide - 1)) + chunk.key.level * kTableSide;
    entries[static_cast<std::size_t>(row * kTableSide + column)] = static_cast<std::uint16_t>(chunk.layer);
  }
  if (entries == entries_) return;
  entries_ = std::move(entries);
  table_.upload(GL_RED_INTEGER, GL_UNSIGNED_SHORT, std::as_bytes(std::span(entries_)));
}

void ChunkTextures::bind(GLuint heightsUnit, GLuint normalsUnit, GLuint tableUnit) const {
  heights_.bind(heightsUnit);
  normals_.bind(normalsUnit);
  table_.bind(tableUnit);
}

}  // namespace skydrop::render
