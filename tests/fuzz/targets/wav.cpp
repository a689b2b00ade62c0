// WAV sounds, through libsndfile.
#include "fuzz/fuzz_input.h"
#include "skydrop/audio/sound.h"

using namespace skydrop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::filesystem::path file = fuzz::inputFile("a.wav", data, size);
  fuzz::accepts("a.wav", [&] {
    const audio::Sound sound = audio::readWav(file);
    fuzz::require(sound.sampleRate >= 8000 && sound.sampleRate <= 192000, "the rate is in its range");
    fuzz::require(sound.channels == 1 || sound.channels == 2, "there are one or two channels");
    fuzz::require(sound.seconds() > 0 && sound.seconds() <= 61, "a sound has a length");
  });
  return 0;
}
