#include "skydrop/clouds/noise_cache.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <optional>
#include <string>
#include <system_error>

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/hash.h"

namespace skydrop::clouds {
namespace {

constexpr std::size_t kMostBytes = std::size_t{16} << 20;  // the shape is 8 MiB

// A file is this header, then the texture as DDS.
struct CacheHeader {
  char magic[8] = {'S', 'K', 'Y', 'N', 'O', 'I', 'S', 'E'};
  std::uint64_t definition = kNoiseDefinition;
  std::uint64_t digest = 0;
};

bool isSizedFor(const core::TextureData& texture, NoiseTexture kind) {
  const core::TextureData right = emptyNoise(kind);
  return texture.format == right.format && texture.width == right.width && texture.height == right.height &&
         texture.depth == right.depth;
}

std::optional<core::TextureData> decoded(std::span<const std::byte> bytes, const std::string& name,
                                         NoiseTexture kind) {
  CacheHeader header;
  const CacheHeader expected;
  if (bytes.size() < sizeof header) return std::nullopt;
  std::memcpy(&header, bytes.data(), sizeof header);
  if (std::memcmp(header.magic, expected.magic, sizeof header.magic) != 0) return std::nullopt;
  if (header.definition != expected.definition) return std::nullopt;
  core::TextureData texture = core::decodeDds(bytes.subspan(sizeof header), name);
  if (!isSizedFor(texture, kind) || noiseDigest(texture) != header.digest) return std::nullopt;
  return texture;
}

}  // namespace

std::uint64_t noiseDigest(const core::TextureData& texture) {
  std::uint64_t digest = kNoiseDefinition;
  for (std::size_t at = 0; at < texture.texels.size(); at += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, texture.texels.data() + at, std::min<std::size_t>(8, texture.texels.size() - at));
    digest = core::hashCombine(digest, word);
  }
  return digest;
}

std::filesystem::path noiseCacheFile(const std::filesystem::path& folder, NoiseTexture texture,
                                     std::uint32_t seed) {
  return folder / (std::string(noiseLayout(texture).name) + "-" + std::to_string(kNoiseDefinition) + "-" +
                   std::to_string(seed) + ".noise");
}

CachedNoise loadNoise(const std::filesystem::path& folder, NoiseTexture texture, std::uint32_t seed) {
  const std::filesystem::path file = noiseCacheFile(folder, texture, seed);
  std::error_code unreadable;
  if (!std::filesystem::exists(file, unreadable)) return {};
  try {
    auto stored = decoded(core::readFile(file, kMostBytes), file.string(), texture);
    if (stored) return {CacheState::good, std::move(*stored)};
  } catch (const core::DataError&) {
    // Unreadable or not a DDS file: damaged like any other.
  }
  return {CacheState::damaged, {}};
}

void saveNoise(const std::filesystem::path& folder, NoiseTexture texture, std::uint32_t seed,
               const core::TextureData& made) {
  assert(isSizedFor(made, texture));
  core::makeFolder(folder);
  CacheHeader header;
  header.digest = noiseDigest(made);
  const std::vector<std::byte> dds = core::encodeDds(made, core::DdsHeader::dx10);
  std::vector<std::byte> bytes(sizeof header + dds.size());
  std::memcpy(bytes.data(), &header, sizeof header);
  std::memcpy(bytes.data() + sizeof header, dds.data(), dds.size());
  core::writeFileAtomically(noiseCacheFile(folder, texture, seed), bytes);
}

}  // namespace skydrop::clouds
