// Plays sounds through OpenAL. Without a sound device everything works and nothing is heard: status() says
// so. Main thread.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "skydrop/audio/audio_settings.h"
#include "skydrop/audio/sound.h"

namespace skydrop::audio {

// A playing sound; stale ones are ignored by every function. 0 is none.
using Voice = std::uint64_t;

class AudioManager {
 public:
  static constexpr int kMaxVoices = 24;        // the oldest sound that does not loop makes room
  static constexpr int kLoopbackRate = 44100;  // Hz

  // device: the default one, or silence. loopback: nothing is played, render() returns what would be heard,
  // the same samples in every run (ALC_SOFT_loopback); throws std::runtime_error where OpenAL has none. none:
  // silence.
  enum class Output { device, loopback, none };
  explicit AudioManager(const AudioSettings& settings, Output output = Output::device);
  ~AudioManager();
  AudioManager(const AudioManager&) = delete;
  AudioManager& operator=(const AudioManager&) = delete;

  bool isSilent() const;
  // One line: the device's name, or why nothing is heard.
  const std::string& status() const;

  // False once the device has gone away, as headphones do: what plays has ended then, and only another
  // AudioManager is heard. True of silence, and where OpenAL cannot tell (ALC_EXT_disconnect).
  bool isConnected() const;

  // Reads the file once and keeps it. Throws core::DataError, also when silent: a broken file is found
  // whether or not there is a sound card.
  void load(const std::filesystem::path& file);

  // Starts the sound, loading it where that was not done. 0 when silent or when every voice loops.
  Voice play2d(const std::filesystem::path& file, bool loop = false);

  void setPitch(Voice voice, double pitch);  // clamped to [0.25, 4]
  void setGain(Voice voice, double gain);    // clamped to [0, 4]
  void setPan(Voice voice, double pan);      // -1 left .. 1 right, clamped; 0 as it starts. Of mono sounds
  void stop(Voice voice);
  bool isPlaying(Voice voice) const;

  void apply(const AudioSettings& settings);
  // Holds every voice where it is.
  void setPaused(bool paused);

  // Loopback only: fills mono samples at kLoopbackRate.
  void render(std::span<float> samples);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace skydrop::audio
