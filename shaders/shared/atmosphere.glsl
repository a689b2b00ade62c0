// Sky light and haze from air molecules and aerosol, in closed form. Two layers of exponential density; flat
// earth but for the air mass; single scattering after Chandrasekhar ("Radiative Transfer", 1950, chapter I: the
// plane-parallel layer) and multiple scattering as an isotropic share of it. Light is linear RGB; radiance per
// irradiance of the sun outside the atmosphere, so the unit is the sun's.
//
// Everything that is known about this atmosphere is here: coefficients and functions. C++ uses it through
// include/skydrop/sky/atmosphere.h, shaders through shaders/sky/atmosphere.glsl; nothing else
// calls it, but for the phase function of Henyey and Greenstein, which clouds share.
#ifndef __cplusplus
#include "shared/guards.glsl"
#endif

CONST Real kPi = Real(3.14159265358979);

// Illuminance by the sun above the atmosphere on a surface that faces it, klx: 1361 W/m^2 at 94 lm/W, a little warmer
// than sRGB's white (about 5800 K against 6500 K).
CONST Vec3 kSunIlluminance = Real(128.0) * Vec3(Real(1.04), Real(0.99), Real(0.95));

// Angular radius of the sun's disc, rad: 0.267 degrees, the mean over the year.
CONST Real kSunRadius = Real(0.00466);

// Radiance of the night sky without sun and moon, kcd/m^2: airglow and starlight, 2e-4 cd/m^2 at a dark place (Leinert and
// others 1998).
CONST Vec3 kNightRadiance = Real(2.3e-7) * Vec3(Real(0.75), Real(0.9), Real(1.2));

// Rayleigh scattering at sea level for sRGB's primaries, 1/m, and its scale height, m (Bruneton 2017 after Penndorf
// 1957).
CONST Vec3 kRayleigh = Vec3(Real(5.802e-6), Real(13.558e-6), Real(33.1e-6));
CONST Real kRayleighHeight = Real(8000.0);

// Single-scattering albedo of continental aerosol (Shettle and Fenn 1979: 0.9 to 0.96).
CONST Real kHazeAlbedo = Real(0.94);

// Absorption in the middle of the ozone layer, 1/m: a vertical optical depth of kOzoneDepth in a tent of 15 km to each
// side (shared/atmosphere_shell.glsl).
CONST Vec3 kOzoneDepth = Vec3(Real(0.0240), Real(0.0295), Real(0.0015));
CONST Vec3 kOzone = kOzoneDepth / Real(15000.0);

// Albedo of average land and sea, [0, 1], for light from below.
CONST Real kGroundAlbedo = Real(0.12);

struct Atmosphere {
  Vec3 rayleigh;        // scattering coefficient of air at sea level, 1/m, [0, 1e-3]
  Real rayleighHeight;  // scale height of air, m, > 0
  Real haze;            // extinction coefficient of aerosol at sea level, 1/m, [0, 1]
  Real hazeHeight;      // scale height of aerosol, m, > 0
  Real hazeAlbedo;      // share of the aerosol's extinction that is scattering, [0, 1]
  Real hazeAnisotropy;  // g of its phase function, [-0.95, 0.95]
  Vec3 ozone;           // absorption in the middle of the ozone layer, 1/m, [0, 1e-4]; the closed form has its own
};

// Air in which contrast at sea level falls to 2 % over the visibility (m, > 0): 3.912 extinction lengths (Koschmieder
// 1924). What clean air does not extinguish (green, where the eye judges) is aerosol, of a scale height (m, > 0) and an
// anisotropy [-0.95, 0.95].
FN Atmosphere make_atmosphere(Real visibilityM, Real hazeHeightM, Real hazeAnisotropy) {
  Atmosphere air;
  air.rayleigh = kRayleigh;
  air.rayleighHeight = kRayleighHeight;
  air.haze = max(Real(3.912) / visibilityM - kRayleigh.y, Real(0.0));
  air.hazeHeight = hazeHeightM;
  air.hazeAlbedo = kHazeAlbedo;
  air.hazeAnisotropy = hazeAnisotropy;
  air.ozone = kOzone;
  return air;
}

// All that skySource needs and that is the same for every direction: the air above the eye and the light on it.
struct SkyColumn {
  Vec3 depth;      // optical depth of everything above the eye
  Real sunMass;    // air mass towards the sun
  Vec3 airHere;    // scattering of air at the eye, 1/m
  Real hazeHere;   // extinction of haze at the eye, 1/m
  Vec3 airLight;   // sunlight on the air above, per irradiance: ozone, the earth's shadow
  Vec3 hazeLight;  // the same for haze, times its albedo
  Vec3 overhead;   // radiance of the sky overhead, scattered once, mean over all directions of the sun
};

