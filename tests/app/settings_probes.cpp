#include "app/settings_probes.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <condition_variable>
#include <functional>
#include <glm/trigonometric.hpp>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/input/player_input.h"
#include "app/session/flown_weather.h"
#include "app/session/forecast_in_force.h"
#include "app/session/photo_seen.h"
#include "app/session/run_config.h"
#include "app/window/overlay.h"
#include "skydrop/audio/audio_manager.h"
#include "skydrop/audio/sound_scene.h"
#include "skydrop/core/hash.h"
#include "skydrop/core/image.h"
#include "skydrop/core/job_pool.h"
#include "skydrop/core/shared.h"
#include "skydrop/elevation/aerial_image.h"
#include "skydrop/elevation/elevation_height_source.h"
#include "skydrop/game/contact.h"
#include "skydrop/game/flight_assist.h"
#include "skydrop/game/world.h"
#include "skydrop/render/frame/camera.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "skydrop/terrain/endless_terrain.h"
#include "skydrop/terrain/noise_height_source.h"
#include "skydrop/terrain/strips.h"
#include "skydrop/terrain/woods.h"
#include "skydrop/weather/lightning.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

using core::StateHasher;
using game::Controls;

void add(StateHasher& h, const glm::dvec3& v) { h.add(v.x), h.add(v.y), h.add(v.z); }
void add(StateHasher& h, const glm::dquat& q) { h.add(q.x), h.add(q.y), h.add(q.z), h.add(q.w); }

// What a player can see, hear or read of a moment; not the settings themselves.
void add(StateHasher& h, const game::Snapshot& now) {
  const game::AircraftSnapshot& a = now.aircraft;
  add(h, a.position), add(h, a.orientation), add(h, a.velocity), add(h, a.angularVelocityBody);
  h.add(a.throttle), h.add(std::uint64_t{a.stallWarning}), h.add(std::uint64_t{a.stalled}), h.add(a.buffet);
  h.add(std::uint64_t{a.crashed}), h.add(a.secondsToRespawn), h.add(std::uint64_t{a.spawnCount});
  for (const game::PackageSnapshot& p : now.packages)
    add(h, p.position), add(h, p.orientation), h.add(p.parachuteOpen), h.add(std::uint64_t{p.landed});
  add(h, now.target.position), h.add(now.target.radius), h.add(now.cooldownSeconds);
  h.add(static_cast<std::uint64_t>(now.score)), h.add(static_cast<std::uint64_t>(now.drops));
  for (const game::Message& message : now.messages) h.add(message.secondsLeft);
}

const std::shared_ptr<const terrain::HeightSource>& land() {
  static const auto source = terrain::makeNoiseHeightSource(terrain::TerrainSettings(), 1);
  return source;
}

game::WorldSetup worldOf(const Settings& settings, std::shared_ptr<const terrain::HeightSource> ground,
                         double startHeight) {
  game::WorldSetup setup;
  setup.ground = std::move(ground);
  setup.start.position = {0, startHeight, 0};
  setup.wind = core::flownWind(settings.wind);
  setup.airplane = settings.aircraft;
  setup.package = settings.package;
  setup.game = settings.game;
  return setup;
}

using Flyer = std::function<Controls(const game::Snapshot&)>;

std::uint64_t flight(const game::WorldSetup& setup, double seconds, const Flyer& flyer) {
  game::World world(setup);
  StateHasher h;
  for (int step = 0; step < seconds * 120; ++step) {
    world.step(flyer(world.now()));
    if (step % 12 == 0) add(h, world.now());
  }
  return h.value();
}

// Rolls, pulls, yaws, climbs at full power, slows down into a stall, and dives; drops a package a second.
Controls manoeuvres(const game::Snapshot& now) {
  const double t = now.simulatedSeconds;
  Controls c;
  c.roll = t < 2 ? 1 : t > 6 && t < 8 ? -1 : 0;
  c.pitch = t > 2 && t < 4 ? 1 : t > 11 && t < 20 ? 0.7 : t > 23 && t < 26 ? -0.5 : 0;
  c.yaw = t > 4 && t < 6 ? 1 : 0;
  c.thrust = t > 8 && t < 11 ? 1 : 0;
  c.brake = t > 11 && t < 20 ? 1 : 0;
  c.drop = std::fmod(t, 1) > 0.5;
  return c;
}

std::uint64_t aerobatics(const Settings& settings) {
  return flight(worldOf(settings, terrain::makeFlatSource(50), 2500), 32, manoeuvres);
}

