#include <gtest/gtest.h>
#include <sndfile.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <vector>

#include "skydrop/audio/sound.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "support/cost.h"
#include "support/mutants.h"
#include "support/paths.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace skydrop::audio {
namespace {

constexpr int kRate = 22050, kFrames = 4000;
const std::filesystem::path kCorpus = test::sourceDir() + "/tests/corpus/sounds";

// Two sines, the second of half the frequency for a second channel.
std::vector<double> sines(int channels) {
  std::vector<double> samples;
  for (int i = 0; i < kFrames; ++i) {
    for (int c = 0; c < channels; ++c)
      samples.push_back(0.6 * std::sin(2 * std::numbers::pi * 440 / (1 + c) * i / kRate));
  }
  return samples;
}

struct Encoding {
  const char* name;
  int format;
  double tolerance;  // of full scale
  int settled = 0;   // frames after which it holds
};

// libsndfile writes full scale as 127 or 32767 and we read it as 128 or 32768: 0.6 of a step for these sines,
// beside half a step of rounding. Longer samples are cut to 16 bits. The others as libsndfile itself decodes
// them, rounded up; the steps of IMA ADPCM have to grow from 7/32768 first.
constexpr double kStep8 = 1.11 / 128, kStep16 = 1.11 / 32768;
constexpr Encoding kEncodings[] = {
    {"8 bits", SF_FORMAT_PCM_U8, kStep8},
    {"16 bits", SF_FORMAT_PCM_16, kStep16},
    {"24 bits", SF_FORMAT_PCM_24, kStep16},
    {"32 bits", SF_FORMAT_PCM_32, kStep16},
    {"float 32", SF_FORMAT_FLOAT, kStep16},
    {"float 64", SF_FORMAT_DOUBLE, kStep16},
    {"A-law", SF_FORMAT_ALAW, 0.017},
    {"mu-law", SF_FORMAT_ULAW, 0.017},
    {"IMA ADPCM", SF_FORMAT_IMA_ADPCM, 0.013, 64},
    {"MS ADPCM", SF_FORMAT_MS_ADPCM, 0.007},
};

class WavFiles : public testing::Test {
 protected:
  // Written by libsndfile; false where it has no such combination.
  bool write(int format, int channels) const {
    SF_INFO info{};
    info.samplerate = kRate, info.channels = channels, info.format = format;
    if (!sf_format_check(&info)) return false;
    SNDFILE* file = sf_open((folder_.path() / "a.wav").c_str(), SFM_WRITE, &info);
    EXPECT_NE(file, nullptr);
    const std::vector<double> samples = sines(channels);
    EXPECT_EQ(sf_writef_double(file, samples.data(), kFrames), kFrames);
    sf_close(file);
    return true;
  }

  std::string refusal(const std::string& content) const {
    return test::refusalOf<core::DataError>([&] { readWav(folder_.write("a.wav", content)); });
  }

  test::TemporaryFolder folder_;
};

// Every encoding in every container with both counts of channels gives the samples that were written: none is
// silent, shifted, scaled or cut short.
TEST_F(WavFiles, everyEncodingGivesTheSamplesThatWereWritten) {
  int read = 0;
  for (const int container : {SF_FORMAT_WAV, SF_FORMAT_WAVEX, SF_FORMAT_RF64}) {
    for (const Encoding& encoding : kEncodings) {
      for (const int channels : {1, 2}) {
        if (!write(container | encoding.format, channels)) continue;
        SCOPED_TRACE(std::string(encoding.name) + ", container " + std::to_string(container >> 16) + ", " +
                     std::to_string(channels) + " channels");
        const Sound sound = readWav(folder_.path() / "a.wav");
        EXPECT_EQ(sound.sampleRate, kRate);
        EXPECT_EQ(sound.channels, channels);
        const std::vector<double> written = sines(channels);
        ASSERT_GE(sound.samples.size(), written.size());
        double worst = 0;
        for (auto i = static_cast<std::size_t>(encoding.settled * channels); i < written.size(); ++i) {
          worst = std::max(worst, std::abs(sound.samples[i] / 32768.0 - written[i]));
        }
        EXPECT_LT(worst, encoding.tolerance);
        // The last block of ADPCM is filled up, and libsndfile's fact chunk may count that in.
        const bool isAdpcm = encoding.format == SF_FORMAT_IMA_ADPCM || encoding.format == SF_FORMAT_MS_ADPCM;
        EXPECT_LE(sound.samples.size(), written.size() + (isAdpcm ? 256 : 0));
        ++read;
      }
    }
  }
  EXPECT_GE(read, 2 * (10 + 8 + 8));
}

// 1.0 and beyond is the loudest sample, not a wrapped one.
TEST_F(WavFiles, loudFloatsAreClipped) {
  SF_INFO info{};
  info.samplerate = kRate, info.channels = 1, info.format = SF_FORMAT_WAV | SF_FORMAT_FLOAT;
  SNDFILE* file = sf_open((folder_.path() / "a.wav").c_str(), SFM_WRITE, &info);
  const float samples[] = {0, 0.25f, 1, 2, -1, -2, -1 / 32768.0f};
  sf_writef_float(file, samples, 7);
  sf_close(file);
  EXPECT_EQ(readWav(folder_.path() / "a.wav").samples,
            (std::vector<std::int16_t>{0, 8192, 32767, 32767, -32768, -32768, -1}));
}

// Files that are good or wrong in one way: read whole, or refused in one line. tests/corpus/make_corpus.py.
TEST_F(WavFiles, theCorpusIsReadOrRefused) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kCorpus)) {
    const std::string name = entry.path().filename().string();
    const std::string line = test::refusalOf<core::DataError>([&] { readWav(entry.path()); });
    EXPECT_EQ(line.empty(), name.starts_with("good")) << name << ": " << line;
    if (!line.empty()) {
      EXPECT_TRUE(test::isOneLineAbout(line, name)) << line;
    }
    ++files;
  }
  EXPECT_GE(files, 50);
}

