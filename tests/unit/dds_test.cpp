#include "skydrop/core/dds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "support/paths.h"
#include "support/refusal.h"

namespace skydrop::core {
namespace {

constexpr TexelFormat kFormats[] = {TexelFormat::r8,   TexelFormat::rg8,     TexelFormat::rgba8,
                                    TexelFormat::r32f, TexelFormat::rgba32f, TexelFormat::a8,
                                    TexelFormat::r16};

TextureData patterned(TexelFormat format, int width, int height, int depth) {
  TextureData texture(format, width, height, depth);
  for (std::size_t i = 0; i < texture.texels.size(); ++i)
    texture.texels[i] = static_cast<std::byte>(i * 37 + 11);
  return texture;
}

void put(std::vector<std::byte>& bytes, std::size_t word, std::uint32_t value) {
  for (std::size_t i = 0; i < 4; ++i) bytes[word * 4 + i] = static_cast<std::byte>(value >> (8 * i) & 0xff);
}

std::string refusal(std::span<const std::byte> bytes) {
  return test::refusalOf<DataError>([&] { decodeDds(bytes, "a.dds"); });
}

TEST(Dds, whatIsWrittenReadsBackInEveryFormatWithBothHeaders) {
  for (const TexelFormat format : kFormats) {
    for (const DdsHeader header : {DdsHeader::legacy, DdsHeader::dx10}) {
      for (const int depth : {0, 1, 3}) {
        const TextureData texture = patterned(format, 5, 4, depth);
        EXPECT_EQ(decodeDds(encodeDds(texture, header), "a.dds"), texture)
            << texelFormatName(format) << ", depth " << depth;
      }
    }
  }
}

TEST(Dds, alphaAndLuminanceHaveTheHeadersThatOthersRead) {
  // DDPF_ALPHA (D3DFMT_A8), DDPF_LUMINANCE of 8 and 16 bits (D3DFMT_L8, L16), and the DXGI formats A8_UNORM,
  // R8_UNORM and R16_UNORM; red masks of an alpha file mean nothing.
  const auto word = [](const std::vector<std::byte>& bytes, std::size_t index) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + index * 4, 4);
    return value;
  };
  struct Row {
    TexelFormat format;
    std::uint32_t flags, bits, redMask, alphaMask, dxgi;
  };
  for (const Row& row :
       {Row{TexelFormat::a8, 0x2, 8, 0, 0xff, 65}, Row{TexelFormat::r8, 0x20000, 8, 0xff, 0, 61},
        Row{TexelFormat::r16, 0x20000, 16, 0xffff, 0, 56}}) {
    const TextureData texture = patterned(row.format, 4, 2, 0);
    std::vector<std::byte> bytes = encodeDds(texture, DdsHeader::legacy);
    EXPECT_EQ(word(bytes, 20), row.flags);
    EXPECT_EQ(word(bytes, 22), row.bits);
    EXPECT_EQ(word(bytes, 23), row.redMask);
    EXPECT_EQ(word(bytes, 26), row.alphaMask);
    EXPECT_EQ(word(encodeDds(texture, DdsHeader::dx10), 32), row.dxgi);
  }
  std::vector<std::byte> bytes = encodeDds(patterned(TexelFormat::a8, 4, 2, 0), DdsHeader::legacy);
  put(bytes, 23, 0xff0000);
  EXPECT_EQ(decodeDds(bytes, "a.dds").format, TexelFormat::a8);
}

TEST(Dds, legacyBlueFirstIsReadAsRedFirst) {
  std::vector<std::byte> bytes = encodeDds(patterned(TexelFormat::rgba8, 2, 1, 0), DdsHeader::legacy);
  const TextureData straight = decodeDds(bytes, "a.dds");
  put(bytes, 23, 0xff0000);
  put(bytes, 25, 0xff);
  const TextureData swapped = decodeDds(bytes, "a.dds");
  EXPECT_EQ(swapped.texels[0], straight.texels[2]);
  EXPECT_EQ(swapped.texels[2], straight.texels[0]);
  EXPECT_EQ(swapped.texels[3], straight.texels[3]);
  put(bytes, 20, 0x40);
  put(bytes, 26, 0);
  EXPECT_EQ(decodeDds(bytes, "a.dds").texels[3], std::byte{0xff}) << "without alpha all is opaque";
}