// From so high that a package falls for as long as any of its rows lets it fall fast.
std::uint64_t packages(const Settings& settings) {
  return flight(worldOf(settings, terrain::makeFlatSource(50), 2500), 32, [](const game::Snapshot& now) {
    Controls c;
    c.drop = now.simulatedSeconds > 0.5;
    return c;
  });
}

// Level for some seconds, then into the ground.
std::uint64_t crashAfter(double levelSeconds, double seconds, const Settings& settings) {
  return flight(worldOf(settings, terrain::makeFlatSource(50), 60), seconds, [&](const game::Snapshot& now) {
    Controls c;
    c.pitch = now.simulatedSeconds > levelSeconds && now.aircraft.spawnCount < 2 ? -1 : 0;
    return c;
  });
}
std::uint64_t crash(const Settings& settings) { return crashAfter(2, 15, settings); }
std::uint64_t lateCrash(const Settings& settings) { return crashAfter(34, 46, settings); }

// Low and level; drops a package as often as it can.
std::uint64_t drops(const Settings& settings) {
  return flight(worldOf(settings, terrain::makeFlatSource(50), 60), 66, [](const game::Snapshot& now) {
    Controls c;
    c.drop = std::fmod(now.simulatedSeconds, 1) > 0.5;
    return c;
  });
}

// When the first package is removed.
std::uint64_t removal(const Settings& settings) {
  game::WorldSetup setup = worldOf(settings, terrain::makeFlatSource(50), 60);
  game::World world(setup);
  Controls c;
  c.drop = true;
  for (int step = 0; step < 80 * 120; ++step) {
    world.step(c);
    for (const game::GameEvent& event : world.takeEvents())
      if (event.kind == game::GameEventKind::packageRemoved) return world.stepCount();
  }
  return 0;
}

std::uint64_t firstTargets(const Settings& settings) {
  StateHasher h;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    game::WorldSetup setup = worldOf(settings, land(), 400);
    setup.seed = seed;
    add(h, game::World(setup).now());
  }
  return h.value();
}

std::uint64_t autopilot(const Settings& settings) {
  game::Autopilot pilot(land(), settings.autopilot);
  return flight(worldOf(settings, land(), 400), 30,
                [&](const game::Snapshot& now) { return pilot.decide(now); });
}

// What ten hits of a grid earn.
std::uint64_t points(const Settings& settings) {
  StateHasher h;
  for (const double share : {0.0, 0.3, 0.7, 1.0}) {
    for (const double seconds : {5.0, 60.0, 400.0})
      h.add(static_cast<std::uint64_t>(game::pointsOf(settings.delivery, 100 * share, 100, seconds, 45)));
  }
  return h.value();
}

std::uint64_t beginnings(const Settings& settings) {
  game::WorldSetup setup = worldOf(settings, land(), 400);
  setup.delivery = settings.delivery;
  StateHasher h;
  add(h, game::World(setup).now());
  return h.value();
}

// A player who turns, and what is warned of over hills from higher and higher up.
std::uint64_t assisted(const Settings& settings) {
  game::FlightAssist assist;
  return flight(worldOf(settings, land(), 400), 20, [&](const game::Snapshot& now) {
    return assist.decide(now, {.roll = now.stepCount > 100 ? 1.0 : 0.0}, settings.assist);
  });
}

std::uint64_t warnings(const Settings& settings) {
  StateHasher h;
  if (!settings.assist.terrainWarning) return h.value();
  game::AircraftSnapshot craft;
  craft.present = true;
  craft.velocity = {68, -15, 3};
  for (double height = 5; height < 400; height += 5) {
    craft.position = {300, game::surfaceAt(*land(), {300, 0}).height + height, 0};
    const auto seconds = game::secondsToGround(*land(), craft, settings.assist.warningSeconds);
    h.add(seconds.value_or(-1));
  }
  return h.value();
}

// Hands off for ten seconds in that air.
// The nearest strips of a gentle land, and the land on them.
std::uint64_t stripHeights(const Settings& settings) {
  StateHasher h;
  const auto ground = terrain::makeLandWithStrips(land(), settings.strips, 1);
  for (int x = -4; x <= 4; ++x) {
    for (int z = -4; z <= 4; ++z) {
      const auto strip = ground->strips()->nearest({x * 6000.0, z * 6000.0}, 8000);
      h.add(std::uint64_t{strip.has_value()});
      if (!strip) continue;
      h.add(strip->middle.x), h.add(strip->halfLength), h.add(strip->halfWidth);
      h.add(ground->height(strip->world(strip->halfLength, strip->halfWidth)));
    }
  }
  return h.value();
}

