// The chunks of a WAV file: found and checked here, so that libsndfile, which repairs silently what it finds
// wrong, never has to guess. No sample is decoded.
//
// Formats: Microsoft and IBM, "Multimedia Programming Interface and Data Specifications 1.0" (RIFF, 1991);
// Microsoft, "Multiple Channel Audio Data and WAVE Files" (WAVE_FORMAT_EXTENSIBLE, 2007); EBU Tech 3306 and
// ITU-R BS.2088 (RF64 and BW64: sizes of 64 bits in a ds64 chunk).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace skydrop::audio {

enum class WavEncoding { pcm, ieeeFloat, aLaw, muLaw, imaAdpcm, msAdpcm };

struct WavFile {
  WavEncoding encoding = WavEncoding::pcm;
  int channels = 0;
  int sampleRate = 0;        // Hz
  std::uint64_t frames = 0;  // of the data; those of the fact chunk where it ends within the last block
  std::span<const std::byte> format;  // content of the chunk "fmt "
  std::span<const std::byte> data;    // content of the chunk "data": whole frames or blocks
};

// RIFF, RF64 and BW64, little-endian, one or two channels. The result refers to `bytes`. Throws
// core::DataError (`name: place: reason`) for anything that would have to be guessed: a size beyond the file,
// chunks that are missing or come twice, fields that contradict each other, other encodings.
WavFile parseWav(std::span<const std::byte> bytes, std::string_view name);

// The same sound as the shortest RIFF file: a format and a data chunk.
std::vector<std::byte> plainWav(const WavFile& wav);

}  // namespace skydrop::audio