TEST(Dds, furtherMipLevelsAreCountedAndLeftOut) {
  const TextureData texture = patterned(TexelFormat::r8, 4, 4, 0);
  std::vector<std::byte> bytes = encodeDds(texture, DdsHeader::dx10);
  put(bytes, 2, 0x20000 | 0x1007);
  put(bytes, 7, 3);
  bytes.resize(bytes.size() + 4 + 1);
  EXPECT_EQ(decodeDds(bytes, "a.dds"), texture);
}

TEST(Dds, theMipCountHoldsWithoutItsFlag) {
  // Some writers leave the flag out; a count beyond the last level of one texel is wrong either way.
  const TextureData texture = patterned(TexelFormat::r8, 4, 4, 0);
  for (const std::uint32_t flags : {0x1007u, 0x21007u}) {
    std::vector<std::byte> bytes = encodeDds(texture, DdsHeader::legacy);
    put(bytes, 2, flags);
    put(bytes, 7, 3);
    EXPECT_EQ(refusal(bytes), "a.dds: texels: 16 bytes where the header says 21");
    bytes.resize(bytes.size() + 4 + 1);
    EXPECT_EQ(decodeDds(bytes, "a.dds"), texture);
    put(bytes, 7, 4);
    EXPECT_EQ(refusal(bytes), "a.dds: mip levels: 4 is out of range 1 to 3");
  }
}

TEST(Dds, aLegacyVolumeIsOneByItsDepthFlagOrItsCapability) {
  // The DX10 header has a field of its own for it, which wins.
  const TextureData volume = patterned(TexelFormat::r8, 4, 4, 2);
  std::vector<std::byte> bytes = encodeDds(volume, DdsHeader::legacy);
  put(bytes, 28, 0);
  EXPECT_EQ(decodeDds(bytes, "a.dds"), volume) << "the flag alone";
  put(bytes, 2, 0x1007);
  put(bytes, 28, 0x200000);
  EXPECT_EQ(decodeDds(bytes, "a.dds"), volume) << "the capability alone";
  put(bytes, 28, 0);
  EXPECT_EQ(refusal(bytes), "a.dds: texels: 32 bytes where the header says 16") << "neither: 2D";
  const TextureData flat = patterned(TexelFormat::r8, 4, 4, 0);
  bytes = encodeDds(flat, DdsHeader::dx10);
  put(bytes, 2, 0x801007);
  put(bytes, 6, 2);
  EXPECT_EQ(decodeDds(bytes, "a.dds"), flat);
}

