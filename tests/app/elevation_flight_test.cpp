// Flights over elevation data.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "app/session/run_config.h"
#include "app/session/simulation.h"
#include "app/window/file_watch.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/game/contact.h"
#include "support/elevation_files.h"
#include "support/paths.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

class ElevationFlight : public ::testing::Test {
 protected:
  // Hills of 10 km around LV95 2605000, 1205000, between 900 and 1500 m.
  std::filesystem::path write(double rise = 0) {
    const auto file = folder_.path() / "hills.tif";
    test::writeGeoTiff(file, 500, 500, {2600000, 1210000}, {20, 20},
                       test::heightsOf(500, 500,
                                       [&](double c, double r) {
                                         return 1200 + rise + 200 * std::sin(c / 20) + 100 * std::cos(r / 15);
                                       }),
                       {.tileSide = 128});
    return file;
  }
  CommandLine lineOf(const std::filesystem::path& file) {
    CommandLine line;
    line.verb = Verb::simulate;
    line.scene = "terrain";
    line.elevationFiles = {file};
    line.autopilot = true;
    return line;
  }
  std::uint64_t fly(const CommandLine& line, int steps = 600) {
    const auto run = prepareRun(line);
    Simulation simulation(run->setup, run->settings, run->table);
    for (int i = 0; i < steps && !simulation.finished(); ++i) simulation.step({});
    simulation.endRecording();
    EXPECT_FALSE(simulation.hasDiverged());
    return simulation.world().stateHash();
  }

  test::TemporaryFolder folder_;
};

TEST_F(ElevationFlight, beginsAboveTheMiddleOfTheDataAndItsSkyIsThere) {
  const auto run = prepareRun(lineOf(write()));
  EXPECT_NEAR(run->settings.elevation.latitude, 46.996, 0.001);
  EXPECT_NEAR(run->settings.elevation.longitude, 7.504, 0.001);
  EXPECT_EQ(run->settings.render.sun.latitudeDegrees, run->settings.elevation.latitude);
  const Simulation simulation(run->setup, run->settings, run->table);
  const game::Snapshot& now = simulation.world().now();
  const double ground = simulation.ground()->height({now.aircraft.position.x, now.aircraft.position.z});
  EXPECT_GT(ground, 850);
  EXPECT_GT(now.aircraft.position.y, ground);
}

TEST_F(ElevationFlight, aSkyThatIsAskedForStays) {
  CommandLine line = lineOf(write());
  line.set = {"render.sun.latitudeDegrees=-33"};
  EXPECT_EQ(prepareRun(line)->settings.render.sun.latitudeDegrees, -33);
}

TEST_F(ElevationFlight, autopilotAndTargetsKeepToTheLand) {
  // Two minutes over hills 1 km above the sea: never below ground, and targets lie on it.
  const auto run = prepareRun(lineOf(write()));
  Simulation simulation(run->setup, run->settings, run->table);
  for (int i = 0; i < 120 * 120; ++i) {
    simulation.step({});
    if (i % 60 != 0) continue;
    const game::Snapshot& now = simulation.world().now();
    const glm::dvec3& at = now.aircraft.position;
    ASSERT_GT(at.y, simulation.ground()->height({at.x, at.z}) - 0.01) << i;
    const glm::dvec3& target = now.target.position;
    ASSERT_NEAR(target.y, game::surfaceAt(*simulation.ground(), {target.x, target.z}).height, 1) << i;
  }
}

TEST_F(ElevationFlight, aReplayNeedsTheSameFilesAndThenRepeatsEveryBit) {
  const auto file = write();
  CommandLine line = lineOf(file);
  line.record = folder_.path() / "flight.log";
  const std::uint64_t flown = fly(line);
  CommandLine replay;
  replay.verb = Verb::simulate;
  replay.replay = line.record;
  EXPECT_EQ(fly(replay), flown) << "the file is found where it was";
  write(1);
  const std::string changed = test::refusalOf<core::DataError>([&] { prepareRun(replay); });
  EXPECT_TRUE(test::isOneLineAbout(changed, "hills.tif")) << changed;
  EXPECT_NE(changed.find("had another content"), std::string::npos) << changed;
}

TEST_F(ElevationFlight, sceneFilesNameThem) {
  write();
  const auto prepare = [&](const std::string& members) {
    CommandLine line;
    line.verb = Verb::simulate;
    line.scene = folder_.write("scene.json", R"({"schema": 1, "effects": ["terrain"], )" + members + "}");
    return prepareRun(line);
  };
  EXPECT_EQ(prepare(R"("elevationFile": "hills.tif")")->setup.land.elevation.size(), 1u);
  const auto refusal = [&](const std::string& members) {
    return test::refusalOf<core::DataError>([&] { prepare(members); });
  };
  EXPECT_NE(refusal(R"("elevationFile": "none.tif")").find("none.tif"), std::string::npos);
  EXPECT_NE(refusal(R"("effects": [], "elevationFile": "hills.tif")"), "");
}

