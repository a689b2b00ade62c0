#include "skydrop/audio/sound.h"

#include <sndfile.h>

#include <algorithm>
#include <memory>
#include <string>

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"

namespace skydrop::audio {
namespace {

constexpr double kMaxSeconds = 60;
constexpr std::size_t kMaxBytes = std::size_t{64} << 20;

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

// libsndfile plays a truncated file as a shorter one; a RIFF header tells how long it was meant to be.
bool isTruncated(const std::vector<std::byte>& bytes) {
  if (bytes.size() < 8) return true;
  std::uint32_t size = 0;
  for (std::size_t i = 0; i < 4; ++i) size |= std::to_integer<std::uint32_t>(bytes[4 + i]) << (8 * i);
  return size + std::uint64_t{8} > bytes.size();
}

struct CloseSound {
  void operator()(SNDFILE* sound) const { sf_close(sound); }
};

}  // namespace

double Sound::seconds() const {
  return static_cast<double>(samples.size()) / channels / sampleRate;
}

Sound readWav(const std::filesystem::path& path) {
  const std::string name = path.string();
  MemoryFile file{core::readFile(path, kMaxBytes)};
  SF_VIRTUAL_IO io{lengthOf, seek, readBytes, nullptr, tell};
  SF_INFO info{};
  const std::unique_ptr<SNDFILE, CloseSound> sound(sf_open_virtual(&io, SFM_READ, &info, &file));
  if (!sound) throw core::DataError(name, "header", sf_strerror(nullptr));
  if ((info.format & SF_FORMAT_TYPEMASK) != SF_FORMAT_WAV) throw core::DataError(name, "header", "not a WAV file");
  if (isTruncated(file.bytes)) throw core::DataError(name, "header", "the file is shorter than it says: truncated");
  if (info.channels < 1 || info.channels > 2) {
    throw core::DataError(name, "header", std::to_string(info.channels) + " channels; 1 and 2 are understood");
  }
  if (info.samplerate < 8000 || info.samplerate > 192000) {
    throw core::DataError(name, "header", "sample rate " + std::to_string(info.samplerate) + " Hz is out of range");
  }
  if (info.frames < 1) throw core::DataError(name, "data", "has no samples");
  if (static_cast<double>(info.frames) > kMaxSeconds * info.samplerate) {
    throw core::DataError(name, "data", "is longer than 60 s");
  }
  Sound result{info.samplerate, info.channels, {}};
  result.samples.resize(static_cast<std::size_t>(info.frames * info.channels));
  const sf_count_t frames = sf_readf_short(sound.get(), result.samples.data(), info.frames);
  if (frames != info.frames) {
    throw core::DataError(name, "data", "ends after " + std::to_string(frames) + " of " +
                                            std::to_string(info.frames) + " frames");
  }
  return result;
}

}  // namespace skydrop::audio
