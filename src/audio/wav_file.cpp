#include "audio/wav_file.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <string>

#include "skydrop/core/error.h"

namespace skydrop::audio {
namespace {

constexpr std::uint32_t kUnknownSize = 0xffffffff;  // of a chunk whose size is in ds64
constexpr std::size_t kMostFormatBytes = 4096;

// Format tags of the chunk "fmt ", with the names that messages use.
struct Tag {
  std::uint16_t value;
  std::string_view name;
  std::optional<WavEncoding> encoding;
};
constexpr std::uint16_t kExtensible = 0xfffe;
constexpr std::array<Tag, 13> kTags = {{{1, "PCM", WavEncoding::pcm},
                                        {2, "MS ADPCM", WavEncoding::msAdpcm},
                                        {3, "IEEE float", WavEncoding::ieeeFloat},
                                        {6, "A-law", WavEncoding::aLaw},
                                        {7, "mu-law", WavEncoding::muLaw},
                                        {0x11, "IMA ADPCM", WavEncoding::imaAdpcm},
                                        {0x31, "GSM 6.10", {}},
                                        {0x38, "NMS ADPCM", {}},
                                        {0x40, "G.721 ADPCM", {}},
                                        {0x50, "MPEG audio", {}},
                                        {0x55, "MP3", {}},
                                        {0xff, "AAC", {}},
                                        {0x161, "Windows Media Audio", {}}}};
// The last 14 bytes of a sub-format that is a format tag: xxxx0000-0000-0010-8000-00aa00389b71.
constexpr std::array<std::uint8_t, 14> kTagGuid = {0, 0, 0,    0, 0x10, 0,    0x80,
                                                   0, 0, 0xaa, 0, 0x38, 0x9b, 0x71};

template <class Word>
Word littleEndian(std::span<const std::byte> bytes, std::size_t at) {
  Word word = 0;
  for (std::size_t i = sizeof(Word); i-- > 0;) {
    word = static_cast<Word>(static_cast<std::uint64_t>(word) << 8 |
                             std::to_integer<std::uint64_t>(bytes[at + i]));
  }
  return word;
}

bool isMark(std::span<const std::byte> bytes, std::size_t at, std::string_view mark) {
  return bytes.size() >= at + 4 && std::memcmp(bytes.data() + at, mark.data(), 4) == 0;
}

class WavParser {
 public:
  WavParser(std::span<const std::byte> bytes, std::string_view name) : bytes_(bytes), name_(name) {}

  WavFile parse() {
    readHeader();
    while (end_ - at_ >= 8) readChunk();
    if (wav_.format.empty()) fail("fmt chunk", "is missing");
    if (!hasData_) fail("data chunk", "is missing");
    countFrames();
    return wav_;
  }

 private:
  [[noreturn]] void fail(std::string_view place, std::string_view reason) const {
    throw core::DataError(name_, place, reason);
  }

  void readHeader() {
    if (isMark(bytes_, 0, "RIFX")) fail("header", "a big-endian WAV file (RIFX) is not read");
    is64Bit_ = isMark(bytes_, 0, "RF64") || isMark(bytes_, 0, "BW64");
    if (!is64Bit_ && !isMark(bytes_, 0, "RIFF")) fail("header", "not a WAV file");
    if (bytes_.size() < 12) fail("header", "the file ends in it");
    if (!isMark(bytes_, 8, "WAVE")) fail("header", "a RIFF file, but not a WAV file");
    at_ = 12;
    if (is64Bit_) {
      if (bytes_.size() < 20 || !isMark(bytes_, 12, "ds64")) fail("ds64 chunk", "is missing");
      const std::uint32_t size = littleEndian<std::uint32_t>(bytes_, 16);
      if (size < 28 || size > bytes_.size() - 20) fail("ds64 chunk", "does not fit into the file");
      dataBytes64_ = littleEndian<std::uint64_t>(bytes_, 28);
      at_ = 20 + size + size % 2;
    }
    const std::uint64_t size =
        is64Bit_ ? littleEndian<std::uint64_t>(bytes_, 20) : littleEndian<std::uint32_t>(bytes_, 4);
    if (size > bytes_.size() - 8) {
      fail("header", "says that " + std::to_string(size) + " bytes follow, " +
                         std::to_string(bytes_.size() - 8) + " do: truncated");
    }
    // What follows the RIFF chunk is not part of the sound.
    end_ = static_cast<std::size_t>(size) + 8;
    if (at_ > end_) fail("header", "says that the file ends within it");
  }

