// What the weather costs a flight: the air that the aircraft meets in a simulated second.
#include <benchmark/benchmark.h>

#include <ctime>
#include <memory>

#include "bench/expectation.h"
#include "game/flown_air.h"
#include "skydrop/terrain/noise_height_source.h"
#include "support/shared_noise.h"

namespace skydrop {
namespace {

// 120 steps in a thunderstorm of two layers with an approaching site, over the shipped land: under 50
// microseconds.
void secondOfTheWeather(benchmark::State& state) {
  game::WorldSetup setup;
  setup.ground = terrain::makeNoiseHeightSource({}, 1);
  weather::WeatherSettings settings;
  settings.secondSite = true;
  settings.approachSeconds = 900;
  for (auto& site : settings.sites) {
    site.layers[0] = {weather::Genus::cumulonimbus, 1055, 11000, 0.5, 1};
    site.layers[1] = {weather::Genus::cirrostratus, 9500, 10500, 0.6, 1};
    site.rain = 18;
  }
  settings.sites[1].windDirection = 310;
  setup.weather = {settings, core::WindSettings(), test::sharedNoise()};
  game::FlownAir air(setup);
  flight::BodyState craft;
  craft.position = {0, 1400, 0};
  craft.velocity = {70, 0, 0};
  air.meet(craft.position, 100, 0);
  std::uint64_t step = 0;
  double seconds = 0;
  const std::clock_t from = std::clock();  // processor time: other programs do not count
  for (auto _ : state) {
    for (int i = 0; i < 120; ++i) {
      craft.position += craft.velocity / 120.0;
      air.advance(craft, 1300, ++step);
    }
    seconds += 1;
  }
  const double spent = static_cast<double>(std::clock() - from) / CLOCKS_PER_SEC;
  benchmark::DoNotOptimize(air.now());
  bench::expect(spent / seconds < 50e-6, "a simulated second of weather costs more than 50 microseconds");
}
BENCHMARK(secondOfTheWeather)->Unit(benchmark::kMicrosecond)->MinTime(1);

}  // namespace
}  // namespace skydrop
