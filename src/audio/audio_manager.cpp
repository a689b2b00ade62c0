#include "skydrop/audio/audio_manager.h"

#define AL_ALEXT_PROTOTYPES
#include <AL/al.h>
#include <AL/alc.h>
#include <AL/alext.h>

#if defined(__unix__)
#include <fcntl.h>
#include <unistd.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

namespace skydrop::audio {
namespace {

struct Slot {
  ALuint source = 0;
  Voice voice = 0;
  bool loops = false;
};

ALfloat clamped(double value, double least, double most) {
  return static_cast<ALfloat>(std::isfinite(value) ? std::clamp(value, least, most) : least);
}

ALenum formatOf(const Sound& sound) { return sound.channels == 1 ? AL_FORMAT_MONO16 : AL_FORMAT_STEREO16; }

// Where there is no sound card, ALSA and OpenAL print a dozen lines of their own, which neither lets be
// turned off at run time; status() says it in one. A device is opened at the start and when one was lost:
// what other threads print in those milliseconds is lost.
class StandardErrorMuted {
 public:
#if defined(__unix__)
  StandardErrorMuted() : kept_(dup(STDERR_FILENO)) {
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (kept_ >= 0 && nowhere >= 0) dup2(nowhere, STDERR_FILENO);
    if (nowhere >= 0) close(nowhere);
  }
  ~StandardErrorMuted() {
    if (kept_ < 0) return;
    dup2(kept_, STDERR_FILENO);
    close(kept_);
  }

 private:
  int kept_;
#endif
};

}  // namespace

struct AudioManager::State {
  ALCdevice* device = nullptr;
  ALCcontext* context = nullptr;
  bool tellsOfLoss = false;  // ALC_EXT_disconnect
  LPALCRENDERSAMPLESSOFT renderSamples = nullptr;
  std::string status;
  std::map<std::filesystem::path, ALuint> buffers;  // 0 when silent: read and found good
  std::array<Slot, kMaxVoices> slots;
  Voice lastVoice = 0;
  bool paused = false;

  void openDevice();
  void openLoopback();
  void openContext(const ALCint* attributes);
  ~State();