  void readChunk() {
    const std::span<const std::byte> head = bytes_.subspan(at_, 8);
    std::uint64_t size = littleEndian<std::uint32_t>(head, 4);
    at_ += 8;
    const bool isFormat = isMark(head, 0, "fmt "), isData = isMark(head, 0, "data");
    if (isData && is64Bit_) {
      if (size != kUnknownSize && size != dataBytes64_) fail("data chunk", "has another size than ds64 says");
      size = dataBytes64_;
    }
    if (size > end_ - at_) {
      const std::string place = isFormat ? "fmt chunk" : isData ? "data chunk" : "chunk";
      fail(place,
           "says " + std::to_string(size) + " bytes, " + std::to_string(end_ - at_) + " follow: truncated");
    }
    const std::span<const std::byte> content = bytes_.subspan(at_, static_cast<std::size_t>(size));
    if (isFormat) {
      if (!wav_.format.empty()) fail("fmt chunk", "there are two");
      readFormat(content);
    } else if (isData) {
      if (hasData_) fail("data chunk", "there are two");
      if (wav_.format.empty()) fail("data chunk", "comes before the fmt chunk");
      hasData_ = true;
      wav_.data = content;
    } else if (isMark(head, 0, "fact") && content.size() >= 4) {
      factFrames_ = littleEndian<std::uint32_t>(content, 0);
    }
    // A chunk of odd size is padded; not every program pads the last.
    at_ += static_cast<std::size_t>(std::min<std::uint64_t>(size + size % 2, end_ - at_));
  }

  void readFormat(std::span<const std::byte> format) {
    if (format.size() < 16 || format.size() > kMostFormatBytes) {
      fail("fmt chunk", std::to_string(format.size()) + " bytes; 16 to 4096 are possible");
    }
    wav_.format = format;
    wav_.channels = littleEndian<std::uint16_t>(format, 2);
    const std::uint32_t rate = littleEndian<std::uint32_t>(format, 4);
    blockBytes_ = littleEndian<std::uint16_t>(format, 12);
    bits_ = littleEndian<std::uint16_t>(format, 14);
    if (wav_.channels < 1 || wav_.channels > 2) {
      fail("fmt chunk", std::to_string(wav_.channels) + " channels; 1 and 2 are read");
    }
    if (rate < 8000 || rate > 192000) {
      fail("fmt chunk", "sample rate " + std::to_string(rate) + " Hz; 8000 to 192000 are read");
    }
    wav_.sampleRate = static_cast<int>(rate);
    wav_.encoding = encodingOf(format);
    checkBits();
  }

  WavEncoding encodingOf(std::span<const std::byte> format) const {
    std::uint16_t tag = littleEndian<std::uint16_t>(format, 0);
    if (tag == kExtensible) {
      if (format.size() < 40) fail("fmt chunk", "an extensible format without its extension");
      const auto* guid = reinterpret_cast<const std::uint8_t*>(format.data() + 26);
      if (!std::equal(kTagGuid.begin(), kTagGuid.end(), guid)) {
        fail("fmt chunk", "an extensible format of a kind that is not read");
      }
      const int validBits = littleEndian<std::uint16_t>(format, 18);
      if (validBits > bits_) fail("fmt chunk", "more valid bits than a sample has");
      tag = littleEndian<std::uint16_t>(format, 24);
    }
    const auto* known =
        std::find_if(kTags.begin(), kTags.end(), [&](const Tag& t) { return t.value == tag; });
    const std::string name =
        known == kTags.end() ? "format " + std::to_string(tag) : std::string(known->name);
    if (known == kTags.end() || !known->encoding) {
      fail("fmt chunk", name + " is not read, only PCM, IEEE float, A-law, mu-law, IMA and MS ADPCM");
    }
    return *known->encoding;
  }

