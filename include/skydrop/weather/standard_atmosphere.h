// The U.S. Standard Atmosphere 1976 (NOAA, NASA, USAF 1976), sections 1.2 and 1.3: temperature, pressure and
// density by height. Pure, any thread, the same bits on every machine.
#pragma once

namespace skydrop::weather {

struct Air {
  double temperatureK = 288.15;
  double pressurePa = 101325;
  double densityKgM3 = 1.225;
  double soundMps = 340.294;
};

inline constexpr double kSeaLevelDensity = 1.225;  // kg/m^3, at 15 degrees and 1013.25 hPa
inline constexpr double kStandardFromM = -5000;    // heights below are taken as this one
inline constexpr double kStandardToM = 86000;      // heights above: see standardAir

// Height in the field of gravity that decreases, m, of a geometric height above the sea, m.
double geopotentialHeight(double heightM);

// At a geometric height above the sea, m. From 5 km below the sea to 86 km by the standard; the molecular
// mass is that of the sea's level, also above 80 km (where the standard's falls by .04 %). Above the top it
// goes on at the top's temperature: finite and falling, but no longer the standard (at 100 km the density is
// 30 % off). NaN gives the sea's level.
Air standardAir(double heightM);

// The same where temperature (degrees Celsius) and pressure at the sea's level are others: the temperature is
// shifted by as much at all heights, the pressure scaled.
Air airAt(double heightM, double seaTemperatureC, double seaPressurePa);

}  // namespace skydrop::weather