// What one sky direction scatters towards the eye. Radiance = sun's irradiance *
// (rayleigh * rayleighPhase + haze * henyeyGreenstein + isotropic).
struct SkySource {
  Vec3 rayleigh;
  Vec3 haze;
  Vec3 isotropic;
};

// Light scattered more than once, as a share of that scattered once, without direction: grows with the optical depth
// above (blue light goes round more often, a hazy sky is whiter), up to this share in a thick layer.
CONST Real kMultipleScattering = Real(2.5);

// Air along the line of sight is lit by the sky overhead too, as many times as brightly as the zenith alone would. With
// a low sun that light is blue, while what reaches the horizon from the sun has lost its blue: it makes the low evening
// sky orange and pink instead of yellow, and keeps haze over dusky land cool.
CONST Real kSkylightScattering = Real(1.6);

// Path through the whole atmosphere against the vertical one, by the cosine of the zenith angle: 1 at the zenith, 40
// at the horizon and below (Rozenberg, "Twilight", 1966).
FN Real airMass(Real cosZenith) {
  Real c = clamp(cosZenith, Real(0.0), Real(1.0));
  return Real(1.0) / (c + Real(0.025) * exp(Real(-11.0) * c));
}

FN Real densityAt(Real heightM, Real scaleHeightM) { return exp(-max(heightM, Real(0.0)) / scaleHeightM); }

// Optical depth of everything above a height, straight up.
FN Vec3 opticalDepthAbove(Atmosphere air, Real heightM) {
  Real haze = air.haze * air.hazeHeight * densityAt(heightM, air.hazeHeight);
  return air.rayleigh * (air.rayleighHeight * densityAt(heightM, air.rayleighHeight)) + Vec3(haze, haze, haze);
}

FN Vec3 exp3(Vec3 v) { return Vec3(exp(v.x), exp(v.y), exp(v.z)); }

// What ozone, far above all else, leaves of the sun's light. Low light crosses a thin shell 25 km up at a slant, and
// from below the horizon it runs along it; ozone takes orange and green, so the evening sky overhead stays blue, which
// scattering alone would leave grey (Hulburt 1953). Vertical optical depth of 340 Dobson units at sRGB's primaries.
FN Vec3 ozoneTransmittance(Real cosZenith) {
  Real c = max(cosZenith, Real(0.0));
  Real path = Real(1.0) / sqrt(c * c + Real(0.00785)) + Real(250.0) * clamp(-cosZenith, Real(0.0), Real(0.08));
  return exp3(-kOzoneDepth * path);
}

// Of sunlight from above the atmosphere down to a height.
FN Vec3 sunTransmittance(Atmosphere air, Real heightM, Real cosZenith) {
  return exp3(-opticalDepthAbove(air, heightM) * airMass(cosZenith)) * ozoneTransmittance(cosZenith);
}

// Share of the sun's disc above the horizon, [0, 1]: 0 and 1 one radius below and above it.
FN Real sunVisibleShare(Real cosZenith) {
  Real t = saturate((cosZenith + kSunRadius) / (Real(2.0) * kSunRadius));
  return t * t * (Real(3.0) - Real(2.0) * t);
}

// Illuminance by the sun at a height, klx, on a surface that faces it; 0 with the sun below the horizon.
FN Vec3 sunIlluminanceAt(Atmosphere air, Real heightM, Real cosZenith) {
  return kSunIlluminance * sunTransmittance(air, heightM, cosZenith) * sunVisibleShare(cosZenith);
}

// With the sun below the horizon the earth's shadow hides the air below R (1 / cos(depression) - 1): what is
// left of the scattering is the share of the air above. 1 while the sun is up.
FN Real twilight(Real cosSunZenith, Real scaleHeightM) {
  if (cosSunZenith >= Real(0.0)) return Real(1.0);
  Real cosDepression = squareRoot(Real(1.0) - cosSunZenith * cosSunZenith);
  // 1 / cos - 1, written so that nothing cancels in the first degrees.
  Real cosClamped = max(cosDepression, Real(0.01));
  Real shadow = Real(6.371e6) * cosSunZenith * cosSunZenith / (cosClamped * (Real(1.0) + cosDepression));
  return exp(-shadow / scaleHeightM);
}

// Rayleigh's phase function: 1/sr, integral 1 over the sphere.
FN Real rayleighPhase(Real cosAngle) { return Real(3.0) / (Real(16.0) * kPi) * (Real(1.0) + cosAngle * cosAngle); }

