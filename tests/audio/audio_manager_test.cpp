#include "skydrop/audio/audio_manager.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstring>
#include <memory>
#include <numbers>
#include <vector>

#include "skydrop/audio/sound_scene.h"
#include "skydrop/core/assets.h"
#include "skydrop/core/error.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace skydrop::audio {
namespace {

constexpr double kRate = AudioManager::kLoopbackRate;

// A sine of one second as the bytes of a 16-bit mono WAV file.
std::string sineWav(double hertz, int rate = 44100) {
  std::string data;
  for (int i = 0; i < rate; ++i) {
    const auto sample = static_cast<std::int16_t>(16000 * std::sin(2 * std::numbers::pi * hertz * i / rate));
    data.append(reinterpret_cast<const char*>(&sample), 2);
  }
  std::string wav = "RIFF";
  const auto add = [&wav](auto value) { wav.append(reinterpret_cast<const char*>(&value), sizeof value); };
  add(static_cast<std::uint32_t>(36 + data.size()));
  wav += "WAVEfmt ";
  add(std::uint32_t{16}), add(std::uint16_t{1}), add(std::uint16_t{1}), add(static_cast<std::uint32_t>(rate));
  add(static_cast<std::uint32_t>(rate * 2)), add(std::uint16_t{2}), add(std::uint16_t{16});
  wav += "data";
  add(static_cast<std::uint32_t>(data.size()));
  return wav + data;
}

// Strength of one frequency in the samples: the amplitude of a sine there.
double amplitudeAt(const std::vector<float>& samples, double hertz) {
  std::complex<double> sum = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    sum += static_cast<double>(samples[i]) *
           std::polar(1.0, -2 * std::numbers::pi * hertz * static_cast<double>(i) / kRate);
  }
  return 2 * std::abs(sum) / static_cast<double>(samples.size());
}

double rms(const std::vector<float>& samples) {
  double sum = 0;
  for (const float s : samples) sum += static_cast<double>(s) * s;
  return std::sqrt(sum / static_cast<double>(samples.size()));
}

class AudioTest : public testing::Test {
 protected:
  void SetUp() override {
    try {
      audio_ = std::make_unique<AudioManager>(AudioSettings{.volume = 1}, AudioManager::Output::loopback);
    } catch (const std::runtime_error& error) {
      GTEST_SKIP() << error.what();
    }
    sine_ = folder_.write("sine.wav", sineWav(441));
  }
  // What is heard in the next `seconds`; the first hundredth is left out, where the mixer fades in.
  std::vector<float> listen(double seconds) {
    std::vector<float> skipped(441), samples(static_cast<std::size_t>(seconds * kRate));
    audio_->render(skipped);
    audio_->render(samples);
    return samples;
  }
  test::TemporaryFolder folder_;
  std::unique_ptr<AudioManager> audio_;
  std::string sine_;
};

TEST_F(AudioTest, aPlayedSineIsHeardAtItsFrequency) {
  audio_->play2d(sine_);
  const std::vector<float> heard = listen(0.5);
  EXPECT_GT(amplitudeAt(heard, 441), 0.2);
  EXPECT_LT(amplitudeAt(heard, 800), 0.02);
}

TEST_F(AudioTest, pitchMovesTheFrequency) {
  const Voice voice = audio_->play2d(sine_, true);
  audio_->setPitch(voice, 1.5);
  const std::vector<float> heard = listen(0.5);
  EXPECT_GT(amplitudeAt(heard, 661.5), 0.2);
  EXPECT_LT(amplitudeAt(heard, 441), 0.02);
}

TEST_F(AudioTest, volumeScalesAndMuteSilences) {
  audio_->play2d(sine_, true);
  const double full = rms(listen(0.2));
  audio_->apply({.volume = 0.5});
  listen(0.1);
  EXPECT_NEAR(rms(listen(0.2)) / full, 0.5, 0.05);  // the mixer interpolates gains
  audio_->apply({.volume = 1, .mute = true});
  listen(0.1);
  EXPECT_LT(rms(listen(0.2)), 1e-4);
}

TEST_F(AudioTest, aLoopGoesOnAndASingleSoundEnds) {
  const Voice loop = audio_->play2d(sine_, true);
  const Voice once = audio_->play2d(sine_, false);
  listen(1.5);
  EXPECT_TRUE(audio_->isPlaying(loop));
  EXPECT_FALSE(audio_->isPlaying(once));
  audio_->stop(loop);
  EXPECT_FALSE(audio_->isPlaying(loop));
}

TEST_F(AudioTest, pausingHoldsASoundWhereItIs) {
  const Voice voice = audio_->play2d(sine_, false);
  listen(0.4);
  audio_->setPaused(true);
  listen(2);
  audio_->setPaused(false);
  EXPECT_TRUE(audio_->isPlaying(voice));
}

