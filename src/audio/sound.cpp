#include "skydrop/audio/sound.h"

#include <sndfile.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "audio/wav_file.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"

namespace skydrop::audio {
namespace {

constexpr double kMaxSeconds = 60;
constexpr std::size_t kMaxBytes = std::size_t{64} << 20;

// Full scale of float samples is 1. A little beyond is a loud recording and is clipped; far beyond, the file
// counts in other units, and clipping would make noise of it.
constexpr double kMostOverdrive = 8;

// libsndfile reads from memory, so that opening, size and reading errors are ours (core/file.h).
struct MemoryFile {
  std::vector<std::byte> bytes;
  sf_count_t position = 0;

  sf_count_t size() const { return static_cast<sf_count_t>(bytes.size()); }
};

MemoryFile& memory(void* user) { return *static_cast<MemoryFile*>(user); }

sf_count_t lengthOf(void* user) { return memory(user).size(); }

sf_count_t seek(sf_count_t offset, int whence, void* user) {
  MemoryFile& file = memory(user);
  const sf_count_t from = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? file.position : file.size();
  if (offset < -from || offset > file.size() - from) return -1;
  return file.position = from + offset;
}

sf_count_t readBytes(void* target, sf_count_t count, void* user) {
  MemoryFile& file = memory(user);
  const sf_count_t there = std::min(count, file.size() - file.position);
  std::copy_n(file.bytes.data() + file.position, there, static_cast<std::byte*>(target));
  file.position += there;
  return there;
}

sf_count_t tell(void* user) { return memory(user).position; }

struct CloseSound {
  void operator()(SNDFILE* sound) const { sf_close(sound); }
};

// libsndfile would give whole numbers of float samples without scaling them, which is silence.
std::vector<std::int16_t> toSixteenBits(const std::vector<double>& samples, const std::string& name) {
  std::vector<std::int16_t> result;
  result.reserve(samples.size());
  for (const double sample : samples) {
    if (!(std::abs(sample) <= kMostOverdrive)) {
      throw core::DataError(name, "sample " + std::to_string(result.size()),
                            "is not finite, or far beyond the full scale of 1");
    }
    result.push_back(static_cast<std::int16_t>(std::clamp(std::round(sample * 32768), -32768.0, 32767.0)));
  }
  return result;
}

}  // namespace

double Sound::seconds() const { return static_cast<double>(samples.size()) / channels / sampleRate; }

Sound readWav(const std::filesystem::path& path) {
  const std::string name = path.string();
  const std::vector<std::byte> bytes = core::readFile(path, kMaxBytes);
  const WavFile wav = parseWav(bytes, name);
  if (wav.frames < 1) throw core::DataError(name, "data chunk", "has no samples");
  if (static_cast<double>(wav.frames) > kMaxSeconds * wav.sampleRate) {
    throw core::DataError(name, "data chunk", "is longer than 60 s");
  }
  MemoryFile file{plainWav(wav)};
  SF_VIRTUAL_IO io{lengthOf, seek, readBytes, nullptr, tell};
  SF_INFO info{};
  const std::unique_ptr<SNDFILE, CloseSound> sound(sf_open_virtual(&io, SFM_READ, &info, &file));
  if (!sound) throw core::DataError(name, "", sf_strerror(nullptr));
  const auto frames = static_cast<sf_count_t>(wav.frames);
  const std::size_t count = static_cast<std::size_t>(wav.frames) * static_cast<std::size_t>(wav.channels);
  if (info.channels != wav.channels || info.samplerate != wav.sampleRate || info.frames < frames) {
    throw core::DataError(name, "fmt chunk", "contradicts itself");
  }
  Sound result{wav.sampleRate, wav.channels, {}};
  sf_count_t read = 0;
  if (wav.encoding == WavEncoding::ieeeFloat) {
    std::vector<double> samples(count);
    read = sf_readf_double(sound.get(), samples.data(), frames);
    result.samples = toSixteenBits(samples, name);
  } else {
    result.samples.resize(count);
    read = sf_readf_short(sound.get(), result.samples.data(), frames);
  }
  if (read != frames) {
    throw core::DataError(name, "data chunk",
                          "ends after " + std::to_string(read) + " of " + std::to_string(frames) + " frames");
  }
  return result;
}

}  // namespace skydrop::audio