// How many trees stand in some woods.
std::uint64_t standingTrees(const Settings& settings) {
  StateHasher h;
  const terrain::Woods woods(land(), settings.woods.density, false);
  h.add(std::uint64_t{woods.around({-1600, -3300}, 60).size()});
  return h.value();
}

// Packages and strips by the autopilot.
std::uint64_t circuits(const Settings& settings) {
  game::WorldSetup setup = worldOf(settings, terrain::makeFlatSource(50), 300);
  setup.ground = terrain::makeLandWithStrips(setup.ground, {.density = 1}, 1);
  setup.gear = settings.gear;
  setup.game.targetNearest = 1200, setup.game.targetFarthest = 1500, setup.game.dropCooldown = 0;
  game::Autopilot pilot(setup.ground, settings.autopilot);
  return flight(setup, 900, [&](const game::Snapshot& now) { return pilot.decide(now); });
}

// Arrivals on the ground or the sea, from gentle to hard, each for a second: over the slider of a limit some
// break and some do not.
struct Arrival {
  double slope = 0, speed = 36, diveRad = 0.03, crabRad = 0, bankRad = 0;
  bool water = false;
};
std::uint64_t arrive(const Settings& settings, const std::function<Arrival(double)>& arrival) {
  StateHasher h;
  constexpr double kDegrees = 57.29577951308232;
  for (int i = 0; i < 30; ++i) {
    const Arrival a = arrival(i / 29.0);
    game::WorldSetup setup =
        worldOf(settings, terrain::makeTiltedPlaneSource(a.water ? -50 : 50, glm::dvec2(0, -a.slope)), 2.6);
    setup.hasTargets = false;
    setup.gear = settings.gear;
    setup.start.headingDeg = kDegrees * a.crabRad;
    setup.start.pitchDeg = kDegrees * (std::atan(a.slope) - a.diveRad);
    setup.start.bankDeg = kDegrees * a.bankRad;
    setup.start.speed = a.speed;
    h.add(flight(setup, 1, [](const game::Snapshot&) { return Controls{.brake = 1}; }));
  }
  return h.value();
}
std::uint64_t sinkRates(const Settings& s) {
  return arrive(s, [](double k) { return Arrival{.diveRad = 0.01 + 0.4 * k}; });
}
std::uint64_t sideLoads(const Settings& s) {
  Settings others = s;
  others.gear.mostSinkRate = 20, others.gear.friction = 1.5, others.gear.mostStrikeSpeed = 60;
  return arrive(others, [](double k) { return Arrival{.diveRad = 0.02 + 0.1 * k, .crabRad = 1.5 * k}; });
}
std::uint64_t slopes(const Settings& s) {
  Settings others = s;
  others.gear.mostSinkRate = 20, others.gear.mostStrikeSpeed = 60;
  return arrive(others, [](double k) { return Arrival{.slope = 1.1 * k, .speed = 20, .diveRad = 0.1}; });
}
std::uint64_t wingsFirst(const Settings& s) {
  return arrive(s, [](double k) { return Arrival{.speed = 3 + 42 * k, .diveRad = 0.03, .bankRad = 0.7}; });
}
std::uint64_t waterSinks(const Settings& s) {
  return arrive(s, [](double k) { return Arrival{.diveRad = 0.01 + 0.4 * k, .water = true}; });
}
std::uint64_t waterSpeeds(const Settings& s) {
  return arrive(s, [](double k) { return Arrival{.speed = 4 + 96 * k, .diveRad = 0.02, .water = true}; });
}

// Taxi in a circle and braking; a touch-down on a meadow.
std::uint64_t taxi(const Settings& settings) {
  game::WorldSetup setup = worldOf(settings, terrain::makeFlatSource(50), 0);
  setup.hasTargets = false;
  setup.gear = settings.gear;
  setup.start.onWheels = true;
  StateHasher h;
  h.add(flight(setup, 24, [](const game::Snapshot& now) {
    const double t = now.simulatedSeconds;
    return Controls{.thrust = t < 9 ? 0.2 : 0, .brake = t > 16 ? 0.5 : 0, .yaw = t < 14 ? 1.0 : 0};
  }));
  h.add(sideLoads(settings));
  return h.value();
}

std::uint64_t floats(const Settings& settings) {
  game::WorldSetup setup = worldOf(settings, terrain::makeFlatSource(-50), 3);
  setup.hasTargets = false;
  setup.gear = settings.gear;
  setup.start.speed = 34;
  return flight(setup, 26, [](const game::Snapshot&) { return Controls{.brake = 1}; });
}

