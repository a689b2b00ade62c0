// What is saved outlives whatever happens while it is saved: a disk that is full, a process that is killed.
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <map>
#include <random>
#include <thread>

#include "app/measure/statistics_json.h"
#include "app/session/record_file.h"
#include "app/settings/preset_store.h"
#include "app/settings/user_settings.h"
#include "app/window/screenshots.h"
#include "app/window/window_memory.h"
#include "skydrop/clouds/noise_cache.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "support/instrumented.h"
#include "support/paths.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

namespace fs = std::filesystem;

// A limit on the size of files, which fills up as a disk does.
class FullDisk {
 public:
  FullDisk() : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit small{16, old_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &old_);
    std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  void (*handler_)(int);
  rlimit old_{};
};

// Whatever lies in the folder, by name.
std::map<std::string, std::string> contentOf(const fs::path& folder) {
  std::map<std::string, std::string> content;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) content[entry.path().string()] = core::readTextFile(entry.path());
  }
  return content;
}

TEST(SavingFaults, aFullDiskIsOneLineAndWhatWasThereStays) {
  const test::TemporaryFolder folder;
  Settings settings;
  const core::SettingsTable table(settings);
  UserSettings user(folder.path());
  user.choose("aircraft.mass", 900);
  user.save(table, user.bindings());
  PresetStore presets(presetFolder(folder.path()));
  presets.save("mine", table, {});
  KeptFile windowFile(windowMemoryFile(folder.path()));
  saveWindowMemory({.width = 800}, {}, {}, windowFile);
  Screenshots screenshots(folder.path() / "pictures");
  const core::Image picture(64, 64);
  screenshots.save(picture, {});
  folder.write("stats.json", "{\"old\": true}\n");
  const core::TextureData noise = clouds::emptyNoise(clouds::NoiseTexture::detail);
  clouds::saveNoise(folder.path(), clouds::NoiseTexture::detail, 0, noise);
  const auto before = contentOf(folder.path());
  ASSERT_EQ(before.size(), 6u);

  settings.aircraft.rollFactor = 1.5;
  user.choose("aircraft.rollFactor", 1.5);
  core::OutputFile statistics(folder.path() / "stats.json");
  const std::vector<std::pair<std::string, std::function<void()>>> savings = {
      {"settings.json", [&] { user.save(table, user.bindings()); }},
      {"mine.json", [&] { presets.save("mine", table, {}); }},
      {"window.json", [&] { saveWindowMemory({.width = 900}, {.width = 800}, {}, windowFile); }},
      {".png", [&] { screenshots.save(picture, {}); }},
      {"stats.json", [&] { writeStatistics(statistics, {}); }},
      {folder.path().filename().string(),
       [&] { clouds::saveNoise(folder.path(), clouds::NoiseTexture::detail, 0, noise); }}};
  for (const auto& [file, save] : savings) {
    std::string line;
    {
      const FullDisk full;
      line = test::refusalOf<core::DataError>(save);
    }
    EXPECT_TRUE(test::isOneLineAbout(line, file)) << file << ": " << line;
    EXPECT_NE(line.find("File too large"), std::string::npos) << file << ": " << line;
  }
  EXPECT_EQ(contentOf(folder.path()), before);

  // And once there is room again, what was chosen is written.
  user.save(table, user.bindings());
  EXPECT_NE(core::readTextFile(userSettingsFile(folder.path())).find("rollFactor"), std::string::npos);
}

TEST(SavingFaults, aRecordOnAFullDiskKeepsItsWholeLinesAndSaysWhyItStopped) {
  const test::TemporaryFolder folder;
  RecordFile record(folder.path() / "a.log", RecordFile::Existing::refused);
  record.append("first line\n");
  {
    const FullDisk full;
    record.append("a line that there is no room for\n");
  }
  EXPECT_TRUE(record.isStopped());
  EXPECT_TRUE(test::isOneLineAbout(record.takeReason().value_or(""), "a.log"));
  EXPECT_EQ(core::readTextFile(folder.path() / "a.log"), "first line\n");
}

TEST(SavingFaults, aProcessThatIsKilledLeavesNoFileHalfWritten) {
  // 200 times, at any moment of saving; the child writes one of two contents after the other.
  const test::TemporaryFolder folder;
  const std::string program = test::binaryDir() + "/tests/hostile_child",
                    file = folder.path() / "settings.json";
  const std::string a(200000, 'a'), b(200000, 'b'), first = "as it was before\n";
  folder.write("settings.json", first);
  std::mt19937 random(5);
  int changed = 0;
  for (int i = 0; i < test::repetitions(200); ++i) {
    const std::string words[] = {"child", "saves", file};
    char* arguments[] = {const_cast<char*>(words[0].c_str()), const_cast<char*>(words[1].c_str()),
                         const_cast<char*>(words[2].c_str()), nullptr};
    pid_t child = 0;
    ASSERT_EQ(::posix_spawn(&child, program.c_str(), nullptr, nullptr, arguments, environ), 0);
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 20000));
    ::kill(child, SIGKILL);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status)) << "it ended by itself: " << status;
    const std::string content = core::readTextFile(file);
    ASSERT_TRUE(content == first || content == a || content == b) << "round " << i << ": " << content.size();
    changed += content != first;
  }
  EXPECT_GT(changed, 0) << "nothing was ever saved";
}

}  // namespace
}  // namespace skydrop::app
