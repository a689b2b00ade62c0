// A sound in memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace skydrop::audio {

struct Sound {
  int sampleRate = 0;                 // Hz, 8000 .. 192000
  int channels = 0;                   // 1 or 2
  std::vector<std::int16_t> samples;  // interleaved
  double seconds() const;
};

// Reads a WAV file of at most 60 s (libsndfile). Any thread. RIFF, RF64 and BW64; PCM of 8, 16, 24 and 32
// bits, float of 32 and 64, A-law, mu-law, IMA and MS ADPCM, plain or as WAVE_FORMAT_EXTENSIBLE. More than 16
// bits are cut; float samples have a full scale of 1 and are rounded and clipped. Throws core::DataError that
// names the file, the place and the reason: not a WAV, another encoding, damaged, truncated, a size or count
// that contradicts another, no samples, too long, more than two channels, a float sample that is not finite
// or beyond 8.
Sound readWav(const std::filesystem::path& file);

}  // namespace skydrop::audio