std::uint64_t weatherFlight(const Settings& settings) {
  game::WorldSetup setup = worldOf(settings, land(), 300);
  setup.weather = {settings.weather, settings.wind, nullptr};
  return flight(setup, 10, [](const game::Snapshot&) { return Controls(); });
}

// A package dropped at once, in that air.
std::uint64_t packagesInWeather(const Settings& settings) {
  game::WorldSetup setup = worldOf(settings, land(), 300);
  setup.weather = {settings.weather, settings.wind, nullptr};
  Controls drop;
  drop.drop = true;
  return flight(setup, 10, [&](const game::Snapshot&) { return drop; });
}

// What flashes there are in some minutes of a storm, and how bright they are.
std::uint64_t flashesOfAStorm(const Settings& settings) {
  auto storm = std::make_shared<weather::WeatherSettings>();
  storm->sites[0].lightning = 30;
  storm->sites[0].layers[0].cover = 1;
  core::StateHasher hash;
  for (const weather::Flash& flash :
       weather::flashesBetween({storm, 1, 0}, settings.lightning, 0, 1800, {})) {
    hash.add(flash.toGround ? 1.0 : 0.0);
    hash.add(weather::brightnessAt(flash, settings.lightning, flash.seconds + 0.1));
  }
  return hash.value();
}

// The weather at some places and times.
std::uint64_t weatherStates(const Settings& settings) {
  StateHasher h;
  for (const double seconds : {0.0, 500.0, 1700.0, 4000.0}) {
    for (const double east : {-40000.0, 0.0, 3000.0, 15000.0, 60000.0}) {
      const weather::State s = weather::stateAt(settings.weather, 1, seconds, {east, -0.4 * east});
      for (const weather::Layer& l : s.layers) {
        h.add(static_cast<std::uint64_t>(l.genus));
        h.add(l.baseM), h.add(l.topM), h.add(l.cover), h.add(l.density);
      }
      for (const weather::WindLevel& l : s.wind.levels)
        h.add(l.heightM), h.add(l.speedMps), h.add(l.directionDeg);
      for (const double value :
           {s.wind.speedMps, s.wind.directionDeg, s.wind.gustMps, s.wind.roughnessM, s.wind.gradientHeightM,
            s.fog.extinction, s.fog.topM, s.precipitation.rain, s.precipitation.snow, s.precipitation.sleet,
            s.precipitation.hail, s.visibilityM, s.temperatureC, s.pressurePa, s.lightningPerMinute,
            s.turbulenceSeverity})
        h.add(value);
    }
  }
  return h.value();
}

// A week of hours, each warmer than the one before, as the clock of the settings runs through it.
std::uint64_t forecastStates(const Settings& settings) {
  std::vector<weather::TimedState> hours(169);
  for (std::size_t i = 0; i < hours.size(); ++i) {
    hours[i].utcMs = 1782000000000 + static_cast<std::int64_t>(i) * 3600000;
    hours[i].state.wind.levels = {{{1500, 5, 0}, {5000, 5, 0}, {10000, 5, 0}}};
    hours[i].state.temperatureC = -50 + 0.5 * static_cast<double>(i);
  }
  const weather::Forecast forecast{weather::Timeline(hours), weather::Timeline(hours), std::nullopt, 1};
  core::StateHasher h;
  for (const double seconds : {0.0, 10.0, 90.0}) {
    h.add(weather::stateAt(settings.weather, forecast, forecastClock(settings, forecast), 1, seconds, {0, 0})
              .temperatureC);
  }
  return h.value();
}

// A forecast of 20 degrees that takes over from the sites, or is not followed.
std::uint64_t handedOver(const Settings& settings) {
  std::vector<weather::TimedState> hours(1);
  hours[0].utcMs = 1782000000000;
  hours[0].state.temperatureC = 20;
  hours[0].state.wind.levels = {{{1500, 5, 0}, {5000, 5, 0}, {10000, 5, 0}}};
  const auto forecast = std::make_shared<const weather::Forecast>(
      weather::Forecast{weather::Timeline(hours), weather::Timeline(hours), std::nullopt, 1});
  ForecastInForce inForce(nullptr, {});
  inForce.set(settings.live.follow ? forecast : nullptr, {}, 0, settings.live.blendSeconds);
  core::StateHasher h;
  for (int i = 1; i < 64; ++i) {
    h.add(weather::stateAt(settings.weather, inForce.forecast().get(), {}, inForce.handover().get(), 1,
                           5.0 * i, {0, 0})
              .temperatureC);
  }
  return h.value();
}

