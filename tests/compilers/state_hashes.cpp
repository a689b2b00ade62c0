// Prints a digest of what each part of the program works out, a line each ("flight 0123456789abcdef"), so
// that builds by different compilers and runs on different processors can be compared: check.sh beside this
// file does. Every digest covers the bits, not rounded values.
//
//   state_hashes [--kernels baseline|sse41|avx2|avx512] [--workers N] [--elevation FILE.tif] [PART...]
//
// Exit code 3: the processor lacks the kernels that are asked for.
#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "noise/noise_rows.h"
#include "skydrop/clouds/clear_air.h"
#include "skydrop/clouds/light_volume.h"
#include "skydrop/clouds/occupancy.h"
#include "skydrop/core/deterministic_math.h"
#include "skydrop/core/error.h"
#include "skydrop/core/hash.h"
#include "skydrop/core/instruction_set.h"
#include "skydrop/elevation/elevation_height_source.h"
#include "skydrop/elevation/raster.h"
#include "skydrop/flight/integrator.h"
#include "skydrop/game/autopilot.h"
#include "skydrop/game/world.h"
#include "skydrop/noise/noise_generator.h"
#include "skydrop/sky/almanac.h"
#include "skydrop/sky/atmosphere.h"
#include "skydrop/sky/sky_view.h"
#include "skydrop/terrain/chunk_data.h"
#include "skydrop/terrain/noise_height_source.h"
#include "skydrop/weather/dryden.h"
#include "skydrop/weather/standard_atmosphere.h"
#include "skydrop/weather/wind_profile.h"
#include "support/cloud_noise.h"
#include "terrain/noise_source.h"
#include "terrain/row_kernels.h"

