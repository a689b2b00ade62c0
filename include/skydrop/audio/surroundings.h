// What is heard of a place: birds where woods are near, and the sea. Main thread.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "skydrop/terrain/height_source.h"

namespace skydrop::audio {

// Loudness, [0, 1].
struct Surroundings {
  double birds = 0;
  double water = 0;
};

// birds: by the share of woods within 120 m (terrain::forestShare), by day (the sun's elevation, degrees) and
// without gales; they sing near the ground and are hardly heard above 150 m. water: surf where land and sea
// meet within 200 m, waves of the open sea by the wind, from below about 200 m. windMps: mean, near the
// ground. alpineBelts: as of terrain::Woods. An ear that is not finite hears nothing. 25 heights are asked
// for.
Surroundings surroundingsAt(const terrain::HeightSource& ground, bool alpineBelts, const glm::dvec3& ear,
                            double sunElevationDegrees, double windMps);

// The same four times a second of simulated time, and in between what was last.
class SurroundingsEar {
 public:
  Surroundings at(const terrain::HeightSource& ground, bool alpineBelts, const glm::dvec3& ear,
                  double sunElevationDegrees, double windMps, double simulatedSeconds);

 private:
  std::optional<double> asked_;  // the quarter of a second
  Surroundings last_;
};

}  // namespace skydrop::audio