// Two sites that differ, all layers with cover.
std::vector<std::string> twoSites() {
  std::vector<std::string> given = {"weather.secondSite=true", "weather.approachSeconds=3000",
                                    "weather.sites.1.windSpeed=12", "weather.sites.1.windDirection=300"};
  for (const char* site : {"0", "1"}) {
    for (const char* layer : {"0", "1", "2", "3"})
      given.push_back(std::string("weather.sites.") + site + ".layers." + layer + ".cover=0.4");
  }
  return given;
}

// A hill of elevation data by Bern, and what is around it.
const std::string& elevationFile() {
  static const test::TemporaryFolder folder;
  static const std::string file =
      folder.write("hill.asc",
                   "ncols 4\nnrows 3\nxllcorner 2600000\nyllcorner 1199000\n"
                   "cellsize 500\n500 520 540 500\n600 900 700 560\n480 500 520 500\n");
  return file;
}

std::uint64_t elevationHeights(const Settings& settings) {
  const auto land = elevation::makeElevationHeightSource({elevation::openRaster(elevationFile())},
                                                         settings.elevation, terrain::makeFlatSource(0));
  core::StateHasher h;
  for (double x = -5000; x < 6000; x += 300) h.add(land->height({x, -x / 3}));
  return h.value();
}

std::uint64_t originPlace(const Settings& settings) {
  const elevation::GeoPlace place =
      elevation::LocalPlane({settings.elevation.latitude, settings.elevation.longitude})
          .placeOf({1000, 2000});
  core::StateHasher h;
  h.add(place.latitude);
  h.add(place.longitude);
  return h.value();
}

// An aerial image of 12 km around Bern, laid out.
std::uint64_t groundPictures(const Settings& settings) {
  static const test::TemporaryFolder folder;
  static const auto image = [] {
    core::Image picture(512, 512);
    for (std::size_t i = 0; i < picture.rgba.size(); ++i)
      picture.rgba[i] = static_cast<std::uint8_t>(i % 4 == 3 ? 255 : i / 512 % 200);
    core::writePng(folder.path() / "image.png", picture);
    return elevation::openAerialImage(folder.path() / "image.png",
                                      elevation::ImageCorners{2594000, 1194000, 2606000, 1206000});
  }();
  const terrain::GroundPicture picture =
      elevation::makeGroundPicture({image}, {46.95, 7.44}, settings.aerialImage);
  core::StateHasher h;
  for (const std::uint8_t byte : picture.levels[1].rgba) h.add(static_cast<std::uint64_t>(byte));
  return h.value();
}

// What the land wears of an image, by the formulas of the shader.
std::uint64_t wornGround(const Settings& settings) {
  namespace shared = core::shared::f64;
  const terrain::GroundPictureSettings& worn = settings.aerialImage;
  core::StateHasher h;
  for (double distance = 10; distance < 20000; distance *= 1.3) {
    const double share = shared::groundPictureShare(0.8, distance, worn.share, worn.nearShare, worn.nearM);
    h.add(shared::pictured({0.1, 0.2, 0.1}, {0.3, 0.3, 0.2}, share, worn.gain).x);
  }
  return h.value();
}

// A photograph over a picture.
std::uint64_t photographs(const Settings& settings) {
  core::Image dark(100, 2), light(100, 2);
  for (std::size_t i = 0; i < dark.rgba.size(); ++i) {
    dark.rgba[i] = static_cast<std::uint8_t>(i % 4 == 3 ? 255 : 10);
    light.rgba[i] = static_cast<std::uint8_t>(i % 4 == 3 ? 255 : 240);
  }
  core::StateHasher h;
  for (const std::uint8_t byte : together(dark, light, settings.view.photo, settings.view.photoShare).rgba)
    h.add(static_cast<std::uint64_t>(byte));
  return h.value();
}

// Where a flight over the file begins.
std::uint64_t elevationRun(const Settings& settings) {
  CommandLine line;
  line.verb = Verb::simulate;
  line.elevationFiles = {elevationFile()};
  line.set = {std::string("elevation.atCentre=") + (settings.elevation.atCentre ? "true" : "false")};
  const auto run = prepareRun(line);
  core::StateHasher h;
  h.add(run->settings.elevation.latitude);
  return h.value();
}

std::uint64_t heights(const Settings& settings) {
  const auto source = terrain::makeNoiseHeightSource(settings.terrain, 1);
  StateHasher h;
  for (int z = -20; z < 20; ++z)
    for (int x = -20; x < 20; ++x) h.add(source->height({x * 1003.0, z * 1003.0}));
  return h.value();
}

