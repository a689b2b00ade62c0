#include "window/flown_game.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "support/paths.h"
#include "support/shared_noise.h"

namespace skydrop::test {
namespace {

constexpr auto kPatience = std::chrono::seconds(60);  // a software renderer on a busy machine
constexpr auto kPollPeriod = std::chrono::milliseconds(20);

bool waitUntil(const std::function<bool()>& condition) {
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(kPollPeriod);
  }
  return true;
}

std::set<std::filesystem::path> filesIn(const std::filesystem::path& folder) {
  std::set<std::filesystem::path> files;
  if (!std::filesystem::exists(folder)) return files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".png") files.insert(entry.path());
  }
  return files;
}

}  // namespace

FlownGame::FlownGame(Launch launch)
    : userFolder_(launch.userFolder.empty() ? folder_.path() / "user" : launch.userFolder) {
  if (!launch.userSettings.empty()) {
    std::filesystem::create_directories(userFolder());
    std::ofstream(userFolder() / "settings.json") << launch.userSettings;
  }
  const std::string log = (folder_.path() / "log").string();
  display_ = std::make_unique<VirtualDisplay>(kDisplayWidth, kDisplayHeight, log);
  if (!launch.keyboard.empty()) display_->setKeyboard(launch.keyboard);
  std::vector<std::string> words = {test::programFile(), "--stats", (folder_.path() / "stats.json").string(),
                                    "--user-dir", userFolder().string()};
  if (launch.sized)
    words.insert(words.end(), {"--size", std::to_string(kWidth) + "x" + std::to_string(kHeight)});
  const auto has = [&](const char* word) {
    return std::ranges::find(launch.words, word) != launch.words.end();
  };
  if (!has("--scene") && !has("--replay")) words.insert(words.end(), {"--scene", "terrain"});
  words.insert(words.end(), launch.words.begin(), launch.words.end());
  std::vector<std::string> environment = {"DISPLAY=" + display_->name(), "WAYLAND_DISPLAY",
                                          "LIBGL_ALWAYS_SOFTWARE=1",
                                          "XDG_CACHE_HOME=" + sharedCacheHome().string()};
  environment.insert(environment.end(), launch.environment.begin(), launch.environment.end());
  process_ = std::make_unique<BackgroundProcess>(words, environment, log);
  if (!waitFor([](const nlohmann::json&) { return true; }))
    throw std::runtime_error("it does not draw: " + this->log());
  window_ = display_->xdotool({"search", "--name", "^Skydrop$"});
  focus();
}

nlohmann::json FlownGame::statistics() const {
  std::ifstream file(folder_.path() / "stats.json");
  return file ? nlohmann::json::parse(file, nullptr, false) : nlohmann::json();
}

bool FlownGame::waitFor(const Condition& condition) {
  return waitUntil([&] {
           const nlohmann::json now = statistics();
           return (now.is_object() && now.contains("window") && condition(now)) || !process_->isRunning();
         }) &&
         process_->isRunning();
}

void FlownGame::focus() const { display_->xdotool({"windowfocus", "--sync", window_}); }
void FlownGame::press(const std::string& key) const { display_->xdotool({"key", "--delay", "0", key}); }
void FlownGame::type(const std::string& text) const { display_->xdotool({"type", "--delay", "0", text}); }
void FlownGame::hold(const std::string& key) const { display_->xdotool({"keydown", key}); }
void FlownGame::release(const std::string& key) const { display_->xdotool({"keyup", key}); }

void FlownGame::moveMouse(float x, float y) const {
  display_->xdotool({"mousemove", "--window", window_, std::to_string(static_cast<int>(x)),
                     std::to_string(static_cast<int>(y))});
}

void FlownGame::clickMouse(const std::string& action) const { display_->xdotool({action, "1"}); }

void FlownGame::resize(int width, int height) const {
  display_->xdotool({"windowsize", window_, std::to_string(width), std::to_string(height)});
}

void FlownGame::loseFocus() const {
  // Without a window manager no other window takes the focus: the root window does.
  const std::string root = display_->xdotool({"search", "--maxdepth", "0", "--name", ".*"});
  display_->xdotool({"windowfocus", root.substr(0, root.find('\n'))});
}

core::Image FlownGame::screenshot() {
  const std::filesystem::path folder = userFolder() / "screenshots";
  const auto before = filesIn(folder);
  press("F12");
  std::filesystem::path found;
  const bool saved = waitUntil([&] {
    for (const auto& file : filesIn(folder)) {
      if (!before.contains(file)) found = file;
    }
    return !found.empty();
  });
  if (!saved) throw std::runtime_error("no screenshot: " + log());
  return core::readPng(found);
}

core::Image FlownGame::shown() const { return display_->picture(window_); }

bool FlownGame::waitForPicture(const std::function<bool(const core::Image&)>& condition) {
  return waitUntil([&] { return !process_->isRunning() || condition(shown()); }) && process_->isRunning();
}

std::string FlownGame::log() const {
  std::ifstream file(folder_.path() / "log");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace skydrop::test