  void checkBits() {
    const bool isAdpcm = wav_.encoding == WavEncoding::imaAdpcm || wav_.encoding == WavEncoding::msAdpcm;
    const bool good = wav_.encoding == WavEncoding::pcm
                          ? bits_ == 8 || bits_ == 16 || bits_ == 24 || bits_ == 32
                      : wav_.encoding == WavEncoding::ieeeFloat ? bits_ == 32 || bits_ == 64
                      : isAdpcm                                 ? bits_ == 4
                                                                : bits_ == 8;
    if (!good) fail("fmt chunk", std::to_string(bits_) + " bits a sample are not read");
    const int channels = wav_.channels;
    if (!isAdpcm) {
      if (blockBytes_ != channels * bits_ / 8) {
        fail("fmt chunk", "says " + std::to_string(blockBytes_) + " bytes a frame where its channels take " +
                              std::to_string(channels * bits_ / 8));
      }
      return;
    }
    // Of a block and a channel: first a header with one sample (IMA, 4 bytes) or two (MS, 7 bytes), then half
    // a byte a sample.
    const bool isIma = wav_.encoding == WavEncoding::imaAdpcm;
    const int header = isIma ? 4 : 7, first = isIma ? 1 : 2;
    if (wav_.format.size() < 20 || littleEndian<std::uint16_t>(wav_.format, 0) == kExtensible) {
      fail("fmt chunk", "ADPCM without its count of samples a block");
    }
    blockFrames_ = littleEndian<std::uint16_t>(wav_.format, 18);
    if (!isIma) checkPredictors();
    if (blockBytes_ % channels != 0 || blockBytes_ / channels <= header ||
        blockFrames_ != (blockBytes_ / channels - header) * 2 + first) {
      fail("fmt chunk", std::to_string(blockFrames_) + " samples do not fill a block of " +
                            std::to_string(blockBytes_) + " bytes");
    }
  }

  // libsndfile decodes with the standard predictors whatever the file says.
  void checkPredictors() const {
    constexpr std::array<std::int16_t, 15> kStandard = {7,  256, 0, 512, -256, 0,   0,   192,
                                                        64, 240, 0, 460, -208, 392, -232};
    bool good = wav_.format.size() >= 20 + 2 * kStandard.size();
    for (std::size_t i = 0; good && i < kStandard.size(); ++i) {
      good = static_cast<std::int16_t>(littleEndian<std::uint16_t>(wav_.format, 20 + 2 * i)) == kStandard[i];
    }
    if (!good) fail("fmt chunk", "MS ADPCM with predictors other than the standard's seven");
  }

  void countFrames() {
    const auto block = static_cast<std::size_t>(blockBytes_);
    if (wav_.data.size() % block != 0) {
      fail("data chunk", std::to_string(wav_.data.size()) + " bytes do not make whole frames or blocks of " +
                             std::to_string(block));
    }
    wav_.frames = wav_.data.size() / block * static_cast<std::uint64_t>(blockFrames_);
    if (blockFrames_ == 1 || !factFrames_) return;
    if (*factFrames_ > wav_.frames) {
      fail("fact chunk", "says " + std::to_string(*factFrames_) + " samples where the blocks hold " +
                             std::to_string(wav_.frames));
    }
    // It can only end within the last block. libsndfile counts half the samples of two channels; then the
    // blocks decide.
    if (*factFrames_ + static_cast<std::uint64_t>(blockFrames_) <= wav_.frames) return;
    wav_.frames = *factFrames_;
  }

  std::span<const std::byte> bytes_;
  std::string name_;
  std::size_t at_ = 0, end_ = 0;
  bool is64Bit_ = false, hasData_ = false;
  std::uint64_t dataBytes64_ = 0;
  std::optional<std::uint64_t> factFrames_;
  int blockBytes_ = 0, blockFrames_ = 1, bits_ = 0;
  WavFile wav_;
};

}  // namespace

WavFile parseWav(std::span<const std::byte> bytes, std::string_view name) {
  return WavParser(bytes, name).parse();
}

std::vector<std::byte> plainWav(const WavFile& wav) {
  std::vector<std::byte> bytes;
  bytes.reserve(wav.format.size() + wav.data.size() + 32);
  const auto add = [&bytes](std::string_view mark) {
    for (const char c : mark) bytes.push_back(static_cast<std::byte>(c));
  };
  const auto addSize = [&bytes](std::size_t size) {
    for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<std::byte>(size >> (8 * i)));
  };
  const auto addChunk = [&](std::string_view mark, std::span<const std::byte> content) {
    add(mark);
    addSize(content.size());
    bytes.insert(bytes.end(), content.begin(), content.end());
    if (content.size() % 2 != 0) bytes.push_back(std::byte{0});
  };
  const auto padded = [](std::size_t size) { return size + size % 2; };
  add("RIFF");
  addSize(4 + 8 + padded(wav.format.size()) + 8 + padded(wav.data.size()));
  add("WAVE");
  addChunk("fmt ", wav.format);
  addChunk("data", wav.data);
  return bytes;
}

}  // namespace skydrop::audio