terrain::ViewVolume volume(const glm::dvec3& eye, int width, int height) {
  const double pitch = glm::radians(-10.0);
  const glm::dmat3 toView = glm::transpose(glm::dmat3(
      glm::dvec3(1, 0, 0), {0, std::cos(pitch), std::sin(pitch)}, {0, -std::sin(pitch), std::cos(pitch)}));
  return terrain::makeViewVolume(eye, toView, glm::radians(60.0), width, height);
}
terrain::ViewVolume small() { return volume({0, 900, 0}, 320, 180); }
terrain::ViewVolume large() { return volume({0, 900, 0}, 1920, 1080); }

void add(StateHasher& h, const terrain::EndlessTerrain& endless) {
  const terrain::StreamingStatistics& s = endless.statistics();
  for (const std::size_t count : {s.chunksWanted, s.chunksDrawn, s.patches, s.overBudget})
    h.add(static_cast<std::uint64_t>(count));
  for (const terrain::PatchDraw& patch : endless.frame().patches) h.add(patch.distanceM);
}

// One terrain for all, so that chunks are made once.
terrain::EndlessTerrain& sharedTerrain() {
  static core::JobPool pool(2);
  static terrain::EndlessTerrain endless(land(), pool, terrain::TerrainStreamingSettings());
  return endless;
}

// What is drawn when everything that the view wants is there.
std::uint64_t settled(const Settings& settings, const terrain::ViewVolume& view) {
  terrain::EndlessTerrain& endless = sharedTerrain();
  endless.apply(settings.streaming);
  endless.settle(view);
  StateHasher h;
  add(h, endless);
  for (const double level : endless.frame().lod.morph) h.add(level);
  return h.value();
}
std::uint64_t detail(const Settings& settings) { return settled(settings, large()); }
std::uint64_t budget(const Settings& settings) { return settled(settings, small()); }

// Above the deepest sea around.
std::uint64_t seaFloor(const Settings& settings) {
  static const glm::dvec2 deepest = [] {
    glm::dvec2 place(0);
    double lowest = 0;
    for (int z = -100; z < 100; ++z) {
      for (int x = -100; x < 100; ++x) {
        const double height = land()->height({x * 500.0, z * 500.0});
        if (height < lowest) lowest = height, place = {x * 500.0, z * 500.0};
      }
    }
    return place;
  }();
  return settled(settings, volume({deepest.x, 300, deepest.y}, 320, 180));
}

// What the first frame sends to the GPU when all chunks are there already.
std::uint64_t uploads(const Settings& settings) {
  static core::JobPool pool(2);
  static terrain::EndlessTerrain endless(land(), pool, settings.streaming);
  terrain::TerrainStreamingSettings other = settings.streaming;
  other.gpuMiB = 120;
  endless.apply(other);
  endless.settle(small());
  endless.apply(settings.streaming);  // a changed number of layers empties them all
  endless.update(small());
  return endless.statistics().uploadedBytes;
}

// What is kept of a flight over five views.
std::uint64_t kept(const Settings& settings) {
  terrain::EndlessTerrain& endless = sharedTerrain();
  endless.apply(settings.streaming);
  for (int i = 0; i < 5; ++i) endless.settle(volume({i * 50000.0, 900, 0}, 320, 180));
  return endless.statistics().bytes;
}

// Land whose making waits until the end.
class HeldUpSource final : public terrain::HeightSource {
 public:
  terrain::HeightSample sample(glm::dvec2 xz) const override { return land()->sample(xz); }
  terrain::HeightBounds bounds(glm::dvec2 lo, glm::dvec2 hi) const override { return land()->bounds(lo, hi); }
  terrain::HeightBounds range() const override { return land()->range(); }
  bool fillChunk(const terrain::ChunkKey&, std::stop_token stop, terrain::ChunkData&) const override {
    std::mutex mutex;
    std::unique_lock lock(mutex);
    std::condition_variable_any().wait(lock, stop, [] { return false; });
    return false;
  }
};

std::uint64_t waitingChunks(const Settings& settings) {
  core::JobPool pool(1);
  terrain::EndlessTerrain endless(std::make_shared<HeldUpSource>(), pool, settings.streaming);
  endless.update(small());
  return endless.statistics().queue;
}

