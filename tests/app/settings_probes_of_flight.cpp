// What flights make of their rows.
#include <algorithm>
#include <array>
#include <functional>
#include <stdexcept>

#include "app/session/flown_weather.h"
#include "app/settings_probe_parts.h"
#include "skydrop/game/autopilot.h"
#include "skydrop/game/contact.h"
#include "skydrop/game/flight_assist.h"
#include "skydrop/game/world.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "skydrop/terrain/strips.h"

namespace skydrop::app {
namespace {

using core::StateHasher;
using game::Controls;

// What a player can see, hear or read of a moment; not the settings themselves.
void addMoment(StateHasher& h, const game::Snapshot& now) {
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
    if (step % 12 == 0) addMoment(h, world.now());
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
    game::WorldSetup setup = worldOf(settings, probedLand(), 400);
    setup.seed = seed;
    addMoment(h, game::World(setup).now());
  }
  return h.value();
}

std::uint64_t autopilot(const Settings& settings) {
  game::Autopilot pilot(probedLand(), settings.autopilot);
  return flight(worldOf(settings, probedLand(), 400), 30,
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
  game::WorldSetup setup = worldOf(settings, probedLand(), 400);
  setup.delivery = settings.delivery;
  StateHasher h;
  addMoment(h, game::World(setup).now());
  return h.value();
}

// A player who turns, and what is warned of over hills from higher and higher up.
std::uint64_t assisted(const Settings& settings) {
  game::FlightAssist assist;
  return flight(worldOf(settings, probedLand(), 400), 20, [&](const game::Snapshot& now) {
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
    craft.position = {300, game::surfaceAt(*probedLand(), {300, 0}).height + height, 0};
    const auto seconds = game::secondsToGround(*probedLand(), craft, settings.assist.warningSeconds);
    h.add(seconds.value_or(-1));
  }
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

// Hands off for ten seconds in that air.
std::uint64_t weatherFlight(const Settings& settings) {
  game::WorldSetup setup = worldOf(settings, probedLand(), 300);
  setup.weather = {settings.weather, settings.wind, nullptr};
  return flight(setup, 10, [](const game::Snapshot&) { return Controls(); });
}

// A package dropped at once, in that air.
std::uint64_t packagesInWeather(const Settings& settings) {
  game::WorldSetup setup = worldOf(settings, probedLand(), 300);
  setup.weather = {settings.weather, settings.wind, nullptr};
  Controls drop;
  drop.drop = true;
  return flight(setup, 10, [&](const game::Snapshot&) { return drop; });
}
}  // namespace

std::vector<Probe> flightProbes() {
  return {
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
      {"delivery.startFacesTarget", beginnings},
      {"delivery.", points},
      {"assist.terrainWarning", warnings},
      {"assist.warningSeconds", warnings},
      {"assist.", assisted},
      {"autopilot.landEvery", circuits},
      {"gear.mostSinkRate", sinkRates},
      {"gear.mostSideLoad", sideLoads},
      {"gear.mostSlopeDeg", slopes},
      {"gear.mostStrikeSpeed", wingsFirst},
      {"gear.mostWaterSink", waterSinks},
      {"gear.mostWaterSpeed", waterSpeeds},
      {"gear.floatSeconds", floats},
      {"gear.", taxi},
      {"autopilot.", autopilot, {"game.targetNearest=1200", "game.targetFarthest=1500"}},
  };
}

}  // namespace skydrop::app