// Henyey and Greenstein (1941): 1/sr, integral 1 over the sphere. g is clamped to +-0.95; the denominator is a sum of
// what is not negative, so nothing cancels at the peak, be it forwards or backwards.
FN Real henyeyGreenstein(Real cosAngle, Real g) {
  Real a = clamp(g, Real(-0.95), Real(0.95));
  Real size = abs(a);
  Real toPeak = clamp(a < Real(0.0) ? -cosAngle : cosAngle, Real(-1.0), Real(1.0));
  Real base = (Real(1.0) - size) * (Real(1.0) - size) + Real(2.0) * size * (Real(1.0) - toPeak);
  return (Real(1.0) - a * a) / (Real(4.0) * kPi * base * sqrt(base));
}

// The air above an eye at a height, with the sun at a zenith angle.
FN SkyColumn make_skyColumn(Atmosphere air, Real heightM, Real cosSun) {
  SkyColumn column;
  column.depth = opticalDepthAbove(air, heightM);
  column.sunMass = airMass(cosSun);
  column.airHere = air.rayleigh * densityAt(heightM, air.rayleighHeight);
  column.hazeHere = air.haze * densityAt(heightM, air.hazeHeight);
  Vec3 light = ozoneTransmittance(cosSun);
  column.airLight = light * twilight(cosSun, air.rayleighHeight);
  column.hazeLight = light * (air.hazeAlbedo * twilight(cosSun, air.hazeHeight));
  // As skySource has it for the zenith, but for the phase functions.
  Vec3 once = column.depth * exp3(-column.depth) * oneMinusExpOverX3(column.depth * (column.sunMass - Real(1.0)));
  column.overhead = once * column.airLight * (Real(1.0) / (Real(4.0) * kPi));
  return column;
}

// The sky in a direction whose zenith angle has the given cosine (below the horizon: as at the horizon).
FN SkySource skySource(SkyColumn column, Atmosphere air, Real cosView) {
  Real eyeMass = airMass(cosView);
  Real sunMass = column.sunMass;
  // Light scattered once at each depth: the integral of exp(-t * sunMass) exp(-t * eyeMass), written so that equal air
  // masses are no special case and no exponent is positive.
  Vec3 once = column.depth * eyeMass * exp3(-column.depth * (eyeMass < sunMass ? eyeMass : sunMass)) *
              oneMinusExpOverX3(column.depth * abs(eyeMass - sunMass));
  // Which of the two scattered it: what lies within one optical depth (of green) of the eye. Overhead that is the whole
  // column, at the horizon the air at the eye's height.
  Real rise = max(cosView, Real(0.0)) / (column.airHere.y + column.hazeHere + Real(1e-12));
  Vec3 byAir = column.airHere * oneMinusExpOverX(rise / air.rayleighHeight);
  Real byHaze = column.hazeHere * oneMinusExpOverX(rise / air.hazeHeight);
  once = once / (byAir + Vec3(byHaze, byHaze, byHaze) + Vec3(Real(1e-20), Real(1e-20), Real(1e-20)));
  Vec3 again = column.depth / (column.depth + Vec3(Real(1.0), Real(1.0), Real(1.0)));
  SkySource source;
  source.rayleigh = once * byAir * column.airLight;
  source.haze = once * byHaze * column.hazeLight;
  source.isotropic = (source.rayleigh + source.haze) * again * (kMultipleScattering / (Real(4.0) * kPi)) +
                     (Vec3(Real(1.0), Real(1.0), Real(1.0)) - exp3(-column.depth * eyeMass)) * column.overhead *
                         kSkylightScattering;
  return source;
}

FN Vec3 skyRadiance(SkySource source, Real cosSunAngle, Real hazeAnisotropy) {
  return source.rayleigh * rayleighPhase(cosSunAngle) + source.haze * henyeyGreenstein(cosSunAngle, hazeAnisotropy) +
         source.isotropic;
}

// Optical depth of a straight path of a length between two heights. Exact for exponential density; horizontal
// paths are no special case.
FN Vec3 opticalDepthBetween(Atmosphere air, Real heightA, Real heightB, Real lengthM) {
  Real low = max(heightA < heightB ? heightA : heightB, Real(0.0));
  Real rise = abs(max(heightA, Real(0.0)) - max(heightB, Real(0.0)));
  Real air1 = densityAt(low, air.rayleighHeight) * oneMinusExpOverX(rise / air.rayleighHeight) * lengthM;
  Real haze1 = air.haze * densityAt(low, air.hazeHeight) * oneMinusExpOverX(rise / air.hazeHeight) * lengthM;
  return air.rayleigh * air1 + Vec3(haze1, haze1, haze1);
}

// Of light along such a path.
FN Vec3 transmittanceBetween(Atmosphere air, Real heightA, Real heightB, Real lengthM) {
  return exp3(-opticalDepthBetween(air, heightA, heightB, lengthM));
}

// Of light from outside the atmosphere to the eye, from a direction; below the horizon as at the horizon.
FN Vec3 skyTransmittance(SkyColumn column, Real cosView) { return exp3(-column.depth * airMass(cosView)); }
