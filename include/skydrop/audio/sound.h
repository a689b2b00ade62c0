// A sound in memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace skydrop::audio {

struct Sound {
  int sampleRate = 0;                  // Hz, 8000 .. 192000
  int channels = 0;                    // 1 or 2
  std::vector<std::int16_t> samples;   // interleaved
  double seconds() const;
};

// Reads a WAV file of at most 60 s (libsndfile). Any thread. Throws core::DataError that names the file, the
// place and the reason: not a WAV, damaged, truncated, no samples, too long, more than two channels.
Sound readWav(const std::filesystem::path& file);

}  // namespace skydrop::audio
