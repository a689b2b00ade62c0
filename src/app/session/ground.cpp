#include "app/session/ground.h"

#include "skydrop/elevation/elevation_height_source.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "skydrop/terrain/noise_height_source.h"
#include "skydrop/terrain/strips.h"

namespace skydrop::app {

std::shared_ptr<const terrain::HeightSource> makeGround(const scene::EffectSet& effects,
                                                        const Settings& settings,
                                                        const SimulationSetup& setup) {
  if (!effects.contains(scene::Effect::terrain)) return terrain::makeFlatSource(0);
  auto noise = terrain::makeNoiseHeightSource(settings.terrain, setup.seed);
  if (settings.strips.density > 0)
    noise = terrain::makeLandWithStrips(std::move(noise), settings.strips, setup.seed);
  if (setup.land.elevation.empty()) return noise;
  return elevation::makeElevationHeightSource(setup.land.elevation, settings.elevation, std::move(noise));
}

bool hasAlpineBelts(const terrain::HeightSource& ground) {
  return dynamic_cast<const elevation::ElevationHeightSource*>(&ground) != nullptr;
}

}  // namespace skydrop::app