std::uint64_t sound(const Settings& settings) {
  audio::AudioManager audio(settings.audio, audio::AudioManager::Output::loopback);
  audio::SoundScene scene(audio, settings.audio);
  game::Snapshot now;
  now.aircraft.present = true;
  now.aircraft.throttle = 0.7;
  now.aircraft.airspeedMps = 70;
  auto storm = std::make_shared<weather::WeatherSettings>();
  storm->sites[0].rain = 10;
  storm->sites[0].layers[0].cover = 1;
  now.weather = {.settings = storm};
  game::GameEvent drop;
  drop.kind = game::GameEventKind::drop;
  scene.update(now, std::array{drop});
  std::vector<float> samples(4410);
  audio.render(samples);
  StateHasher h;
  for (const float sample : samples) h.add(static_cast<double>(sample));
  return h.value();
}

std::uint64_t interface(const Settings& settings) {
  constexpr Size kSize{1920, 1080};
  scene::EffectSet effects;
  effects.insert(scene::Effect::hud);
  Overlay overlay(effects, kSize, {}, {settings.view.interfaceScale});
  overlay.hudShown = settings.view.hud;
  Settings copy = settings;
  const core::SettingsTable table(copy);
  game::Snapshot now;
  now.aircraft.present = true;
  OverlayFrame frame{now, kSize, 0, table};
  frame.scale = {settings.view.interfaceScale};
  overlay.build(frame);
  StateHasher h;
  const ImDrawData& data = *ImGui::GetDrawData();
  for (int list = 0; list < data.CmdListsCount; ++list) {
    for (const ImDrawVert& vertex : data.CmdLists[list]->VtxBuffer)
      h.add(static_cast<double>(vertex.pos.x)), h.add(static_cast<double>(vertex.pos.y));
  }
  return h.value();
}

// Dials and marks, from behind the aircraft and from its seat, with a target behind.
std::uint64_t dialsAndMarks(const Settings& settings) {
  constexpr Size kSize{1280, 720};
  scene::EffectSet effects;
  effects.insert(scene::Effect::hud);
  StateHasher h;
  for (const render::CameraMode camera : {render::CameraMode::chase, render::CameraMode::cockpit}) {
    Settings copy = settings;
    copy.view.camera = camera;
    const core::SettingsTable table(copy);
    Overlay overlay(effects, kSize, {});
    game::Snapshot now;
    now.aircraft.present = now.target.present = true;
    now.target.position = {100, 0, 5000};
    OverlayFrame frame{now, kSize, 0, table};
    frame.instruments = showsInstruments(copy.view);
    if (copy.view.marks) frame.eye = ui::Eye{{0, 100, 0}, glm::dmat3(1), 1, 1280, 720};
    overlay.build(frame);
    const ImDrawData& data = *ImGui::GetDrawData();
    h.add(static_cast<double>(data.TotalVtxCount));
  }
  return h.value();
}

// The levers after sticks and triggers were pushed a little further each time.
std::uint64_t sticks(const Settings& settings) {
  StateHasher h;
  PlayerInput input;
  for (int i = 0; i <= 40; ++i) {
    GamepadState state;
    const float push = -1 + 0.05f * static_cast<float>(i);
    state.axes = {push, -0.7f * push, 0.6f * push, 0.3f, push, 0.5f * push};
    input.handle(readingOf(state, settings.input.gamepad), settings.input.gamepad);
    const Controls c = input.step();
    for (const double lever : {c.thrust, c.brake, c.pitch, c.roll, c.yaw}) h.add(lever);
  }
  return h.value();
}

// From where a turning, stalled aircraft is seen close above land, by each camera; which one, by the row's
// own camera.
render::View seenBy(render::CameraMode mode, const Settings& settings) {
  game::Snapshot now;
  now.aircraft.present = true;
  now.aircraft.position = {0, 6, 0};
  now.aircraft.orientation = glm::dquat(glm::dvec3(0.2, 0.4, 0.6));
  now.aircraft.trailingOrientation = glm::dquat(glm::dvec3(0.1, 0.1, 0.2));
  now.aircraft.buffet = 0.7;
  now.simulatedSeconds = 1.23;
  render::Camera camera;
  camera.setMode(mode);
  static const auto flat = terrain::makeFlatSource(2);
  return camera.view(now, settings.render.camera, 640, 360, flat.get());
}

std::uint64_t cameras(const Settings& settings) {
  StateHasher h;
  for (const auto mode : {settings.view.camera, render::CameraMode::chase, render::CameraMode::cockpit}) {
    const render::View view = seenBy(mode, settings);
    add(h, view.position), add(h, view.forward()), add(h, view.up());
    h.add(view.fovYRad), h.add(view.nearM);
  }
  return h.value();
}