  Slot* slotOf(Voice voice);
  Slot* freeSlot();
  ALenum stateOf(const Slot& slot) const;
};

void AudioManager::State::openDevice() {
  {
    const StandardErrorMuted muted;
    device = alcOpenDevice(nullptr);
  }
  if (!device) {
    status = "no sound device: the game is silent";
    return;
  }
  openContext(nullptr);
}

void AudioManager::State::openLoopback() {
  if (!alcIsExtensionPresent(nullptr, "ALC_SOFT_loopback"))
    throw std::runtime_error("OpenAL has no loopback device");
  const auto open =
      reinterpret_cast<LPALCLOOPBACKOPENDEVICESOFT>(alcGetProcAddress(nullptr, "alcLoopbackOpenDeviceSOFT"));
  renderSamples =
      reinterpret_cast<LPALCRENDERSAMPLESSOFT>(alcGetProcAddress(nullptr, "alcRenderSamplesSOFT"));
  device = open(nullptr);
  if (!device) throw std::runtime_error("OpenAL opens no loopback device");
  const ALCint attributes[] = {ALC_FORMAT_CHANNELS_SOFT,
                               ALC_MONO_SOFT,
                               ALC_FORMAT_TYPE_SOFT,
                               ALC_FLOAT_SOFT,
                               ALC_FREQUENCY,
                               kLoopbackRate,
                               0};
  openContext(attributes);
  if (!context) throw std::runtime_error("OpenAL makes no loopback context");
}

void AudioManager::State::openContext(const ALCint* attributes) {
  context = alcCreateContext(device, attributes);
  if (!context || !alcMakeContextCurrent(context)) {
    status = "the sound device gives no context: the game is silent";
    return;
  }
  for (Slot& slot : slots) alGenSources(1, &slot.source);
  tellsOfLoss = alcIsExtensionPresent(device, "ALC_EXT_disconnect") == ALC_TRUE;
  const ALCchar* name = alcGetString(device, ALC_DEVICE_SPECIFIER);
  status = name ? name : "sound device";
}

AudioManager::State::~State() {
  if (context) {
    for (Slot& slot : slots) {
      if (slot.source) alDeleteSources(1, &slot.source);
    }
    for (const auto& [file, buffer] : buffers) {
      if (buffer) alDeleteBuffers(1, &buffer);
    }
    alcMakeContextCurrent(nullptr);
    alcDestroyContext(context);
  }
  if (device) alcCloseDevice(device);
}

ALenum AudioManager::State::stateOf(const Slot& slot) const {
  ALint value = AL_STOPPED;
  alGetSourcei(slot.source, AL_SOURCE_STATE, &value);
  return value;
}

Slot* AudioManager::State::slotOf(Voice voice) {
  if (voice == 0 || !context) return nullptr;
  const auto found =
      std::find_if(slots.begin(), slots.end(), [&](const Slot& slot) { return slot.voice == voice; });
  return found == slots.end() ? nullptr : &*found;
}

// One that has ended, or else the oldest that does not loop.
Slot* AudioManager::State::freeSlot() {
  Slot* oldest = nullptr;
  for (Slot& slot : slots) {
    const ALenum value = stateOf(slot);
    if (value == AL_INITIAL || value == AL_STOPPED) return &slot;
    if (!slot.loops && (!oldest || slot.voice < oldest->voice)) oldest = &slot;
  }
  return oldest;
}

AudioManager::AudioManager(const AudioSettings& settings, Output output) : state_(std::make_unique<State>()) {
  switch (output) {
    case Output::device:
      state_->openDevice();
      break;
    case Output::loopback:
      state_->openLoopback();
      break;
    case Output::none:
      state_->status = "the game is silent";
      break;
  }
  apply(settings);
}

AudioManager::~AudioManager() = default;

bool AudioManager::isSilent() const { return state_->context == nullptr; }

const std::string& AudioManager::status() const { return state_->status; }

bool AudioManager::isConnected() const {
  if (!state_->tellsOfLoss) return true;
  ALCint connected = ALC_TRUE;
  alcGetIntegerv(state_->device, ALC_CONNECTED, 1, &connected);
  return connected != ALC_FALSE;
}

void AudioManager::load(const std::filesystem::path& file) {
  if (state_->buffers.contains(file)) return;
  const Sound sound = readWav(file);
  ALuint buffer = 0;
  if (!isSilent()) {
    alGenBuffers(1, &buffer);
    alBufferData(buffer, formatOf(sound), sound.samples.data(),
                 static_cast<ALsizei>(sound.samples.size() * 2), sound.sampleRate);
  }
  state_->buffers[file] = buffer;
}

Voice AudioManager::play2d(const std::filesystem::path& file, bool loop) {
  load(file);
  if (isSilent()) return 0;
  Slot* slot = state_->freeSlot();
  if (!slot) return 0;
  alSourceStop(slot->source);
  alSourcei(slot->source, AL_BUFFER, static_cast<ALint>(state_->buffers[file]));
  alSourcei(slot->source, AL_LOOPING, loop ? AL_TRUE : AL_FALSE);
  alSourcei(slot->source, AL_SOURCE_RELATIVE, AL_TRUE);  // at the listener: 2D
  alSource3f(slot->source, AL_POSITION, 0, 0, 0);
  alSourcef(slot->source, AL_ROLLOFF_FACTOR, 0);  // distance is in the gain
  alSourcef(slot->source, AL_PITCH, 1);
  alSourcef(slot->source, AL_GAIN, 1);
  alSourcePlay(slot->source);
  if (state_->paused) alSourcePause(slot->source);
  slot->voice = ++state_->lastVoice;
  slot->loops = loop;
  return slot->voice;
}

void AudioManager::setPitch(Voice voice, double pitch) {
  if (const Slot* slot = state_->slotOf(voice)) alSourcef(slot->source, AL_PITCH, clamped(pitch, 0.25, 4));
}

void AudioManager::setGain(Voice voice, double gain) {
  if (const Slot* slot = state_->slotOf(voice)) alSourcef(slot->source, AL_GAIN, clamped(gain, 0, 4));
}

void AudioManager::setPan(Voice voice, double pan) {
  const Slot* slot = state_->slotOf(voice);
  if (!slot) return;
  const float aside = clamped(pan, -1, 1);
  // On the circle before the listener; the middle itself is all around, as where nothing was said.
  alSource3f(slot->source, AL_POSITION, aside, 0, aside == 0 ? 0 : -std::sqrt(1 - aside * aside));
}

void AudioManager::stop(Voice voice) {
  if (Slot* slot = state_->slotOf(voice)) {
    alSourceStop(slot->source);
    slot->voice = 0;
    slot->loops = false;
  }
}

bool AudioManager::isPlaying(Voice voice) const {
  const Slot* slot = state_->slotOf(voice);
  return slot && state_->stateOf(*slot) == AL_PLAYING;
}

void AudioManager::apply(const AudioSettings& settings) {
  if (!isSilent()) alListenerf(AL_GAIN, settings.mute ? 0.0f : clamped(settings.volume, 0, 1));
}

void AudioManager::setPaused(bool paused) {
  if (isSilent() || paused == state_->paused) return;
  state_->paused = paused;
  for (const Slot& slot : state_->slots) {
    const ALenum value = state_->stateOf(slot);
    if (paused && value == AL_PLAYING) alSourcePause(slot.source);
    if (!paused && value == AL_PAUSED) alSourcePlay(slot.source);
  }
}

void AudioManager::render(std::span<float> samples) {
  state_->renderSamples(state_->device, samples.data(), static_cast<ALCsizei>(samples.size()));
}

}  // namespace skydrop::audio