// Each refusal is one line that names the file and the field.
TEST(Dds, badFieldsAreNamed) {
  const std::vector<std::byte> good = encodeDds(patterned(TexelFormat::rgba8, 8, 8, 8), DdsHeader::dx10);
  const auto with = [&](std::size_t word, std::uint32_t value) {
    std::vector<std::byte> bytes = good;
    put(bytes, word, value);
    return refusal(bytes);
  };
  EXPECT_EQ(with(0, 0x12345678), "a.dds: magic number: not a DDS file");
  EXPECT_EQ(with(1, 100), "a.dds: header size: 100 instead of 124");
  EXPECT_EQ(with(19, 0), "a.dds: pixel format size: 0 instead of 32");
  EXPECT_EQ(with(3, 0), "a.dds: height: 0 is out of range 1 to 2048");
  EXPECT_EQ(with(4, 100000), "a.dds: width: 100000 is out of range 1 to 2048");
  EXPECT_EQ(with(6, 0), "a.dds: depth: 0 is out of range 1 to 2048");
  EXPECT_EQ(with(6, 9), "a.dds: texels: 2048 bytes where the header says 2304");
  EXPECT_EQ(with(32, 98), "a.dds: DXGI format: 98 is not among 2, 28, 41, 49, 56, 61, 65 and 87");
  EXPECT_EQ(with(33, 2), "a.dds: dimension: 2 is neither 3 (2D) nor 4 (volume)");
  EXPECT_EQ(with(35, 6), "a.dds: array size: 6 instead of 1");
  EXPECT_EQ(with(34, 4), "a.dds: misc flag: a cube map");
  std::vector<std::byte> bytes = good;
  bytes.pop_back();
  EXPECT_EQ(refusal(bytes), "a.dds: texels: 2047 bytes where the header says 2048");
  bytes = good;
  bytes.push_back(std::byte{0});
  EXPECT_EQ(refusal(bytes), "a.dds: texels: 2049 bytes where the header says 2048");
  EXPECT_EQ(refusal({}), "a.dds: magic number: not a DDS file");
  bytes.resize(100);
  EXPECT_EQ(refusal(bytes), "a.dds: header: the file ends after 100 of 128 bytes");
}

TEST(Dds, hugeSidesAreRefusedBeforeAnythingIsAllocated) {
  std::vector<std::byte> bytes = encodeDds(patterned(TexelFormat::rgba32f, 1, 1, 1), DdsHeader::dx10);
  for (const std::size_t side : {3u, 4u, 6u}) put(bytes, side, 2048);
  EXPECT_EQ(refusal(bytes), "a.dds: size: 131072 MiB of texels: more than 256 MiB");
}

// Whatever a file holds, the reader gives a texture whose size fits its bytes, or a DataError.
void readsOrRefuses(std::span<const std::byte> bytes) {
  try {
    const TextureData texture = decodeDds(bytes, "a.dds");
    ASSERT_LE(texture.texels.size(), bytes.size());
    ASSERT_EQ(texture.texels.size(), texelBytes(texture.format) * static_cast<std::size_t>(texture.width) *
                                         static_cast<std::size_t>(texture.height) *
                                         static_cast<std::size_t>(std::max(texture.depth, 1)));
  } catch (const DataError&) {
  }
}

// The address sanitizer runs this suite: each file lies in its own exact allocation.
TEST(Dds, damagedFilesAreNeverReadBeyondTheirEnd) {
  std::mt19937 random(20);
  for (const DdsHeader header : {DdsHeader::legacy, DdsHeader::dx10}) {
    for (const int depth : {0, 3}) {
      const std::vector<std::byte> good = encodeDds(patterned(TexelFormat::rg8, 6, 5, depth), header);
      for (std::size_t size = 0; size < good.size(); ++size) {
        readsOrRefuses(
            std::vector<std::byte>(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size)));
      }
      for (int round = 0; round < 20000; ++round) {
        std::vector<std::byte> bytes = good;
        for (unsigned change = random() % 4 + 1; change > 0; --change) {
          const std::uint32_t values[] = {
              0, 1, 2, 0x7fffffff, 0xffffffff, 0x80000000, 0x20000, static_cast<std::uint32_t>(random())};
          put(bytes, random() % 37, values[random() % std::size(values)]);
        }
        bytes.resize(std::max<std::size_t>(bytes.size() - random() % 8, 0));
        readsOrRefuses(bytes);
      }
    }
  }
}

// Files that were once interesting: tests/corpus/dds; each is named for what it is.
TEST(Dds, theCorpusIsReadOrRefused) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(test::sourceDir() + "/tests/corpus/dds")) {
    const std::vector<std::byte> bytes = readFile(entry.path());
    readsOrRefuses(bytes);
    EXPECT_EQ(refusal(bytes).empty(), entry.path().filename().string().starts_with("good"))
        << entry.path() << ": " << refusal(bytes);
    ++files;
  }
  EXPECT_GE(files, 33);
}

}  // namespace
}  // namespace skydrop::core