// All rows but these two, as `render` would have them.
std::uint64_t preparedRows(const Settings& settings) {
  CommandLine line;
  line.verb = Verb::render;
  line.set = {
      "quality=" + std::string(kQualityNames[static_cast<std::size_t>(settings.quality)]),
      "clouds.tier=" + std::string(clouds::kCloudTierNames[static_cast<std::size_t>(settings.clouds.tier)])};
  if (settings.quality != Quality::automatic) line.set.pop_back();
  StateHasher h;
  const auto run = prepareRun(line);
  for (const core::Field& field : run->table.fields())
    if (field.path != "quality" && field.path != "clouds.tier") h.add(field.get());
  return h.value();
}

}  // namespace

const std::vector<Probe>& settingsProbes() {
  static const std::vector<Probe> kProbes = {
      {"aircraft.", aerobatics},
      {"package.", packages},
      {"wind.", aerobatics, {"wind.movesAircraft=true"}},
      {"game.target", firstTargets},
      {"game.dropCooldown", drops},
      {"game.landedPackageSeconds", removal},
      {"game.respawnBackSeconds", lateCrash, {"game.crashSeconds=0.1"}},
      {"game.", crash},
      {"weather.standardAtmosphere", weatherFlight},
      {"weather.turbulence", weatherFlight},
      {"weather.draughts", weatherFlight, {"weather.sites.0.layers.0.cover=0.6"}},
      {"weather.slopeWind", weatherFlight},
      {"weather.icing", weatherFlight, {"weather.sites.0.temperature=-10", "weather.sites.0.rain=10"}},
      {"weather.packageGusts", packagesInWeather},
      {"weather.", weatherStates, twoSites()},
      {"weatherFile.followsSky", forecastStates, {"sky.sun=clock"}},
      {"weatherFile.", forecastStates, {"weatherFile.followsSky=false"}},
      {"live.follow", handedOver},
      {"live.blendSeconds", handedOver},
      {"lightning.", flashesOfAStorm},
      {"delivery.startFacesTarget", beginnings},
      {"delivery.", points},
      {"assist.terrainWarning", warnings},
      {"assist.warningSeconds", warnings},
      {"assist.", assisted},
      {"autopilot.landEvery", circuits},
      {"strips.", stripHeights, {"strips.density=0.5"}},
      {"woods.density", standingTrees},
      {"gear.mostSinkRate", sinkRates},
      {"gear.mostSideLoad", sideLoads},
      {"gear.mostSlopeDeg", slopes},
      {"gear.mostStrikeSpeed", wingsFirst},
      {"gear.mostWaterSink", waterSinks},
      {"gear.mostWaterSpeed", waterSpeeds},
      {"gear.floatSeconds", floats},
      {"gear.", taxi},
      {"autopilot.", autopilot, {"game.targetNearest=1200", "game.targetFarthest=1500"}},
      {"terrain.", heights},
      {"aerialImage.edgeM", groundPictures},
      {"aerialImage.share", wornGround},
      {"aerialImage.near", wornGround},
      {"aerialImage.gain", wornGround},
      {"view.photo", photographs},
      {"elevation.atCentre", elevationRun},
      {"elevation.blendM", elevationHeights},
      {"elevation.", originPlace},
      {"streaming.uploadMiBPerFrame", uploads},
      {"streaming.queueLimit", waitingChunks, {"streaming.texelPixels=0.5"}},
      {"streaming.cacheMiB", kept, {"streaming.gpuMiB=128", "streaming.texelPixels=0.5"}},
      {"streaming.gpuMiB", budget, {"streaming.texelPixels=0.5"}},
      {"streaming.seaFloorDepthM", seaFloor},
      {"streaming.viewDistanceM", detail},
      {"streaming.pixelError", detail, {"streaming.cellPixels=200"}},
      {"streaming.cellPixels", detail, {"streaming.pixelError=20", "streaming.texelPixels=0.5"}},
      {"streaming.texelPixels", detail, {"streaming.cacheMiB=1024", "streaming.gpuMiB=128"}},
      {"audio.", sound},
      {"view.hud", interface},
      {"view.instruments", dialsAndMarks},
      {"view.marks", dialsAndMarks},
      {"view.interfaceScale", interface},
      {"input.", sticks},
      {"render.camera.", cameras},
      {"view.camera", cameras},
      {"quality", preparedRows},
      {"clouds.tier", preparedRows},
  };
  return kProbes;
}

}  // namespace skydrop::app