TEST_F(ElevationFlight, aSceneThatIsWrittenAnewBringsItsLandAndADamagedOneChangesNothing) {
  write();
  const auto other = folder_.path() / "other.tif";
  test::writeGeoTiff(other, 100, 100, {2640000, 1250000}, {20, 20},
                     test::heightsOf(100, 100, [](double, double) { return 700.0; }));
  folder_.write("damaged.tif", core::readTextFile(other).substr(0, 300));
  const auto name = [&](const std::string& members) {
    return folder_.write("scene.json", R"({"schema": 1, "effects": ["terrain"])" + members + "}");
  };
  CommandLine line;
  line.verb = Verb::simulate;
  line.scene = name(R"(, "elevationFile": "hills.tif")");
  const auto run = prepareRun(line);
  const double before = run->settings.elevation.latitude;
  name(R"(, "elevationFile": "other.tif")");
  reloadScene(*run, line);
  ASSERT_EQ(run->setup.land.elevation.size(), 1u);
  EXPECT_NE(run->setup.land.elevation[0]->name().find("other.tif"), std::string::npos);
  EXPECT_GT(run->settings.elevation.latitude, before + 0.3);
  EXPECT_EQ(run->settings.render.sun.latitudeDegrees, run->settings.elevation.latitude);
  const Settings kept = run->settings;
  const auto land = run->setup.land.elevation[0];
  for (const char* file : {"damaged.tif", "none.tif"}) {
    name(std::string(R"(, "elevationFile": ")") + file + '"');
    const std::string refusal = test::refusalOf<core::DataError>([&] { reloadScene(*run, line); });
    EXPECT_TRUE(test::isOneLineAbout(refusal, file)) << refusal;
    EXPECT_EQ(run->setup.land.elevation[0], land) << "the last good land stays";
    EXPECT_EQ(run->settings.elevation, kept.elevation);
  }
  name("");
  reloadScene(*run, line);
  EXPECT_TRUE(run->setup.land.elevation.empty());
}

TEST_F(ElevationFlight, aFileThatIsWrittenAnewBringsItsLandAndADamagedOneChangesNothing) {
  const auto file = write();
  const CommandLine line = lineOf(file);
  const auto run = prepareRun(line);
  const auto land = run->setup.land.elevation[0];
  const Settings kept = run->settings;
  folder_.write("hills.tif", core::readTextFile(file).substr(0, 300));
  const std::string refusal = test::refusalOf<core::DataError>([&] { reloadLand(*run, line); });
  EXPECT_TRUE(test::isOneLineAbout(refusal, "hills.tif")) << refusal;
  ASSERT_EQ(run->setup.land.elevation.size(), 1u);
  EXPECT_EQ(run->setup.land.elevation[0], land) << "the last good land stays";
  EXPECT_EQ(run->settings.elevation, kept.elevation);
  // Elsewhere: the world's origin and its sky go along.
  test::writeGeoTiff(file, 100, 100, {2640000, 1250000}, {20, 20},
                     test::heightsOf(100, 100, [](double, double) { return 700.0; }));
  const SettingsChange change = reloadLand(*run, line);
  EXPECT_TRUE(change.touches("elevation.latitude"));
  EXPECT_NE(run->setup.land.elevation[0], land);
  EXPECT_GT(run->settings.elevation.latitude, kept.elevation.latitude + 0.3);
  EXPECT_EQ(run->settings.render.sun.latitudeDegrees, run->settings.elevation.latitude);
}

TEST_F(ElevationFlight, filesAreReadAgainWhenTheyHaveBeenWritten) {
  // Not while they are written; also where what is written lies beside them.
  const auto file = write();
  FilesWatch watch(filesOfLand(lineOf(file), {}));
  const auto now = std::filesystem::last_write_time(file);
  EXPECT_FALSE(watch.wereWritten());
  for (int i = 1; i < 4; ++i) {
    std::filesystem::last_write_time(file, now + std::chrono::seconds(i));
    EXPECT_FALSE(watch.wereWritten()) << "it may be half written";
  }
  EXPECT_TRUE(watch.wereWritten());
  EXPECT_FALSE(watch.wereWritten());
  folder_.write("hills.prj", "EPSG:2056");
  EXPECT_FALSE(watch.wereWritten());
  EXPECT_TRUE(watch.wereWritten());
  std::filesystem::remove(file);
  EXPECT_FALSE(watch.wereWritten());
  EXPECT_FALSE(watch.wereWritten()) << "what was taken away cannot be read";
}

TEST_F(ElevationFlight, anImageAloneLiesOnTheEndlessLandOfItsPlace) {
  std::filesystem::copy_file(test::sourceDir() + "/tests/corpus/aerial/goodStrips.tif",
                             folder_.path() / "image.tif");
  CommandLine line;
  line.verb = Verb::simulate;
  line.scene =
      folder_.write("scene.json", R"({"schema": 1, "effects": ["terrain"], "imageFile": "image.tif"})");
  const auto run = prepareRun(line);
  ASSERT_EQ(run->setup.land.images.size(), 1u);
  EXPECT_TRUE(run->setup.land.elevation.empty());
  EXPECT_NEAR(run->settings.elevation.latitude, 46.951, 0.001);
  line.scene = folder_.write("bad.json", R"({"schema": 1, "effects": [], "imageFile": "image.tif"})");
  EXPECT_NE(test::refusalOf<core::DataError>([&] { prepareRun(line); }), "");
}

TEST_F(ElevationFlight, dataFarFromThePlaceAreRefused) {
  CommandLine line = lineOf(write());
  line.set = {"elevation.atCentre=false", "elevation.latitude=-30"};
  const std::string refusal = test::refusalOf<core::DataError>([&] { fly(line, 1); });
  EXPECT_NE(refusal.find("500 km"), std::string::npos) << refusal;
}

}  // namespace
}  // namespace skydrop::app
