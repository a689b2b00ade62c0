// How far the air bends light upwards near the horizon, at sea level, 1010 hPa and 10 degrees Celsius. Pure
// functions, from any thread; the same bits on every machine. Degrees.
#pragma once

#include "skydrop/sky/almanac.h"

namespace skydrop::sky {

// What is added to a geometric elevation, [-90, 90], to see where it appears: 0.48 at the horizon, 0 at
// zenith and nadir. Saemundsson's formula (1986; Meeus, chapter 16), within 0.1 minutes of arc of Bennett's
// (1982) above the horizon. Below -1 nobody can see and no formula holds: it goes to 0 at the nadir in
// proportion, so that appearances neither jump nor overtake each other.
double refraction(double geometricElevationDegrees);

// Where a thing at this geometric place appears.
Horizontal refracted(const Horizontal& geometric);

// The geometric elevation of what appears at this one: the inverse, to 1e-10.
double geometricElevation(double apparentElevationDegrees);

}  // namespace skydrop::sky