namespace {

using namespace skydrop;
using core::StateHasher;

struct Options {
  core::InstructionSet kernels = core::InstructionSet::avx512;  // the widest that there is
  bool isForced = false;
  int workers = 1;
  std::string elevation;
};

void addBits(StateHasher& hasher, float value) {
  hasher.add(std::uint64_t{std::bit_cast<std::uint32_t>(value)});
}

void addVector(StateHasher& hasher, const glm::dvec3& v) {
  for (const double c : {v.x, v.y, v.z}) hasher.add(c);
}

std::shared_ptr<const terrain::HeightSource> landOf(const Options& options) {
  if (!options.isForced) return terrain::makeNoiseHeightSource({}, 1);
  return terrain::makeNoiseHeightSource({}, 1, *terrain::rowKernels(options.kernels));
}

std::uint64_t chunkHash(const terrain::HeightSource& land, const terrain::ChunkKey& key) {
  const terrain::ChunkData chunk = makeChunk(land, key);
  StateHasher hasher;
  for (const std::uint16_t code : chunk.heights) hasher.add(std::uint64_t{code});
  for (const std::uint16_t code : chunk.normals) hasher.add(std::uint64_t{code});
  return hasher.value();
}

// Results are put in the order of their numbers, whoever works them out.
std::uint64_t byWorkers(std::size_t count, int workers,
                        const std::function<std::uint64_t(std::size_t)>& hash) {
  std::vector<std::uint64_t> hashes(count);
  std::atomic<std::size_t> next{0};
  {
    std::vector<std::jthread> threads;
    for (int w = 0; w < workers; ++w) {
      threads.emplace_back([&] {
        for (std::size_t i = next++; i < count; i = next++) hashes[i] = hash(i);
      });
    }
  }
  StateHasher all;
  for (const std::uint64_t one : hashes) all.add(one);
  return all.value();
}

std::uint64_t mathHash(const Options&) {
  StateHasher hasher;
  core::RandomStream random{7, 0};
  for (int i = 0; i < 20000; ++i) {
    const double x = (random.nextUnit() - 0.5) * 40, share = random.nextUnit();
    for (const double y : {core::dmath::sin(x), core::dmath::cos(x), core::dmath::tan(x), core::dmath::exp(x),
                           core::dmath::log(share), core::dmath::atan2(x, share), core::dmath::asin(share),
                           core::dmath::acos(share), core::dmath::pow(share, x)})
      hasher.add(y);
  }
  return hasher.value();
}

std::uint64_t terrainHash(const Options& options) {
  const auto land = landOf(options);
  return byWorkers(24, options.workers, [&](std::size_t i) {
    const auto n = static_cast<std::int64_t>(i);
    return chunkHash(*land,
                     {n % 6 - 3 + (i % 7 == 0 ? std::int64_t{1} << 33 : 0), n / 6 - 2, i % 5 == 0 ? 4 : 0});
  });
}

std::uint64_t noiseHash(const Options& options) {
  const noise::NoiseSettings settings;
  const noise::OctaveKernels& kernels =
      options.isForced ? *noise::octaveKernels(options.kernels) : noise::bestOctaveKernels();
  const noise::NoiseRows plane(settings, {256, 256, 0}, kernels), volume(settings, {64, 64, 8}, kernels);
  return byWorkers(12, options.workers, [&](std::size_t i) {
    const bool isPlane = i < 4;
    std::vector<float> values(isPlane ? 256 * 64 : 64 * 64);
    if (isPlane) {
      plane.fill(0, static_cast<int>(i) * 64, values);
    } else {
      volume.fill(static_cast<int>(i) - 4, 0, values);
    }
    StateHasher hasher;
    for (const float value : values) addBits(hasher, value);
    return hasher.value();
  });
}

// Tumbling without torque by each integrator, in which rounding grows fastest.
std::uint64_t bodyHash(const Options&) {
  const flight::MassProperties body{1, glm::dmat3(10, 0, 0, 0, 20, 0, 0, 0, 26),
                                    glm::dmat3(0.1, 0, 0, 0, 0.05, 0, 0, 0, 1 / 26.0)};
  StateHasher hasher;
  for (const flight::Integrator integrator :
       {flight::Integrator::thesis, flight::Integrator::semiImplicitEuler, flight::Integrator::rk4,
        flight::Integrator::rkmk4}) {
    flight::BodyState state;
    state.angularVelocity = {1, 15, 1};
    const auto spring = [](const flight::BodyState& s) { return flight::Wrench{-40.0 * s.position, {}}; };
    state.position = {1, 2, 3};
    for (int i = 0; i < 2000; ++i) state = integrate(integrator, state, body, spring, 1.0 / 120, i / 120.0);
    addVector(hasher, state.position);
    addVector(hasher, state.angularVelocity);
    for (const double x :
         {state.orientation.w, state.orientation.x, state.orientation.y, state.orientation.z})
      hasher.add(x);
  }
  return hasher.value();
}

// Windy, wet and cloudy, with a second site that comes nearer.
weather::WeatherSettings roughWeather() {
  weather::WeatherSettings s;
  s.secondSite = true;
  s.approachSeconds = 300;
  s.variability = 1;
  s.wanderSeconds = 60;
  s.sites[0].layers[0] = {weather::Genus::cumulonimbus, 600, 9000, 0.8, 1};
  s.sites[0].rain = 10;
  s.sites[0].gust = 10;
  s.sites[0].severity = 4;
  s.sites[0].temperature = -4;
  s.sites[1] = s.sites[0];
  s.sites[1].eastM = 5000;
  s.sites[1].windDirection = 20;
  s.sites[1].windSpeed = 15;
  return s;
}

// Flown by the autopilot, which drops at targets; a digest every simulated second.
std::uint64_t flownHash(const Options& options, bool hasWeather) {
  game::WorldSetup setup;
  setup.ground = landOf(options);
  if (hasWeather) setup.weather = {roughWeather(), core::WindSettings(), test::quickNoise()};
  game::World world(setup);
  game::Autopilot pilot(setup.ground);
  StateHasher hasher;
  for (int i = 0; i < 120 * 60; ++i) {
    world.step(pilot.decide(world.now()));
    if (world.stepCount() % 120 == 0) hasher.add(world.stateHash());
  }
  return hasher.value();
}

// Where each target lies, by a pilot who drops as often as he may, and where the drops land.
std::uint64_t targetsHash(const Options& options) {
  game::WorldSetup setup;
  setup.ground = landOf(options);
  setup.seed = 11;
  game::World world(setup);
  StateHasher hasher;
  for (int i = 0; i < 120 * 30; ++i) {
    world.step({.thrust = 1, .drop = i % 200 == 0});
    const game::Snapshot& now = world.now();
    hasher.add(now.target.distance);
    addVector(hasher, now.target.position);
    for (const game::PackageSnapshot& package : now.packages) addVector(hasher, package.position);
  }
  return hasher.value();
}

std::uint64_t weatherHash(const Options&) {
  const weather::WeatherSettings settings = roughWeather();
  StateHasher hasher;
  for (int i = 0; i < 400; ++i) {
    const weather::State state = weather::stateAt(settings, 3, 1.7 * i, {311.0 * i, -97.0 * i});
    for (const double x : {state.wind.speedMps, state.wind.directionDeg, state.wind.gustMps,
                           state.temperatureC, state.pressurePa, state.visibilityM, state.layers[0].cover,
                           state.layers[0].baseM, state.precipitation.rain, state.lightningPerMinute})
      hasher.add(x);
    addVector(hasher, weather::WindProfile(state.wind).at(40.0 * i, 40.0 * i - 100));
    const weather::DrydenScales scales = weather::drydenScales(10.0 * i, 12, 4);
    addVector(hasher, scales.intensityMps);
    const weather::Air air = weather::airAt(90.0 * i, state.temperatureC, state.pressurePa);
    hasher.add(air.densityKgM3);
  }
  return hasher.value();
}

std::uint64_t elevationHash(const Options& options) {
  const auto land =
      elevation::makeElevationHeightSource({elevation::openRaster(options.elevation)}, {}, landOf(options));
  return byWorkers(10, options.workers, [&](std::size_t i) {
    const auto n = static_cast<std::int64_t>(i);
    if (i < 2) return chunkHash(*land, {n * 20, n, static_cast<std::int32_t>(3 * i)});
    StateHasher hasher;
    core::RandomStream random{i, 0};
    for (int k = 0; k < 300; ++k) {
      const terrain::HeightSample s =
          land->sample({(random.nextUnit() - 0.5) * 120000, (random.nextUnit() - 0.5) * 120000});
      for (const double x : {s.height, s.gradient.x, s.gradient.y}) hasher.add(x);
    }
    return hasher.value();
  });
}

std::uint64_t almanacHash(const Options&) {
  StateHasher hasher;
  for (int i = 0; i < 500; ++i) {
    const sky::Place place{-85 + 0.35 * i, 0.7 * i};
    const double days = 9000 + 1.37 * i;
    for (const sky::Body& body : {sky::sunAt(days, place), sky::moonAt(days, place)}) {
      for (const double x :
           {body.horizontal.azimuthDegrees, body.horizontal.elevationDegrees, body.distanceKm})
        hasher.add(x);
    }
  }
  return hasher.value();
}

std::uint64_t skyHash(const Options&) {
  const sky::AirTables tables(sky::makeAtmosphere(30000, 1200, 0.76));
  StateHasher hasher;
  for (const double heightM : {2.0, 3000.0, 11000.0}) {
    for (const double cosine : {0.7, 0.05, -0.08}) {
      const sky::SkyView view = makeSkyView(tables, heightM, cosine);
      for (const glm::vec4& texel : view.texels) {
        for (int c = 0; c < 3; ++c) addBits(hasher, texel[c]);
      }
    }
  }
  return hasher.value();
}

std::uint64_t cloudNoiseHash(const Options&) {
  const auto noise = test::quickNoise();
  StateHasher hasher;
  for (const float value : noise->base) addBits(hasher, value);
  for (const glm::vec3& texel : noise->weather) addBits(hasher, texel.x + texel.y * 2 + texel.z * 4);
  return hasher.value();
}

std::uint64_t cloudDensityHash(const Options&) {
  const clouds::CloudField field(test::quickNoise(), test::cloudySettings());
  StateHasher hasher;
  core::RandomStream random{5, 0};
  for (int i = 0; i < 50000; ++i) {
    const glm::dvec3 place{(random.nextUnit() - 0.5) * 2e6, 1500 + 2000 * random.nextUnit(),
                           (random.nextUnit() - 0.5) * 2e6};
    hasher.add(field.density(place));
    addBits(hasher, field.densityInFloat(place));
  }
  return hasher.value();
}

std::uint64_t occupancyHash(const Options&) {
  const clouds::Occupancy occupancy(*test::quickNoise(), test::cloudySettings());
  StateHasher hasher;
  for (const std::uint8_t distance : occupancy.distances()) hasher.add(std::uint64_t{distance});
  return hasher.value();
}

std::uint64_t clearAirHash(const Options&) {
  const clouds::ClearAir air = clouds::measureClearAir(test::quickNoise(), test::cloudySettings());
  StateHasher hasher;
  for (const double x : {air.leastShape, air.slopeM, air.evenWear}) hasher.add(x);
  return hasher.value();
}

std::uint64_t lightVolumeHash(const Options&) {
  const clouds::LightVolume volume(clouds::CloudField(test::quickNoise(), test::cloudySettings()),
                                   {0.8, 0.6, 0});
  StateHasher hasher;
  for (const clouds::LightVolume::Texel& texel : volume.texels()) {
    for (const float x : {texel.sun, texel.sky}) addBits(hasher, x);
  }
  return hasher.value();
}

struct Part {
  const char* name;
  std::uint64_t (*hash)(const Options&);
};

constexpr Part kParts[] = {
    {"math", mathHash},
    {"terrain", terrainHash},
    {"noise", noiseHash},
    {"body", bodyHash},
    {"flight", [](const Options& o) { return flownHash(o, false); }},
    {"flightInWeather", [](const Options& o) { return flownHash(o, true); }},
    {"targets", targetsHash},
    {"weather", weatherHash},
    {"elevation", elevationHash},
    {"almanac", almanacHash},
    {"sky", skyHash},
    {"cloudNoise", cloudNoiseHash},
    {"cloudDensity", cloudDensityHash},
    {"occupancy", occupancyHash},
    {"clearAir", clearAirHash},
    {"lightVolume", lightVolumeHash},
};

}  // namespace