TEST_F(AudioTest, moreSoundsThanVoicesTakeTheOldestThatDoesNotLoop) {
  const Voice loop = audio_->play2d(sine_, true);
  const Voice first = audio_->play2d(sine_, false);
  for (int i = 0; i < AudioManager::kMaxVoices; ++i) EXPECT_NE(audio_->play2d(sine_, false), 0u);
  EXPECT_TRUE(audio_->isPlaying(loop));
  EXPECT_FALSE(audio_->isPlaying(first));
}

TEST_F(AudioTest, theSameSoundsGiveTheSameSamples) {
  const auto run = [&] {
    AudioManager audio(AudioSettings{}, AudioManager::Output::loopback);
    audio.setPitch(audio.play2d(sine_, true), 1.1);
    std::vector<float> samples(20000);
    audio.render(samples);
    return samples;
  };
  audio_.reset();  // one current context at a time
  EXPECT_EQ(run(), run());
}

TEST_F(AudioTest, theEngineRisesWithTheThrottleAndEventsAreHeard) {
  SoundScene scene(*audio_, AudioSettings{.volume = 1});
  game::Snapshot now;
  scene.update(now, {});
  EXPECT_LT(rms(listen(0.1)), 1e-4) << "there is no aircraft";
  now.aircraft.present = true;
  now.aircraft.airspeedMps = 70;
  scene.update(now, {});
  const double idle = rms(listen(0.3));
  now.aircraft.throttle = 1;
  scene.update(now, {});
  listen(0.1);
  EXPECT_GT(rms(listen(0.3)), 1.3 * idle);
  EXPECT_GT(SoundScene::enginePitch(1, 70), SoundScene::enginePitch(0.5, 70));
  now.aircraft.crashed = true;
  const game::GameEvent crash{.kind = game::GameEventKind::crashed, .position = glm::dvec3(0)};
  scene.update(now, std::span(&crash, 1));
  EXPECT_GT(rms(listen(0.2)), 0.05) << "the crash";
  listen(2);
  EXPECT_LT(rms(listen(0.2)), 1e-4) << "the engine stands";
}

TEST_F(AudioTest, rainAndWindAreHeardInWeatherAlone) {
  // Louder in more rain and at more speed, and over when it is dry; without weather there is nothing of it.
  SoundScene scene(*audio_, AudioSettings{.volume = 1, .engineVolume = 0, .weatherVolume = 1});
  game::Snapshot now;
  now.aircraft.present = true;
  now.aircraft.airspeedMps = 70;
  const auto loudness = [&](double rain, double gust) {
    auto air = std::make_shared<weather::WeatherSettings>();
    air->variability = 0;
    air->sites[0].layers[0].cover = 1;
    air->sites[0].rain = rain;
    now.weather = {.settings = air};
    now.air.present = true;
    now.air.velocity = glm::dvec3(gust, 0, 0);
    scene.update(now, {});
    listen(0.1);
    return rms(listen(0.5));
  };
  scene.update(now, {});
  EXPECT_LT(rms(listen(0.2)), 1e-4) << "no weather";
  const double calm = loudness(0, 0), gusty = loudness(0, 8), light = loudness(1, 0), heavy = loudness(20, 0);
  EXPECT_LT(calm, 1e-4);
  EXPECT_GT(gusty, 0.01);
  EXPECT_GT(light, 0.005);
  EXPECT_GT(heavy, 2 * light);
  EXPECT_GT(SoundScene::rainGain(5, 70), SoundScene::rainGain(5, 0));
  EXPECT_EQ(SoundScene::rainGain(0, 70), 0);
  EXPECT_LE(SoundScene::rainGain(150, 300), 1);
  now.weather = {};
  scene.update(now, {});
  EXPECT_LT(rms(listen(0.2)), 1e-4) << "the effect has gone";
  now.air = {};
  now.aircraft.airspeedMps = 115;
  scene.update(now, {});
  listen(0.1);
  EXPECT_GT(rms(listen(0.3)), 0.01) << "a dive is heard in any air";
  now.aircraft.crashed = true;
  scene.update(now, {});
  EXPECT_LT(rms(listen(0.2)), 1e-4);
}

TEST_F(AudioTest, whoIsNotAboardHearsTheEngineFromAfar) {
  // A test's engine: a sine as its loop would show pitch; here loudness and that horn and warning stay
  // aboard.
  SoundScene scene(*audio_, AudioSettings{.volume = 1, .engineVolume = 1, .weatherVolume = 0});
  game::Snapshot now;
  now.aircraft.present = true;
  now.aircraft.airspeedMps = 70;
  now.aircraft.throttle = 1;
  const auto loudness = [&](const Listener& listener) {
    scene.update(now, {}, listener);
    listen(0.1);
    return rms(listen(0.5));
  };
  const double aboard = loudness({});
  const double beside = loudness({.aboard = false, .position = {0, 0, 10}});
  const double off = loudness({.aboard = false, .position = {0, 0, 120}});
  EXPECT_NEAR(beside / aboard, 1, 0.1);
  EXPECT_NEAR(off / aboard, 0.1, 0.03);
  EXPECT_LT(loudness({.aboard = false, .position = {0, 0, 20000}}), 1e-4);
  now.aircraft.throttle = 0;
  now.pullUpSeconds = 2;
  now.aircraft.stallWarning = true;
  EXPECT_LT(loudness({.aboard = false, .position = {0, 0, 20000}}), 1e-4) << "warnings";
  EXPECT_GT(loudness({}), 0.05);
}