// The line gives the true reason.
TEST_F(WavFiles, refusalsGiveTheirReason) {
  for (const auto& [name, reason] : {std::pair{"badBigEndian", "big-endian"},
                                     {"badAiff", "not a WAV file"},
                                     {"badLongData", "data chunk: says 5000 bytes"},
                                     {"badLongDataExtensible", "data chunk: says 5000 bytes"},
                                     {"badLongDataRf64", "data chunk: says 5000 bytes"},
                                     {"badTruncated", "truncated"},
                                     {"badTruncatedRf64", "truncated"},
                                     {"badTwoDatas", "data chunk: there are two"},
                                     {"badNoChannel", "0 channels"},
                                     {"badHighRate", "sample rate 4294967295 Hz"},
                                     {"badNotANumber", "sample 7: is not finite"},
                                     {"badMp3", "MP3 is not read"},
                                     {"badGsm", "GSM 6.10 is not read"},
                                     {"badRf64WithoutSizes", "ds64 chunk: is missing"},
                                     {"badEmptyData", "has no samples"}}) {
    const std::string line =
        test::refusalOf<core::DataError>([&] { readWav(kCorpus / (std::string(name) + ".wav")); });
    EXPECT_NE(line.find(reason), std::string::npos) << name << ": " << line;
  }
}

// Damaged copies of every good file: whole samples that the size of the file allows, or one line.
TEST_F(WavFiles, damagedFilesAreReadOrRefusedWithinBounds) {
  for (const auto& entry : std::filesystem::directory_iterator(kCorpus)) {
    if (!entry.path().filename().string().starts_with("good")) continue;
    test::forEachMutant(core::readTextFile(entry.path()), 60, [&](const std::string& bytes) {
      try {
        const Sound sound = readWav(test::writePlainly(folder_.path() / "a.wav", bytes));
        ASSERT_TRUE(sound.channels == 1 || sound.channels == 2);
        ASSERT_EQ(sound.samples.size() % static_cast<std::size_t>(sound.channels), 0u);
        ASSERT_LE(sound.samples.size(), 2 * bytes.size());  // ADPCM: two samples a byte
        ASSERT_GT(sound.samples.size(), 0u);
      } catch (const core::DataError& error) {
        ASSERT_TRUE(test::isOneLineAbout(error.what(), "a.wav")) << error.what();
      }
    });
  }
}

// A header that promises 4 GiB costs no more than the file that holds it.
TEST_F(WavFiles, sizesThatLieCostNothing) {
  const test::Cost cost = test::costOf(
      [&] {
        for (const char* name : {"badUnknownData", "badLongDataRf64", "badTruncated", "badHighRate"}) {
          test::refusalOf<core::DataError>([&] { readWav(kCorpus / (std::string(name) + ".wav")); });
        }
        return true;
      },
      10);
  EXPECT_TRUE(cost.isDone);
  EXPECT_LT(cost.moreMiB, 64);
}

}  // namespace
}  // namespace skydrop::audio
