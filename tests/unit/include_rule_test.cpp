// The direction of the arrows between modules, and between the rooms of a module that has some, read from the
// sources themselves.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "support/paths.h"

namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

// Whom a module may include, besides itself: what the one below it may, and a little more.
std::map<std::string, Names> allowedIncludes() {
  const Names core = {"core"};
  Names scene = core;
  scene.insert({"terrain", "noise", "clouds", "flight", "sky", "weather"});
  Names game = scene;
  game.insert("scene");
  Names outer = game;
  outer.insert("game");
  Names app = outer;
  app.insert({"render", "audio", "ui", "accuracy", "forecast", "lab", "elevation", "stability"});
  Names render = outer;
  render.insert("lab");
  const Names forecast = {"core", "sky", "weather"};
  const Names elevation = {"core", "terrain"};
  const Names stability = {"core", "terrain", "flight", "sky", "weather"};
  return {{"core", {}},
          {"terrain", core},
          {"noise", core},
          {"clouds", core},
          {"accuracy", core},
          {"lab", core},
          {"flight", core},
          {"sky", core},
          {"weather", core},
          {"scene", scene},
          {"game", game},
          {"render", render},
          {"audio", outer},
          {"ui", outer},
          {"app", app},
          {"forecast", forecast},
          {"elevation", elevation},
          {"stability", stability}};
}

// The same for rooms, the folders of a module.
std::map<std::string, std::map<std::string, Names>> allowedRooms() {
  const Names base = {"types", "console", "measure"};
  Names settings = base;
  settings.insert("input");
  Names session = settings;
  session.insert("settings");
  Names outer = session;
  outer.insert("session");
  Names studies = outer;  // they draw what a window does, its interface included
  studies.insert("window");
  Names cli = studies;
  cli.insert("studies");
  const Names effect = {"gl", "frame"};
  Names shadows = effect;
  shadows.insert("models");
  Names clouds = effect;
  clouds.insert("shadows");
  Names terrain = shadows;
  terrain.insert({"shadows", "clouds"});
  return {{"app",
           {{"types", {}},
            {"console", {"types"}},
            {"measure", {"types", "console"}},
            {"input", base},
            {"settings", settings},
            {"session", session},
            {"window", outer},
            {"studies", studies},
            {"cli", cli}}},
          {"render",
           {{"gl", {}},
            {"platform", {"gl"}},
            {"frame", {"gl"}},
            {"sky", effect},
            {"noise", {"gl"}},
            {"lab", {"gl"}},
            {"clouds", clouds},
            {"edges", effect},
            {"fog", effect},
            {"models", effect},
            {"overlay", effect},
            {"shadows", shadows},
            {"shafts", terrain},
            {"precipitation", terrain},
            {"lightning", effect},
            {"vegetation", terrain},
            {"places", terrain},
            {"ground_cover", terrain},
            {"water", effect},
            {"spray", effect},
            {"terrain", terrain}}}};
}

struct Include {
  fs::path file;
  std::string from, what;
};

// Every include in a module's sources and contract.
std::vector<Include> includesOf(const std::string& module) {
  std::vector<Include> includes;
  const fs::path root = skydrop::test::sourceDir();
  const std::regex line(R"re(^\s*#\s*include\s*["<]([^">]+)[">])re");
  for (const fs::path& folder : {root / "include/skydrop" / module, root / "src" / module}) {
    if (!fs::exists(folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (!entry.is_regular_file()) continue;
      std::ifstream stream(entry.path());
      for (std::string text; std::getline(stream, text);) {
        std::smatch match;
        if (std::regex_search(text, match, line)) includes.push_back({entry.path(), module, match[1]});
      }
    }
  }
  return includes;
}

TEST(IncludeRule, arrowsBetweenModulesPointOneWay) {
  // A module includes the contracts of the modules below it, and the private headers of none but itself.
  const auto allowed = allowedIncludes();
  std::size_t seen = 0;
  for (const auto& [module, names] : allowed) {
    for (const Include& include : includesOf(module)) {
      const fs::path path = include.what;
      std::vector<std::string> parts;
      for (const auto& part : path) parts.push_back(part.string());
      if (parts.size() >= 3 && parts[0] == "skydrop") {
        ++seen;
        EXPECT_TRUE(parts[1] == module || names.contains(parts[1]))
            << include.file << " includes " << include.what;
      } else if (parts.size() >= 2 && allowed.contains(parts[0])) {
        EXPECT_EQ(parts[0], module) << include.file << " includes a private header: " << include.what;
      }
    }
  }
  EXPECT_GT(seen, 5u) << "the sources were not found";
}

// The folder that comes after the module's in a path, empty where a file follows.
std::string roomOf(const fs::path& path, const std::string& module) {
  for (auto part = path.begin(); part != path.end(); ++part) {
    if (*part != module) continue;
    const auto room = std::next(part);
    if (room != path.end() && std::next(room) != path.end()) return room->string();
  }
  return {};
}

TEST(IncludeRule, arrowsBetweenRoomsPointOneWay) {
  const fs::path root = skydrop::test::sourceDir();
  for (const auto& [module, rooms] : allowedRooms()) {
    std::size_t seen = 0;
    for (const Include& include : includesOf(module)) {
      const std::string from = roomOf(fs::relative(include.file, root), module);
      EXPECT_TRUE(rooms.contains(from)) << include.file << " is in no room";
      const std::string& what = include.what;
      if (!what.starts_with(module + "/") && !what.starts_with("skydrop/" + module + "/")) continue;
      const std::string to = roomOf(what, module);
      ++seen;
      EXPECT_TRUE(from == to || (rooms.contains(from) && rooms.at(from).contains(to)))
          << include.file << " includes " << what;
    }
    EXPECT_GT(seen, 50u) << "the sources were not found";
  }
}

TEST(IncludeRule, onlyRenderNamesOpenGL) {
  // OpenGL, EGL and GLFW headers are included in render; app's window code may name GLFW.
  const std::regex graphics(R"(^(GL|EGL|GLES\d?)/|glcorearb)");
  for (const auto& [module, names] : allowedIncludes()) {
    for (const Include& include : includesOf(module)) {
      if (module != "render") {
        EXPECT_FALSE(std::regex_search(include.what, graphics))
            << include.file << " includes " << include.what;
      }
      if (module != "render" && module != "app") {
        EXPECT_FALSE(include.what.starts_with("GLFW/")) << include.file << " includes " << include.what;
      }
    }
  }
}

TEST(IncludeRule, everyModuleFolderIsInTheRule) {
  // A new module must be given its place among the arrows.
  const auto allowed = allowedIncludes();
  for (const char* folder : {"src", "include/skydrop"}) {
    for (const auto& entry : fs::directory_iterator(fs::path(skydrop::test::sourceDir()) / folder)) {
      if (entry.is_directory()) {
        EXPECT_TRUE(allowed.contains(entry.path().filename().string())) << entry.path();
      }
    }
  }
}

}  // namespace