TEST_F(AudioTest, placesSoundByTheirLoudness) {
  SoundScene scene(*audio_, AudioSettings{.volume = 1, .engineVolume = 0, .natureVolume = 1});
  const Listener standing{.aboard = false};
  const auto loudness = [&](const Surroundings& around, const Listener& listener) {
    scene.update({}, {}, listener, around);
    listen(0.2);
    return rms(listen(2));
  };
  EXPECT_LT(loudness({}, standing), 1e-4);
  const double birds = loudness({.birds = 1}, standing);
  EXPECT_GT(birds, 0.005);
  EXPECT_GT(loudness({.water = 1}, standing), 0.02);
  EXPECT_LT(loudness({.birds = 1}, {}), 0.7 * birds) << "through the cabin";
  EXPECT_LT(loudness({}, standing), 1e-4) << "over";
}

TEST_F(AudioTest, groundAheadIsWarnedOfAndAHitIsApplauded) {
  SoundScene scene(*audio_, AudioSettings{.volume = 1, .engineVolume = 0, .weatherVolume = 0});
  game::Snapshot now;
  now.aircraft.present = true;
  now.aircraft.airspeedMps = 70;
  scene.update(now, {});
  EXPECT_LT(rms(listen(0.5)), 1e-4);
  now.pullUpSeconds = 3;
  scene.update(now, {});
  EXPECT_GT(rms(listen(0.8)), 0.02);
  now.pullUpSeconds.reset();
  scene.update(now, {});
  EXPECT_LT(rms(listen(0.2)), 1e-4) << "over at once";
  const game::GameEvent hit{.kind = game::GameEventKind::scored, .position = glm::dvec3(0)};
  scene.update(now, std::span(&hit, 1));
  listen(1.6);  // the chime has ended
  EXPECT_GT(rms(listen(0.3)), 0.005) << "hands";
}

TEST(Sound, theGamesSoundsAreWholeAndDoNotClick) {
  // Every shipped sound reads, and its ends meet: a loop's within what neighbouring samples differ by.
  for (const auto& entry : std::filesystem::directory_iterator(core::assetPath("audio"))) {
    const Sound sound = readWav(entry.path());
    EXPECT_GT(sound.seconds(), 0.2) << entry.path();
    const std::string name = entry.path().stem().string();
    const bool loops = name == "engine" || name == "stall" || name == "rain" || name == "wind" ||
                       name == "warning" || name == "birds" || name == "water";
    const int jump = std::abs(sound.samples.front() - sound.samples.back());
    int largest = 0;
    for (std::size_t i = 1; i < sound.samples.size(); ++i) {
      largest = std::max(largest, std::abs(sound.samples[i] - sound.samples[i - 1]));
    }
    EXPECT_LE(jump, loops ? largest : 300) << entry.path();
  }
}

TEST(Sound, damagedAndForeignFilesAreRefusedInOneLine) {
  const test::TemporaryFolder folder;
  const std::string whole = sineWav(441);
  const auto refusal = [&](const std::string& content) {
    return test::refusalOf<core::DataError>([&] { readWav(folder.write("a.wav", content)); });
  };
  EXPECT_EQ(refusal(whole), "");
  for (const int length : {0, 3, 12, 20, 36, 44, 4000}) {
    const std::string line = refusal(whole.substr(0, static_cast<std::size_t>(length)));
    EXPECT_NE(line.find("a.wav"), std::string::npos) << length << " " << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
  }
  std::string channels = whole;
  channels[22] = 9;
  EXPECT_NE(refusal(channels), "");
  std::string rate = whole;
  std::memset(rate.data() + 24, 0xff, 4);
  EXPECT_NE(refusal(rate), "");
  EXPECT_NE(refusal("not a sound at all, just some words that are long enough"), "");
}

TEST(AudioManager, withoutADeviceItIsSilentAndSaysSo) {
  setenv("ALSOFT_DRIVERS", "nothing", 1);
  AudioManager audio{AudioSettings{}};
  unsetenv("ALSOFT_DRIVERS");
  if (!audio.isSilent()) GTEST_SKIP() << "a device answers all the same: " << audio.status();
  EXPECT_EQ(audio.status(), "no sound device: the game is silent");
  EXPECT_EQ(audio.play2d(core::assetPath("audio/drop.wav")), 0u);
  audio.setPitch(1, 2);
  audio.setPaused(true);
  EXPECT_THROW(audio.load("/nowhere.wav"), core::DataError);
}

}  // namespace
}  // namespace skydrop::audio