int main(int argc, char** argv) {
  Options options;
  std::vector<std::string> wanted;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool hasValue = i + 1 < argc;
    if (word == "--workers" && hasValue) {
      options.workers = std::max(std::atoi(argv[++i]), 1);
    } else if (word == "--elevation" && hasValue) {
      options.elevation = argv[++i];
    } else if (word == "--kernels" && hasValue) {
      const std::string name = argv[++i];
      const char* const names[] = {"baseline", "sse41", "avx2", "avx512"};
      const auto* const found = std::find(std::begin(names), std::end(names), name);
      if (found == std::end(names))
        return std::fprintf(stderr, "state_hashes: no kernels %s\n", name.c_str()), 2;
      options.kernels = core::kInstructionSets[static_cast<std::size_t>(found - names)];
      options.isForced = true;
    } else {
      wanted.push_back(word);
    }
  }
  if (options.isForced && terrain::rowKernels(options.kernels) == nullptr) return 3;
  try {
    for (const Part& part : kParts) {
      if (!wanted.empty() && std::ranges::find(wanted, part.name) == wanted.end()) continue;
      if (std::string(part.name) == "elevation" && options.elevation.empty()) continue;
      std::printf("%s %016llx\n", part.name, static_cast<unsigned long long>(part.hash(options)));
      std::fflush(stdout);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "state_hashes: %s\n", error.what());
    return 1;
  }
}
